// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/acceleration_filter.hpp"
#include "coupler_lib/coupling/load_prediction.hpp"
#include "coupler_lib/coupling/solid_interface.hpp"
#include "fem_solver/interface/wet_boundary.hpp"

namespace fem {

/// The solid's conversation with the fluid: load in, motion out, once a window.
class FluidLink {
public:
    /// \param acceleration_steps steps that the wall acceleration sent to the fluid is averaged over; 0: nodal values.
    /// \param prediction what is made of the loads before each step
    FluidLink(coupler::Participant& participant, const coupler::InterfaceSettings& settings,
              const WetBoundary& boundary, int acceleration_steps, std::unique_ptr<coupler::LoadPrediction> prediction);

    /// Waits for the fluid's packet; its load on the whole wet boundary is then in `load`.
    coupler::Window receive();
    /// Answers with the motion at a time [s].
    void send(double time, const Motion& motion, coupler::SolidReport report);

    /// As received.
    const coupler::SurfaceLoad& load() const { return load_; }
    /// What the load is taken to be in the step that starts now. \param dt its length [s].
    const coupler::SurfaceLoad& predict_load(const Motion& motion, double dt);
    std::string loads_hash() const { return interface_.loads_hash(); }
    double wait_seconds() const { return interface_.wait_seconds(); }
    std::int64_t bytes_received() const { return interface_.bytes_received(); }

private:
    const WetBoundary* boundary_;
    coupler::SolidInterface interface_;
    coupler::AccelerationFilter filter_;
    std::unique_ptr<coupler::LoadPrediction> prediction_;
    coupler::SurfaceLoad received_, load_;
    coupler::FluidReport fluid_;
};

} // namespace fem
