// SPDX-License-Identifier: MIT
#include "coupler_lib/session/data_flow.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <fmt/format.h>
#include <map>
#include <sstream>

namespace coupler {
namespace {

const std::string first_line = "rivage data flow 2";

/// The single numbers of a flow under their keys.
std::map<std::string, double DataFlow::*> numbers()
{
    return {{"end", &DataFlow::end},
            {"dt", &DataFlow::dt},
            {"impedance", &DataFlow::impedance},
            {"density", &DataFlow::density},
            {"wave_speed", &DataFlow::wave_speed},
            {"thickness", &DataFlow::thickness}};
}

void read_entry(DataFlow& flow, const std::string& key, std::istringstream& words)
{
    const auto known = numbers();
    const auto number = known.find(key);
    if (number != known.end()) {
        words >> flow.*(number->second);
    } else if (key == "role") {
        words >> flow.role;
    } else if (key == "dimension") {
        words >> flow.dimension;
    } else if (key == "produces" || key == "consumes") {
        FieldUse use{"", "", key == "produces", ""};
        words >> use.name >> use.unit >> use.partner;
        flow.fields.push_back(use);
    } else if (key == "group") {
        int facets = 0;
        std::string name;
        words >> facets;
        std::getline(words >> std::ws, name);
        flow.groups.emplace_back(name, facets);
    } else {
        words.setstate(std::ios::failbit);
    }
}

} // namespace

std::string to_text(const DataFlow& flow)
{
    std::string text = fmt::format("{}\nrole {}\ndimension {}\n", first_line, flow.role, flow.dimension);
    for (const auto& field : flow.fields)
        text += fmt::format("{} {} {} {}\n", field.produced ? "produces" : "consumes", field.name, field.unit,
                            field.partner);
    for (const auto& [name, facets] : flow.groups) text += fmt::format("group {} {}\n", facets, name);
    for (const auto& [key, member] : numbers()) text += fmt::format("{} {:.17g}\n", key, flow.*member);
    return text;
}

DataFlow data_flow_from(const std::string& text)
{
    const std::size_t start = text.find(first_line);
    base::require_input(start != std::string::npos, "a participant's description does not begin with '", first_line,
                        "': is it a program of this version of Rivage?");
    std::istringstream lines(text.substr(start + first_line.size() + 1));
    DataFlow flow;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string key;
        words >> key;
        read_entry(flow, key, words);
        base::require_input(!words.fail(), "a participant's description holds the line '", line,
                            "', which cannot be understood: is it a program of this version of Rivage?");
    }
    return flow;
}

std::vector<FieldUse> interface_fields(int dimension, const InterfaceConfig& interface, const std::string& role)
{
    const bool of_fluid = role == interface.fluid;
    const std::string& partner = of_fluid ? interface.solid : interface.fluid;
    std::vector<FieldUse> fields;
    if (interface.load_kind() == LoadKind::averaged)
        fields.push_back({"pressure", "Pa", of_fluid, partner});
    else
        fields.push_back({"force", dimension == 2 ? "N/m" : "N", of_fluid, partner});
    fields.push_back({"impedance", "kg/(m^2*s)", of_fluid, partner});
    fields.push_back({"position", "m", !of_fluid, partner});
    fields.push_back({"velocity", "m/s", !of_fluid, partner});
    fields.push_back({"acceleration", "m/s^2", !of_fluid, partner});
    return fields;
}

} // namespace coupler
