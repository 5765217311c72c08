// SPDX-License-Identifier: MIT
#include "fem_solver/interface/fluid_link.hpp"

namespace fem {

FluidLink::FluidLink(coupler::Participant& participant, const coupler::InterfaceSettings& settings,
                     const WetBoundary& boundary, int acceleration_steps)
    : boundary_(&boundary), interface_(participant, settings, boundary.surface()), filter_(acceleration_steps)
{}

coupler::Window FluidLink::receive() { return interface_.receive(load_, fluid_); }

void FluidLink::send(double time, const Motion& motion, coupler::SolidReport report)
{
    coupler::SurfaceMotion surface = boundary_->motion(motion);
    filter_.apply(time, surface);
    report.wait = interface_.wait_seconds();
    interface_.send(surface, report);
}

} // namespace fem
