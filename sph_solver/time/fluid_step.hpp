// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/timer.hpp"
#include "sph_solver/neighbours/neighbour_search.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/gradient_sums.hpp"
#include "sph_solver/operators/momentum_term.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/operators/pair_records.hpp"
#include "sph_solver/parallel/domain.hpp"
#include "sph_solver/parallel/work_meter.hpp"
#include "sph_solver/state/outflow.hpp"
#include "sph_solver/time/evaluation.hpp"
#include "sph_solver/time/stage_update.hpp"

#include <memory>
#include <vector>

namespace sph {

/// What a step works on; all of it lives in the simulation and outlives the step.
template<int D> struct FluidParts {
    Domain<D>& domain;
    NeighbourSearch<D>& search;
    Walls<D>& walls;
    Outflow<D>& outflow;
    base::TimerTree& timers;
};

/// One time step of the fluid.
///
/// Between steps the conserved fields of the owned particles and all that follows from them without a neighbour sum
/// (velocity, density, pressure, sound speed) are up to date; what the halo copies need is on its way. Within a step the
/// rows that need no halo copy are worked on while messages travel.
template<int D> class FluidStep {
public:
    FluidStep(const FluidModel<D>& model, const RungeKutta& runge_kutta, const FluidParts<D>& parts)
        : model_(model),
          runge_kutta_(runge_kutta),
          parts_(parts),
          in_reach_(model.kernel.support()),
          meter_(parts.domain.comm().size() > 1)
    {}

    /// Adds one who keeps account of every step; not owned.
    void add_observer(StageObserver<D>& observer) { observers_.push_back(&observer); }

    /// Adds a further force between particles.
    void add_term(std::unique_ptr<MomentumTerm<D>> term) { terms_.push_back(std::move(term)); }

    /// Spreads freshly made particles over the ranks and makes lists and derived fields: the state between steps.
    /// Collective.
    void prepare(Particles<D>& particles);

    /// Sends particles to their owners and makes the halo, where a step of `dt` asks for it. advance() does so itself, unless it
    /// was done before: a coupled run needs to know its particles before it asks for the facets around them. Collective.
    void settle(Particles<D>& particles, double dt);

    /// From t to t + dt. The moving walls must have been given their motion at t (Walls::set_moving). Collective.
    void advance(Particles<D>& particles, double dt);

    /// Rates of the present state with the walls where they are: pass 1 (unless slopes are kept), halo exchange, pass 2.
    /// Collective.
    const Evaluation<D>& evaluate(Particles<D>& particles, Slopes slopes = Slopes::made);

    /// How often lists and halo were made anew.
    long rebuilds() const { return rebuilds_; }

private:
    /// A part of the step whose time is shown in the summary and weighs in the next cut.
    struct Measured {
        base::TimerTree::Scope timer;
        WorkMeter::Scope meter;
    };

    Measured measure(const char* name, Work kind) { return {parts_.timers.scope(name), meter_.measure(kind)}; }
    void find_planes(const Particles<D>& particles);
    void find_rates_with_new_slopes(Particles<D>& particles, const RowSet& inner, const RowSet& border);
    void find_rates_with_kept_slopes(Particles<D>& particles, const RowSet& inner, const RowSet& border);
    void meet(const Particles<D>& particles, const std::vector<int>& which, const RowSet& rows);
    void first_pass(const RowSet& rows);
    void find_images(const Particles<D>& particles);
    void first_pass_at_walls(Particles<D>& particles);
    void second_pass(const RowSet& rows);
    void second_pass_at_walls(const Particles<D>& particles);
    void complete_state(Particles<D>& particles);
    void complete_gradients(Particles<D>& particles);
    void report_work(const Particles<D>& particles);
    void refresh_neighbourhood(const Particles<D>& particles, double dt);
    bool lists_hold(const Particles<D>& particles, double dt) const;
    bool walls_hold(double dt) const;
    void prepare_walls(const Particles<D>& particles);
    void redistribute(Particles<D>& particles);
    void remove_trapped_and_gone(Particles<D>& particles);
    void build_lists(const Particles<D>& particles);

    FluidModel<D> model_;
    RungeKutta runge_kutta_;
    FluidParts<D> parts_;
    std::vector<StageObserver<D>*> observers_;
    std::vector<std::unique_ptr<MomentumTerm<D>>> terms_;
    PairRecords<D> records_;
    NeighboursInReach<D> in_reach_;
    WallImages<D> images_;
    GradientField<D> gradient_sums_; ///< complete between the passes, wall images included
    Evaluation<D> evaluation_;
    StageUpdate<D> update_;
    RowSplit split_;
    WorkMeter meter_;
    int evaluations_ = 0;        ///< since the work was reported
    bool settled_ = false;       ///< settle was called for the coming step
    bool redistributed_ = false; ///< lists are void
    long rebuilds_ = 0;
};

} // namespace sph
