// SPDX-License-Identifier: MIT
#include "coupler_lib/base/config_node.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <toml++/toml.h>

namespace base {
namespace {

std::string place(const toml::source_region& region, const std::string& file)
{
    return text(file, ":", region.begin.line, ":", region.begin.column);
}

ConfigNode from_toml(const toml::node& node, const std::string& file)
{
    ConfigNode result;
    result.where = place(node.source(), file);
    if (const auto* table = node.as_table()) {
        ConfigNode::Table children;
        for (const auto& [key, child] : *table) {
            children.emplace_back(std::string(key.str()), from_toml(child, file));
            if (!child.is_table() && !child.is_array()) children.back().second.where = place(key.source(), file);
        }
        result.value = std::move(children);
    } else if (const auto* array = node.as_array()) {
        ConfigNode::Array items;
        for (const auto& child : *array) items.push_back(from_toml(child, file));
        result.value = std::move(items);
    } else if (const auto* flag = node.as_boolean()) {
        result.value = flag->get();
    } else if (const auto* integer = node.as_integer()) {
        result.value = integer->get();
    } else if (const auto* number = node.as_floating_point()) {
        result.value = number->get();
    } else if (const auto* string = node.as_string()) {
        result.value = string->get();
    } else {
        throw Error(ExitCode::bad_input, result.where + ": dates are not used here");
    }
    return result;
}

toml::table parse_toml(const std::string& toml_text, const std::string& file)
{
    try {
        return toml::parse(toml_text, file);
    } catch (const toml::parse_error& error) {
        throw Error(ExitCode::bad_input, text(place(error.source(), file), ": not TOML: ", error.description()));
    }
}

ConfigNode parse_override(const std::string& key, const std::string& value_text)
{
    ConfigNode node;
    try {
        const toml::table table = toml::parse("v = " + value_text);
        node = from_toml(*table.get("v"), "--set");
    } catch (const toml::parse_error&) {
        node.value = value_text;
    }
    node.where = "--set " + key + "=" + value_text;
    return node;
}

}  // namespace

bool ConfigNode::is_array_of_tables() const
{
    if (!is_array()) return false;
    const auto& items = std::get<Array>(value);
    return !items.empty() && std::all_of(items.begin(), items.end(), [](const auto& item) { return item.is_table(); });
}

const ConfigNode* ConfigNode::find(const std::string& key) const
{
    if (!is_table()) return nullptr;
    for (const auto& [name, child] : std::get<Table>(value))
        if (name == key) return &child;
    return nullptr;
}

ConfigNode* ConfigNode::find(const std::string& key)
{
    return const_cast<ConfigNode*>(static_cast<const ConfigNode*>(this)->find(key));
}

std::string ConfigNode::kind() const
{
    static const char* names[] = {"nothing", "true/false", "an integer", "a number", "a string", "an array", "a table"};
    return names[value.index()];
}

void fail_conversion(const ConfigNode& node, const std::string& key, const std::string& wanted)
{
    throw Error(ExitCode::bad_input, text(node.where, ": '", key, "' wants ", wanted, ", not ", node.kind()));
}

void convert(const ConfigNode& node, const std::string& key, double& out)
{
    if (const auto* number = std::get_if<double>(&node.value)) {
        out = *number;
    } else if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
        out = static_cast<double>(*integer);
    } else {
        fail_conversion(node, key, "a number");
    }
    require_input(out == out, node.where, ": '", key, "' is not a number (nan)");
}

void convert(const ConfigNode& node, const std::string& key, int& out)
{
    const auto* integer = std::get_if<std::int64_t>(&node.value);
    if (!integer) fail_conversion(node, key, "an integer");
    require_input(std::abs(*integer) <= std::numeric_limits<int>::max(), node.where, ": '", key, "' = ", *integer,
                  " is too large");
    out = static_cast<int>(*integer);
}

void convert(const ConfigNode& node, const std::string& key, bool& out)
{
    const auto* flag = std::get_if<bool>(&node.value);
    if (!flag) fail_conversion(node, key, "true or false");
    out = *flag;
}

void convert(const ConfigNode& node, const std::string& key, std::string& out)
{
    const auto* string = std::get_if<std::string>(&node.value);
    if (!string) fail_conversion(node, key, "a string in quotes");
    out = *string;
}

ConfigDocument ConfigDocument::parse(const std::string& toml_text, const std::string& file_name)
{
    ConfigDocument document;
    document.file_name_ = file_name;
    document.root_ = from_toml(parse_toml(toml_text, file_name), file_name);
    return document;
}

ConfigDocument ConfigDocument::load(const std::string& path)
{
    std::ifstream file(path);
    require_input(file.good(), "cannot read the file '", path, "'; is the path right?");
    std::ostringstream content;
    content << file.rdbuf();
    return parse(content.str(), path);
}

void ConfigDocument::override_key(const std::string& dotted_key, const std::string& value_text)
{
    ConfigNode leaf = parse_override(dotted_key, value_text);
    std::istringstream parts(dotted_key);
    ConfigNode* node = &root_;
    for (std::string part; std::getline(parts, part, '.');) {
        require_input(!part.empty(), "--set ", dotted_key, ": a key is empty");
        if (node->is_array()) {
            auto& items = std::get<ConfigNode::Array>(node->value);
            const bool is_number = part.find_first_not_of("0123456789") == std::string::npos;
            require_input(is_number && std::stoul(part) < items.size(), "--set ", dotted_key, ": '", part,
                          "' is not an index below ", items.size());
            node = &items[std::stoul(part)];
            continue;
        }
        require_input(node->is_table(), "--set ", dotted_key, ": '", part, "' lies below ", node->kind());
        if (!node->find(part)) {
            ConfigNode empty{ConfigNode::Table{}, leaf.where};
            std::get<ConfigNode::Table>(node->value).emplace_back(part, empty);
        }
        node = node->find(part);
    }
    *node = std::move(leaf);
}

}  // namespace base
