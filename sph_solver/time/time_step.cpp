// SPDX-License-Identifier: MIT
#include "sph_solver/time/time_step.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>

namespace sph {

TimeStep::TimeStep(const TimeStepSettings& settings) : settings_(settings)
{
    base::require_input(settings.cfl > 0 && settings.smoothing_length > 0 && settings.sound_speed > 0,
                        "the time step needs positive cfl, smoothing length and sound speed, not ", settings.cfl, ", ",
                        settings.smoothing_length, " m, ", settings.sound_speed, " m/s");
}

template<int D> double TimeStep::next(const Particles<D>& particles, const base::Communicator& comm)
{
    if (used_ == 0) dt_ = choose(particles, comm);
    used_ = (used_ + 1) % settings_.steps_of_one_length;
    return dt_;
}

template<int D> double TimeStep::choose(const Particles<D>& particles, const base::Communicator& comm)
{
    double largest = 0.0;
    for (const int i : particles.owned) largest = std::max(largest, particles.sound_speed[static_cast<std::size_t>(i)]);
    largest = comm.max(largest);
    if (settings_.fixed_dt > 0.0) return settings_.fixed_dt;
    return on_ladder(largest > 0.0 ? largest : settings_.sound_speed);
}

double TimeStep::on_ladder(double largest_sound_speed)
{
    constexpr double rungs_per_octave = 8.0;
    const double wanted = rungs_per_octave * std::log2(settings_.sound_speed / largest_sound_speed);
    if (std::abs(wanted - rung_) > 0.75) rung_ = static_cast<int>(std::lround(wanted));
    const double foot = settings_.cfl * settings_.smoothing_length / settings_.sound_speed;
    const double h = settings_.smoothing_length;
    const double viscous = settings_.viscosity > 0.0 ? 0.125 * h * h / settings_.viscosity : HUGE_VAL;
    return std::min(foot * std::exp2(rung_ / rungs_per_octave), viscous);
}

template double TimeStep::next<2>(const Particles<2>&, const base::Communicator&);
template double TimeStep::next<3>(const Particles<3>&, const base::Communicator&);

} // namespace sph
