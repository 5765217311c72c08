// SPDX-License-Identifier: MIT
#include "sph_solver/time/stage_update.hpp"

namespace sph {

template<int D> void StageUpdate<D>::start(const Particles<D>& particles)
{
    start_.resize(particles.owned.size());
    change_.clear();
    for (std::size_t k = 0; k < start_.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        start_[k] = {particles.position[i], particles.momentum[i], particles.volume[i], particles.mass[i]};
    }
}

template<int D>
void StageUpdate<D>::apply(Particles<D>& particles, const Stage& stage, const Rates<D>& rates, double dt)
{
    const bool last = stage.next == 0.0, counts = stage.weight != 0.0;
    const double share = stage.weight * dt, ahead = stage.next * dt;
    if (counts && !last && change_.empty()) change_.assign(start_.size(), no_change);
    for (std::size_t k = 0; k < start_.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        Conserved change = change_.empty() ? no_change : change_[k];
        const Vec<D> motion = particle_velocity(particles, i);
        change.position += share * motion;
        change.momentum += share * rates.momentum[i];
        change.volume += share * rates.volume[i];
        change.mass += share * rates.mass[i];
        const Conserved& y = start_[k];
        particles.position[i] = y.position + (last ? change.position : ahead * motion);
        particles.momentum[i] = y.momentum + (last ? change.momentum : ahead * rates.momentum[i]);
        particles.volume[i] = y.volume + (last ? change.volume : ahead * rates.volume[i]);
        particles.mass[i] = y.mass + (last ? change.mass : ahead * rates.mass[i]);
        if (counts && !last) change_[k] = change;
    }
}

template class StageUpdate<2>;
template class StageUpdate<3>;

} // namespace sph
