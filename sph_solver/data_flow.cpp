// SPDX-License-Identifier: MIT
#include "sph_solver/data_flow.hpp"

namespace sph {

coupler::DataFlow data_flow(const FluidConfig& config, const coupler::Session& session)
{
    coupler::DataFlow flow;
    const double speed = config.liquid.sound_speed;
    flow.dimension = config.domain.dimension;
    for (const auto& interface : session.coupling().interfaces_of(session.role()))
        for (const auto& field : coupler::interface_fields(flow.dimension, interface, session.role()))
            flow.fields.push_back(field);
    flow.end = config.time.end;
    flow.dt = config.time.fixed_dt > 0 ? config.time.fixed_dt
                                       : config.time.cfl * config.resolution.smoothing_length() / speed;
    flow.impedance = config.liquid.density * speed;
    return flow;
}

} // namespace sph
