// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"
#include "coupler_lib/fake/fake_config.hpp"

#include <functional>

namespace coupler {

/// Measures the fake fluid's loads on the facets of a batch over one step, as a real fluid would: at the middle of the
/// step, with the walls moved there by X + V s + A s^2/2. 2D.
///
///     f_a = -n L (p_a/3 + p_b/6),  f_b likewise     (pressure linear along the segment)
///
/// Conservative corner forces and averaged sums (weight = length) are both filled.
class FacetPressure {
public:
    FacetPressure(const FakeFluidStepConfig& fluid, const PressureConfig& law) : fluid_(fluid), law_(law) {}

    /// \param time  start of the step [s] \param dt  its length, 0: the load at this instant [s]
    /// \param mine  which facets (by id) this rank loads
    /// Throws base::Error(numerical_failure), naming the facet, when the pressure is not a number.
    void measure(const FacetBatch& facets, double time, double dt, const std::function<bool(std::int64_t)>& mine);

    const FacetLoads& loads() const { return loads_; }
    /// Work of the last loads on the walls over their step, my facets [J/m].
    const base::ReproducibleSum& work() const { return work_; }
    /// Work of the last loads over the jump from where the walls were predicted to where the new motion puts them. The
    /// facets must be the same.
    base::ReproducibleSum jump_work(const FacetBatch& corrected) const { return work_from(predicted_, corrected); }
    /// Work of the last loads from where the step began to where the new motion puts the walls.
    base::ReproducibleSum path_work(const FacetBatch& corrected) const { return work_from(start_, corrected); }
    /// Force (x, y) and moment (z) of the last loads, my facets.
    std::vector<base::ReproducibleSum> resultants(const FacetBatch& facets) const;

private:
    base::ReproducibleSum work_from(const std::vector<double>& position, const FacetBatch& corrected) const;
    void add_facet(const FacetBatch& facets, std::size_t facet, double middle);

    FakeFluidStepConfig fluid_;
    PressureConfig law_;
    FacetLoads loads_;
    std::vector<double> position_, velocity_; ///< of the nodes at the middle of the step
    std::vector<double> start_, predicted_;   ///< at its start and end
    double dt_ = 0;
    base::ReproducibleSum work_;
};

} // namespace coupler
