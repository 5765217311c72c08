// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/progress.hpp"
#include "fem_solver/interface/fluid_link.hpp"
#include "fem_solver/setup/interface_loads.hpp"
#include "fem_solver/solid_output.hpp"
#include "fem_solver/time/solid_step.hpp"

#include <optional>

namespace fem {

/// One run of the solid, alone (static or dynamic) or coupled to a fluid.
class SolidSimulation {
public:
    /// \throws base::Error bad_input for what the files ask and this solver cannot do.
    SolidSimulation(const SolidConfig& config, coupler::Session& session);

    /// Says what would be computed.
    void check() const;
    void run();

private:
    void report_cut() const;
    void report_stability() const;
    void run_static();
    void run_modal();
    void prepare();
    void settle();
    void run_alone();
    void run_coupled();
    void answer_first(const coupler::Window& window);
    void keep_pace_with_the_fluid();
    void follow_the_fluid();
    void step_under_load(double dt);
    void show(const coupler::Window& window);
    void advance(double dt);
    void answer(const coupler::Window& window);
    coupler::SolidReport report() const;
    void write();
    void finish(base::JsonObject figures);

    const SolidConfig& config_;
    coupler::Session& session_;
    SolidModel model_;
    SolidStep step_;
    Motion motion_;
    Instant now_;
    coupler::Window window_; // of the last packet
    std::optional<SolidOutput> output_;
    std::optional<WetBoundary> boundary_;
    std::optional<InterfaceLoads> loads_;
    std::optional<FluidLink> fluid_;
};

} // namespace fem
