// SPDX-License-Identifier: MIT
#include "coupler_lib/base/json.hpp"

#include <cmath>
#include <cstdio>

namespace base {
namespace {

std::string quoted(const std::string& value)
{
    std::string result = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", c);
            result += code;
        } else {
            result += c;
        }
    }
    return result + "\"";
}

}  // namespace

JsonObject::Entry& JsonObject::entry(const std::string& key)
{
    for (auto& existing : entries_)
        if (existing.key == key) return existing = Entry{key, {}, {}};
    entries_.push_back({key, {}, {}});
    return entries_.back();
}

JsonObject& JsonObject::set(const std::string& key, const std::string& value)
{
    entry(key).literal = quoted(value);
    return *this;
}

JsonObject& JsonObject::set(const std::string& key, double value)
{
    char number[32];
    std::snprintf(number, sizeof number, "%.13g", value);
    entry(key).literal = std::isfinite(value) ? number : "null";
    return *this;
}

JsonObject& JsonObject::set(const std::string& key, std::int64_t value)
{
    entry(key).literal = std::to_string(value);
    return *this;
}

JsonObject& JsonObject::set(const std::string& key, bool value)
{
    entry(key).literal = value ? "true" : "false";
    return *this;
}

JsonObject& JsonObject::set(const std::string& key, const JsonObject& value)
{
    entry(key).child = {value};
    return *this;
}

std::string JsonObject::text(int level) const
{
    const std::string indent(static_cast<std::size_t>(2 * level + 2), ' ');
    std::string result = "{";
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        const auto& item = entries_[k];
        result += (k ? ",\n" : "\n") + indent + quoted(item.key) + ": ";
        result += item.child.empty() ? item.literal : item.child.front().text(level + 1);
    }
    return result + "\n" + std::string(static_cast<std::size_t>(2 * level), ' ') + "}";
}

}  // namespace base
