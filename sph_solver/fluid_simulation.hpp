// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/progress.hpp"
#include "sph_solver/fluid_output.hpp"
#include "sph_solver/solid_link.hpp"
#include "sph_solver/time/time_step.hpp"

#include <memory>

namespace sph {

/// A whole run of the fluid, alone or coupled to a solid: owns everything that lives as long as the run.
template<int D> class FluidSimulation {
public:
    FluidSimulation(const FluidConfig& config, coupler::Session& session);

    /// Makes the initial state and checks it against the walls, without a step and without the solid. Collective.
    void check();

    /// From the start time to the first step at or after the end time, or until asked to stop. Collective.
    void run();

private:
    void start();
    void advance();
    void exchange();
    void write();
    void finish();
    [[nodiscard]] bool is_last() const;
    [[nodiscard]] bool meets_solid() const;
    [[nodiscard]] bool stop_wanted();

    FluidConfig config_;
    coupler::Session& session_;
    FluidModel<D> model_;
    double end_time_;
    Walls<D> walls_;
    NeighbourSearch<D> search_;
    Domain<D> domain_;
    Outflow<D> outflow_;
    FluidStep<D> step_;
    EnergyLedger<D> ledger_;
    TimeStep time_step_;
    Particles<D> particles_;
    std::unique_ptr<SolidLink<D>> solid_;    ///< none when the fluid runs alone
    std::unique_ptr<FluidOutput<D>> output_; ///< none for a check
    base::Progress progress_;
    Instant now_;
    double next_dt_ = 0.0;
    bool stopping_ = false, row_wanted_ = false;
    double updates_ = 0.0; ///< particle updates so far, all ranks
    double loop_seconds_ = 0.0;
};

} // namespace sph
