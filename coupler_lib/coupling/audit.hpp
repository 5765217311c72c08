// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"

#include <string>
#include <vector>

namespace coupler {

/// Compares what crossed the interface as each side sees it: the content of interface.csv. Reads and writes nothing.
///
///     W_fluid  = -(work_on_solid + jump_work)           work on the fluid, by the fluid's own account [J]
///     W_solid  = SolidReport::work                      work on the solid, by the solid's account [J]
///     W_lag    = W_solid - FluidReport::path_work       because the solid got each load late, and averaged or predicted [J]
///     mismatch = |W_fluid + W_solid| / max over time of max(|W_fluid|, |W_solid|)     [-]
///
/// Works are cumulated since the start; both reports of a row belong to the same instant.
class InterfaceAudit {
public:
    explicit InterfaceAudit(int dimension) : dimension_(dimension) {}

    /// Takes in one exchange.
    void record(const Window& window, const FluidReport& fluid, const SolidReport& solid);

    /// Names with units, "per metre of depth" in 2D.
    std::vector<std::string> columns() const;
    /// Values of the last `record`, in the order of `columns`.
    std::vector<double> row() const;

    double work_on_fluid() const { return work_on_fluid_; } ///< [J]
    double work_on_solid() const { return work_on_solid_; } ///< [J]
    double peak_work() const { return peak_work_; }         ///< largest |W| of either side so far [J]
    double mismatch() const { return mismatch_; }           ///< now, relative to the largest |W| so far [-]
    /// Largest |W_fluid + W_solid| of the whole run over the largest |W| of the whole run [-]
    double worst_mismatch() const;

private:
    int dimension_;
    Window window_;
    FluidReport fluid_;
    SolidReport solid_;
    double work_on_fluid_ = 0, work_on_solid_ = 0, peak_work_ = 0, mismatch_ = 0, worst_gap_ = 0;
};

} // namespace coupler
