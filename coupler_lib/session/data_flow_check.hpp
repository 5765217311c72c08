// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/session/coupling_config.hpp"
#include "coupler_lib/session/data_flow.hpp"

#include <string>
#include <vector>

namespace coupler {

/// What came of comparing the participants.
struct FlowReport {
    std::vector<std::string> facts;    ///< what was found, a line each
    std::vector<std::string> advice;   ///< what would be better
    std::vector<std::string> problems; ///< what must be mended before a run
};

/// Compares what the participants tell about themselves: every field produced is consumed and the other way round, in
/// the same unit; dimensions agree; every surface has facets; end times and steps; stability of the exchange.
///
/// \param sides  those that could be asked; fields are compared between fluids and solids only when both are there
FlowReport check_data_flow(const CouplingConfig& config, const std::vector<DataFlow>& sides);

/// Stability number of the exchange (docs/theory/coupling.md):
///
///     beta = rho c dt / m      m = rho_s min(thickness, c_s dt): the solid's mass per area that answers in one step
///
/// 0 when a side does not know its numbers.
double stability_number(const DataFlow& fluid, const DataFlow& solid);

} // namespace coupler
