// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace base {

/// One value of a configuration file with the place it was written at: a scalar, an array or a table.
struct ConfigNode {
    using Table = std::vector<std::pair<std::string, ConfigNode>>;
    using Array = std::vector<ConfigNode>;

    std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Table> value;
    std::string where;  ///< "file:line:column" or "--set key=value"

    bool is_table() const { return std::holds_alternative<Table>(value); }
    bool is_array() const { return std::holds_alternative<Array>(value); }
    bool is_array_of_tables() const;
    /// The child of a table, or nullptr.
    const ConfigNode* find(const std::string& key) const;
    ConfigNode* find(const std::string& key);
    /// What the value is, in words: "a string", "an integer" ...
    std::string kind() const;
};

// Conversions to the types a configuration struct may have; each throws Error(bad_input) naming the place.
void convert(const ConfigNode& node, const std::string& key, double& out);
void convert(const ConfigNode& node, const std::string& key, int& out);
void convert(const ConfigNode& node, const std::string& key, bool& out);
void convert(const ConfigNode& node, const std::string& key, std::string& out);

template <class T>
void convert(const ConfigNode& node, const std::string& key, std::vector<T>& out);

[[noreturn]] void fail_conversion(const ConfigNode& node, const std::string& key, const std::string& wanted);

template <class T>
void convert(const ConfigNode& node, const std::string& key, std::vector<T>& out)
{
    if (!node.is_array()) fail_conversion(node, key, "an array [...]");
    out.clear();
    for (const auto& item : std::get<ConfigNode::Array>(node.value)) {
        T converted{};
        convert(item, key, converted);
        out.push_back(std::move(converted));
    }
}

/// A configuration file as read, with overrides laid over it.
class ConfigDocument {
public:
    /// Reads a file. Throws Error(bad_input) with the place when it is missing or not TOML.
    static ConfigDocument load(const std::string& path);
    static ConfigDocument parse(const std::string& toml_text, const std::string& file_name);

    /// Sets the value at a dotted key ("resolution.spacing", "walls.0.name"); the text is read as a TOML value,
    /// and as a plain string when it is none. Tables that do not exist are made (the reader judges them later).
    void override_key(const std::string& dotted_key, const std::string& value_text);

    const ConfigNode& root() const { return root_; }
    const std::string& file_name() const { return file_name_; }

private:
    ConfigNode root_;
    std::string file_name_;
};

}  // namespace base
