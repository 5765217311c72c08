// SPDX-License-Identifier: MIT
#include "coupler_lib/base/config.hpp"

#include "coupler_lib/foundation/nearest_name.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace base {

ConfigReader ConfigReader::describe()
{
    ConfigReader reader{ConfigDocument::parse("", "")};
    reader.describing_ = true;
    return reader;
}

const ConfigNode* ConfigReader::node_at(const std::string& path) const
{
    const ConfigNode* node = &document_.root();
    std::istringstream parts(path);
    for (std::string part; node && std::getline(parts, part, '.');) node = node->find(part);
    return node;
}

std::string ConfigReader::where(const std::string& path) const
{
    const ConfigNode* node = node_at(path);
    return node ? node->where : document_.file_name() + ": [" + path + "]";
}

std::vector<const ConfigNode*> ConfigReader::elements_at(const std::string& path)
{
    known_paths_.insert(path);
    std::vector<const ConfigNode*> elements;
    const ConfigNode* node = node_at(path);
    if (!node) return elements;
    const bool is_empty = node->is_array() && std::get<ConfigNode::Array>(node->value).empty();
    require_input(node->is_array_of_tables() || is_empty, node->where, ": '", path, "' wants tables, each headed [[", path,
                  "]], not ", node->kind());
    claimed_.insert(node);
    for (const auto& item : std::get<ConfigNode::Array>(node->value)) elements.push_back(&item);
    return elements;
}

std::vector<std::string> ConfigReader::names_at(const std::string& path)
{
    known_paths_.insert(path);
    std::vector<std::string> names;
    const ConfigNode* node = node_at(path);
    if (!node) return names;
    require_input(node->is_table(), node->where, ": '", path, "' wants tables [", path, ".NAME], not ", node->kind());
    claimed_.insert(node);
    for (const auto& [name, child] : std::get<ConfigNode::Table>(node->value)) {
        known_keys_.emplace(node, name);
        names.push_back(name);
    }
    return names;
}

namespace {

/// "; is 'spacin' meant?" when a table lacks `key` but holds a name near it that no key has; else empty.
std::string near_miss(const ConfigNode& table, const std::string& key, const std::vector<ConfigKey>& keys)
{
    std::vector<std::string> strangers;
    for (const auto& [name, child] : std::get<ConfigNode::Table>(table.value)) {
        const auto same = [&name](const ConfigKey& known) { return known.name == name; };
        if (std::none_of(keys.begin(), keys.end(), same)) strangers.push_back(name);
    }
    const std::string near = nearest_name(key, strangers);
    return near.empty() ? "" : "; is '" + near + "' meant?";
}

std::string missing(const ConfigKey& key, const std::string& path)
{
    const std::string unit = key.info.unit.empty() ? "" : " [" + key.info.unit + "]";
    return text(": '", key.name, "' is missing in [", path, "]: ", key.info.doc, unit);
}

}  // namespace

void ConfigReader::read_table(const std::string& path, const ConfigNode* node, const std::string& doc,
                              const std::vector<ConfigKey>& keys, void* object)
{
    known_paths_.insert(path);
    require_input(!node || node->is_table(), node ? node->where : "", ": '", path, "' must be a table [", path, "]");
    if (describing_) {
        record(path, doc, keys, object);
        return;
    }
    if (node) {
        fill(path, *node, keys, object);
    } else {
        for (const auto& key : keys)
            require_input(!key.info.required, document_.file_name(), missing(key, path));
    }
    record(path, doc, keys, object);
}

void ConfigReader::fill(const std::string& path, const ConfigNode& node, const std::vector<ConfigKey>& keys, void* object)
{
    claimed_.insert(&node);
    for (const auto& key : keys) {
        const ConfigNode* child = node.find(key.name);
        known_keys_.emplace(&node, key.name);
        require_input(child || !key.info.required, node.where, missing(key, path),
                      child ? "" : near_miss(node, key.name, keys));
        if (!child) continue;
        claimed_.insert(child);
        if (key.inner.empty()) {
            key.set(object, *child);
            continue;
        }
        require_input(child->is_table(), child->where, ": '", key.name, "' wants a table {...}, not ", child->kind());
        fill(path + "." + key.name, *child, key.inner, key.part(object));
    }
}

void ConfigReader::record(const std::string& path, const std::string& doc, const std::vector<ConfigKey>& keys,
                          const void* object)
{
    const std::string header = path.empty() ? "" : "[" + path + "]";
    used_ += header + "\n";
    help_ += fmt::format("{}  # {}\n", header, doc);
    for (const auto& key : keys) {
        const std::string unit = key.info.unit.empty() ? "" : " [" + key.info.unit + "]";
        used_ += fmt::format("{} = {}{}\n", key.name, key.print(object), unit.empty() ? "" : "  #" + unit);
        describe_key(key, object, "  ");
    }
    used_ += "\n";
    help_ += "\n";
}

void ConfigReader::describe_key(const ConfigKey& key, const void* object, const std::string& indent)
{
    const std::string unit = key.info.unit.empty() ? "" : " [" + key.info.unit + "]";
    const std::string range = key.range_text();
    const std::string start = key.inner.empty() ? ", default " + key.default_text(object) : "";
    help_ += fmt::format("{}{:<24} {}{}{}{}\n{}    {}\n", indent, key.name, key.type, unit, start,
                         range.empty() ? "" : ", " + range, indent, key.info.doc);
    if (key.inner.empty()) return;
    const void* part = key.part(const_cast<void*>(object));
    for (const auto& inner : key.inner) describe_key(inner, part, indent + "    ");
}

void ConfigReader::finish() const { check_claimed(document_.root(), ""); }

void ConfigReader::check_claimed(const ConfigNode& table, const std::string& path) const
{
    for (const auto& [name, child] : std::get<ConfigNode::Table>(table.value)) {
        const std::string child_path = path.empty() ? name : path + "." + name;
        const bool is_group = child.is_table() || child.is_array_of_tables();
        bool inside_known = claimed_.contains(&child);
        for (const auto& known : known_paths_) inside_known |= is_group && known.rfind(child_path + ".", 0) == 0;
        if (!inside_known) {
            std::vector<std::string> known;
            for (const auto& [owner, key] : known_keys_)
                if (owner == &table) known.push_back(key);
            const std::string prefix = path.empty() ? "" : path + ".";
            for (const auto& other : known_paths_) {
                const std::string bare = other.rfind("[", 0) == 0 ? other.substr(1, other.size() - 2) : other;
                if (bare.rfind(prefix, 0) == 0 && bare.size() > prefix.size()) known.push_back(bare.substr(prefix.size()));
            }
            throw Error(ExitCode::bad_input, text(child.where, ": unknown ", is_group ? "table" : "key", " '", child_path, "'",
                                                  suggestion(name, known)));
        }
        if (child.is_table()) check_claimed(child, child_path);
        if (child.is_array_of_tables())
            for (const auto& item : std::get<ConfigNode::Array>(child.value)) check_claimed(item, child_path);
    }
}

}  // namespace base
