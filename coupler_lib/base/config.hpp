// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/config_table.hpp"

#include <memory>
#include <set>
#include <utility>

namespace base {

/// Fills structs from a configuration document, table by table, and keeps account of what was used.
///
/// A key that no table claims is an error of finish(), with file, line, column and the nearest known key.
class ConfigReader {
public:
    explicit ConfigReader(ConfigDocument document) : document_(std::move(document)) {}
    /// A reader without a document: every table comes back with its defaults and is only recorded, for help().
    static ConfigReader describe();

    bool has(const std::string& path) const { return node_at(path) != nullptr; }
    bool describing() const { return describing_; }
    const std::string& file_name() const { return document_.file_name(); }
    /// "file:line:column" of a table or key, for errors that a reader of the values finds.
    std::string where(const std::string& path) const;

    /// The table [path]; absent: its defaults, or an error when it has a required key. Path "" is the root.
    template<class T> T table(const std::string& path, const Table<T>& description)
    {
        T object{};
        read_table(path, node_at(path), description.doc(), description.keys(), &object);
        return object;
    }

    /// The array of tables [[path]], possibly empty.
    template<class T> std::vector<T> tables(const std::string& path, const Table<T>& description)
    {
        std::vector<T> objects;
        for (const ConfigNode* node : elements_at(path)) {
            T object{};
            read_table("[" + path + "]", node, description.doc(), description.keys(), &object);
            objects.push_back(std::move(object));
        }
        if (describing_) table("[" + path + "]", description);
        return objects;
    }

    /// The table [path] (absent: its defaults), or each of the tables [[path]].
    template<class T> std::vector<T> one_or_more(const std::string& path, const Table<T>& description)
    {
        const ConfigNode* node = node_at(path);
        if (node && node->is_array()) return tables(path, description);
        return {table(path, description)};
    }

    /// The tables [path.NAME] with their names, in the order of the file.
    template<class T>
    std::vector<std::pair<std::string, T>> named_tables(const std::string& path, const Table<T>& description)
    {
        std::vector<std::pair<std::string, T>> objects;
        for (const std::string& name : names_at(path))
            objects.emplace_back(name, table(path + "." + name, description));
        if (describing_) table(path + ".NAME", description);
        return objects;
    }

    /// Throws Error(bad_input) for the first key that no table claimed.
    void finish() const;

    /// All tables read, defaults filled in, as TOML.
    const std::string& used() const { return used_; }
    /// All tables with type, unit, default, range and meaning of every key.
    const std::string& help() const { return help_; }

private:
    const ConfigNode* node_at(const std::string& path) const;
    std::vector<const ConfigNode*> elements_at(const std::string& path);
    std::vector<std::string> names_at(const std::string& path);
    void read_table(const std::string& path, const ConfigNode* node, const std::string& doc,
                    const std::vector<ConfigKey>& keys, void* object);
    void fill(const std::string& path, const ConfigNode& node, const std::vector<ConfigKey>& keys, void* object);
    void describe_key(const ConfigKey& key, const void* object, const std::string& indent);
    void record(const std::string& path, const std::string& doc, const std::vector<ConfigKey>& keys,
                const void* object);
    void check_claimed(const ConfigNode& table, const std::string& path) const;

    ConfigDocument document_;
    bool describing_ = false;
    std::set<const ConfigNode*> claimed_;
    std::set<std::pair<const ConfigNode*, std::string>> known_keys_; ///< (table, key) pairs that exist in the language
    std::set<std::string> known_paths_;
    std::string used_, help_;
};

} // namespace base
