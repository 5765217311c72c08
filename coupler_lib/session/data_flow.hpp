// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace coupler {

/// A quantity that crosses the interface, as one side sees it.
struct FieldUse {
    std::string name; ///< "force"
    std::string unit; ///< "N/m"
    bool produced;    ///< false: consumed
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

/// What both sides of an interface exchange in Rivage: the load one way, the motion the other.
/// \param load  "conservative" or "averaged"  \param of_fluid  as the fluid sees it; else as the solid does
std::vector<FieldUse> interface_fields(int dimension, const std::string& load, bool of_fluid);

} // namespace coupler
