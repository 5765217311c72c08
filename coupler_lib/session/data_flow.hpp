// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/session/coupling_config.hpp"

#include <string>
#include <utility>
#include <vector>

namespace coupler {

/// A quantity that crosses the interface, as one side sees it.
struct FieldUse {
    std::string name;    ///< "force"
    std::string unit;    ///< "N/m"
    bool produced;       ///< false: consumed
    std::string partner; ///< role on the other side
};

/// What a participant tells about itself before a run: all that the check of a coupled case wants to know, in words that
/// no side needs to look up in the other's files.
struct DataFlow {
    std::string role;
    int dimension = 0;
    std::vector<FieldUse> fields;
    std::vector<std::pair<std::string, int>> groups; ///< surfaces it brings, with their number of facets
    double end = 0;                                  ///< [s] in its own file; 0: none
    double dt = 0;                                   ///< [s] fluid: of the first step; solid: in its own file, 0: none
    double impedance = 0;                            ///< fluid: rho c [kg/(m^2 s)]
    double density = 0;                              ///< solid [kg/m^3]
    double wave_speed = 0;                           ///< solid: of compression waves [m/s]
    double thickness = 0;                            ///< solid: smallest side of the box around it [m]
};

/// One line an entry, "key value ...".
std::string to_text(const DataFlow& flow);
/// Throws base::Error(bad_input) on a text that is none.
DataFlow data_flow_from(const std::string& text);

/// What both sides of an interface exchange in Rivage, the load one way and the motion the other, as `role` sees it.
std::vector<FieldUse> interface_fields(int dimension, const InterfaceConfig& interface, const std::string& role);

} // namespace coupler
