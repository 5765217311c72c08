// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/interface/interface_loads.hpp"
#include "sph_solver/time/evaluation.hpp"

#include <algorithm>

namespace sph {

/// Measures the loads on the solids, their mean over the steps from one exchange to the next, which are all of one length, and
/// the work done on each.
template<int D> class LoadObserver : public StageObserver<D> {
public:
    /// \param steps from one exchange to the next
    LoadObserver(const WallSettings<D>& settings, bool averaged, int steps) : loads_(settings, averaged), steps_(steps)
    {}

    /// \param ends of the interfaces among the facets of the batch that the coming step uses: the last is their number
    void set_interfaces(std::vector<std::size_t> ends)
    {
        ends_ = std::move(ends);
        works_.resize(ends_.size());
    }

    void begin_step(const Particles<D>&, const Walls<D>& walls, double dt) override
    {
        const bool instant = dt == 0;
        if (instant || done_ == 0)
            loads_.begin(walls, ends_.back());
        else
            loads_.follow(walls);
        share_ = instant ? 1.0 : 1.0 / steps_;
        done_ = instant ? 0 : (done_ + 1) % steps_;
    }

    void observe(const Particles<D>& particles, const Walls<D>& walls, const Evaluation<D>& evaluation, double weight,
                 double dt) override
    {
        loads_.add(particles, walls, evaluation.wall_forces.on_wall, share_ * weight);
        add_works(walls, evaluation.wall_forces.on_wall, weight * dt);
    }

    /// Loads since the last exchange, or those of an evaluation without a step (begin_step with dt = 0, then observe with
    /// weight 1).
    const coupler::FacetLoads& loads() const { return loads_.loads(); }

    /// Done on the solid of an interface by this rank's particles since the start [J]: sum F . v_wall dt.
    const base::ReproducibleSum& work(std::size_t interface) const { return works_[interface]; }

private:
    void add_works(const Walls<D>& walls, const std::vector<Vec<D>>& on_wall, double duration)
    {
        const auto& planes = walls.contacts().planes;
        for (std::size_t p = 0; p < planes.size(); ++p) {
            if (!walls.facets().is_wet(planes[p].facet)) continue;
            const auto source = static_cast<std::size_t>(walls.facets()[planes[p].facet].source);
            const auto interface = std::ranges::upper_bound(ends_, source) - ends_.begin();
            works_[static_cast<std::size_t>(interface)].add(duration * on_wall[p].dot(planes[p].velocity));
        }
    }

    InterfaceLoads<D> loads_;
    std::vector<std::size_t> ends_;
    std::vector<base::ReproducibleSum> works_; ///< by interface
    int steps_, done_ = 0;                     // in the present window
    double share_ = 1;
};

} // namespace sph
