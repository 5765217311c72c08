// SPDX-License-Identifier: MIT
#include "coupler_lib/base/config_table.hpp"

#include "coupler_lib/foundation/nearest_name.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace base {

std::string to_toml(double value)
{
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    const std::string digits = fmt::format("{}", value);
    return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
}

std::string to_toml(int value) { return std::to_string(value); }
std::string to_toml(bool value) { return value ? "true" : "false"; }

std::string to_toml(const std::string& value)
{
    std::string quoted = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"";
}

std::string inline_table(const std::vector<ConfigKey>& keys, const void* object)
{
    std::string result = "{";
    for (const auto& key : keys) result += (result.size() > 1 ? ", " : "") + key.name + " = " + key.print(object);
    return result + "}";
}

std::string ConfigKey::range_text() const
{
    if (!info.choices.empty()) {
        std::string list;
        for (const auto& choice : info.choices) list += (list.empty() ? "" : " | ") + choice;
        return list;
    }
    if (info.positive) return std::isinf(info.max) ? "> 0" : fmt::format("> 0, <= {}", info.max);
    if (std::isinf(info.min) && std::isinf(info.max)) return "";
    if (std::isinf(info.max)) return fmt::format(">= {}", info.min);
    if (std::isinf(info.min)) return fmt::format("<= {}", info.max);
    return fmt::format("{} ... {}", info.min, info.max);
}

void check_range(double value, const KeyInfo& info, const std::string& key, const std::string& where)
{
    require_input(!info.positive || value > 0, where, ": '", key, "' = ", value, " must be positive",
                  info.unit.empty() ? "" : " [" + info.unit + "]");
    require_input(value >= info.min && value <= info.max, where, ": '", key, "' = ", value, " lies outside ", info.min,
                  " ... ", info.max, info.unit.empty() ? "" : " [" + info.unit + "]");
}

void check_value(const std::string& value, const KeyInfo& info, const std::string& key, const std::string& where)
{
    const bool known = info.choices.empty() ||
                       std::find(info.choices.begin(), info.choices.end(), value) != info.choices.end();
    require_input(known, where, ": '", key, "' = \"", value, "\" is not one of its choices",
                  known ? "" : suggestion(value, info.choices));
}

}  // namespace base
