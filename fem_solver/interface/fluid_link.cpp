// SPDX-License-Identifier: MIT
#include "fem_solver/interface/fluid_link.hpp"

namespace fem {

FluidLink::FluidLink(coupler::Participant& participant, const coupler::InterfaceSettings& settings,
                     const WetBoundary& boundary, int acceleration_steps)
    : boundary_(&boundary), interface_(participant, settings, boundary.surface()), filter_(acceleration_steps)
{}

coupler::Window FluidLink::receive()
{
    const coupler::Window window = interface_.receive(received_, fluid_);
    load_ = boundary_->complete(received_);
    return window;
}

void FluidLink::send(double time, const Motion& motion, coupler::SolidReport report)
{
    coupler::SurfaceMotion surface = boundary_->motion(motion);
    filter_.apply(time, surface);
    report.wait = interface_.wait_seconds();
    interface_.send(surface, report);
}

} // namespace fem
