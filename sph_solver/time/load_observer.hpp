// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/interface/interface_loads.hpp"
#include "sph_solver/time/evaluation.hpp"

namespace sph {

/// Measures the loads on the solid: their mean over the steps from one exchange to the next, which are all of one length.
template<int D> class LoadObserver : public StageObserver<D> {
public:
    /// \param steps from one exchange to the next
    LoadObserver(const WallSettings<D>& settings, bool averaged, int steps) : loads_(settings, averaged), steps_(steps)
    {}

    /// Number of facets in the batch that the coming step uses.
    void set_facet_count(std::size_t count) { facet_count_ = count; }

    void begin_step(const Particles<D>&, const Walls<D>& walls, double dt) override
    {
        const bool instant = dt == 0;
        if (instant || done_ == 0)
            loads_.begin(walls, facet_count_);
        else
            loads_.follow(walls);
        share_ = instant ? 1.0 : 1.0 / steps_;
        done_ = instant ? 0 : (done_ + 1) % steps_;
    }

    void observe(const Particles<D>& particles, const Walls<D>& walls, const Evaluation<D>& evaluation, double weight,
                 double) override
    {
        loads_.add(particles, walls, evaluation.wall_forces.on_wall, share_ * weight);
    }

    /// Loads since the last exchange, or those of an evaluation without a step (begin_step with dt = 0, then observe with
    /// weight 1).
    const coupler::FacetLoads& loads() const { return loads_.loads(); }

private:
    InterfaceLoads<D> loads_;
    std::size_t facet_count_ = 0;
    int steps_, done_ = 0; // in the present window
    double share_ = 1;
};

} // namespace sph
