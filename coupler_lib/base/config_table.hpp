// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/config_node.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace base {

/// What a key of a configuration table means and may hold.
struct KeyInfo {
    std::string unit = {};
    std::string doc = {};
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool positive = false;  ///< strictly above zero
    bool required = false;
    std::vector<std::string> choices = {};
};

/// A key bound to a member of the struct that it fills.
struct ConfigKey {
    std::string name;
    KeyInfo info;
    std::string type;
    std::function<void(void* object, const ConfigNode&)> set;
    std::function<std::string(const void* object)> print;  ///< the value as TOML
    std::vector<ConfigKey> inner = {};                     ///< keys of a table within the table; empty for a value
    std::function<void*(void* object)> part = {};          ///< the struct that the inner keys fill

    std::string default_text(const void* object) const { return info.required ? "required" : print(object); }
    std::string range_text() const;
};

/// Keys and values as an inline table, {a = 1, b = 2}.
std::string inline_table(const std::vector<ConfigKey>& keys, const void* object);

// The value as TOML, and the type in words.
std::string to_toml(double value);
std::string to_toml(int value);
std::string to_toml(bool value);
std::string to_toml(const std::string& value);
template <class T>
std::string to_toml(const std::vector<T>& values)
{
    std::string result = "[";
    for (std::size_t k = 0; k < values.size(); ++k) result += (k ? ", " : "") + to_toml(static_cast<T>(values[k]));
    return result + "]";
}

inline std::string type_name(double) { return "number"; }
inline std::string type_name(int) { return "integer"; }
inline std::string type_name(bool) { return "true/false"; }
inline std::string type_name(const std::string&) { return "string"; }
template <class T>
std::string type_name(const std::vector<T>&)
{
    return "array of " + type_name(T{});
}

// Range and choice checks; each throws Error(bad_input) with the place, the value and what is allowed.
void check_range(double value, const KeyInfo& info, const std::string& key, const std::string& where);
inline void check_value(double value, const KeyInfo& info, const std::string& key, const std::string& where)
{
    check_range(value, info, key, where);
}
inline void check_value(int value, const KeyInfo& info, const std::string& key, const std::string& where)
{
    check_range(value, info, key, where);
}
inline void check_value(bool, const KeyInfo&, const std::string&, const std::string&) {}
void check_value(const std::string& value, const KeyInfo& info, const std::string& key, const std::string& where);
template <class T>
void check_value(const std::vector<T>& values, const KeyInfo& info, const std::string& key, const std::string& where)
{
    for (const auto& value : values) check_value(static_cast<T>(value), info, key, where);
}

/// The description of one table of a configuration file, beside the struct that it fills:
///
///     Table<ResolutionConfig>("particle size").key("spacing", &ResolutionConfig::spacing, {.unit = "m", ...})
template <class T>
class Table {
public:
    explicit Table(std::string doc) : doc_(std::move(doc)) {}

    template <class Member>
    Table& key(const std::string& name, Member T::*member, KeyInfo info)
    {
        ConfigKey key;
        key.name = name;
        key.type = type_name(Member{});
        key.set = [member, name, info](void* object, const ConfigNode& node) {
            Member value{};
            convert(node, name, value);
            check_value(value, info, name, node.where);
            static_cast<T*>(object)->*member = value;
        };
        key.print = [member](const void* object) { return to_toml(static_cast<const T*>(object)->*member); };
        key.info = std::move(info);
        keys_.push_back(std::move(key));
        return *this;
    }

    /// A table within the table, name = {a = ..., b = ...}. Absent, it keeps its defaults.
    template <class Member>
    Table& table(const std::string& name, Member T::*member, const Table<Member>& inner)
    {
        ConfigKey key;
        key.name = name;
        key.type = "table";
        key.info.doc = inner.doc();
        key.inner = inner.keys();
        key.part = [member](void* object) -> void* { return &(static_cast<T*>(object)->*member); };
        key.print = [member, keys = inner.keys()](const void* object) {
            return inline_table(keys, &(static_cast<const T*>(object)->*member));
        };
        keys_.push_back(std::move(key));
        return *this;
    }

    const std::string& doc() const { return doc_; }
    const std::vector<ConfigKey>& keys() const { return keys_; }

private:
    std::string doc_;
    std::vector<ConfigKey> keys_;
};

}  // namespace base
