// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/interface/interface_loads.hpp"
#include "sph_solver/time/evaluation.hpp"

namespace sph {

/// Measures the loads on the solid in every step.
template<int D> class LoadObserver : public StageObserver<D> {
public:
    LoadObserver(const WallSettings<D>& settings, bool averaged) : loads_(settings, averaged) {}

    /// Number of facets in the batch that the coming step uses.
    void set_facet_count(std::size_t count) { facet_count_ = count; }

    void begin_step(const Particles<D>&, const Walls<D>& walls, double) override { loads_.begin(walls, facet_count_); }

    void observe(const Particles<D>& particles, const Walls<D>& walls, const Evaluation<D>& evaluation, double weight,
                 double) override
    {
        loads_.add(particles, walls, evaluation.wall_forces.on_wall, weight);
    }

    /// Loads of the last step, or those of an evaluation without a step (begin_step, then observe with weight 1).
    const coupler::FacetLoads& loads() const { return loads_.loads(); }

private:
    InterfaceLoads<D> loads_;
    std::size_t facet_count_ = 0;
};

} // namespace sph
