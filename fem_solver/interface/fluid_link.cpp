// SPDX-License-Identifier: MIT
#include "fem_solver/interface/fluid_link.hpp"

namespace fem {

FluidLink::FluidLink(coupler::Participant& participant, const coupler::InterfaceSettings& settings,
                     const WetBoundary& boundary, int acceleration_steps,
                     std::unique_ptr<coupler::LoadPrediction> prediction)
    : boundary_(&boundary),
      interface_(participant, settings, boundary.surface()),
      filter_(acceleration_steps),
      prediction_(std::move(prediction))
{}

const coupler::SurfaceLoad& FluidLink::predict_load(const Motion& motion, double dt)
{
    prediction_->apply(load_, boundary_->gather(motion.velocity), dt);
    return load_;
}

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
