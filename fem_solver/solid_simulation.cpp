// SPDX-License-Identifier: MIT
#include "fem_solver/solid_simulation.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/data_flow.hpp"
#include "fem_solver/material/stability.hpp"
#include "fem_solver/modal/modal_analysis.hpp"
#include "fem_solver/output/modal_output.hpp"
#include "fem_solver/output/state_hash.hpp"
#include "fem_solver/setup/formulation.hpp"
#include "fem_solver/setup/solver_settings.hpp"
#include "fem_solver/time/static_solution.hpp"

#include <cmath>

namespace fem {
namespace {

NewtonSettings newton_settings(const NewtonConfig& config)
{
    return {config.tolerance, config.max_iterations, config.contraction};
}

Predictor predictor(const std::string& name)
{
    if (name == "still") return Predictor::still;
    return name == "continued" ? Predictor::continued : Predictor::constant_acceleration;
}

StepSettings step_settings(const SolidConfig& config)
{
    return {newton_settings(config.newton), predictor(config.newton.predictor), config.time.sub_steps,
            solver_settings(config.linear_solver)};
}

StaticSettings static_settings(const SolidConfig& config, LoadTime time)
{
    return {newton_settings(config.newton), solver_settings(config.linear_solver), time};
}

} // namespace

SolidSimulation::SolidSimulation(const SolidConfig& config, coupler::Session& session)
    : config_(config),
      session_(session),
      model_(config, Team(session.comm())),
      step_(model_.mesh(), model_.forces(), model_.supports(), Hht(config.time.alpha), step_settings(config)),
      motion_(Motion::at_rest(model_.forces().dofs()))
{
    step_.report_to([&](const std::string& line) { session_.log().warn(line); });
    report_cut();
    report_stability();
    const std::string locking = locking_warning(model_.mesh().type, config);
    if (!locking.empty()) session_.log().warn("elements: " + locking);
    if (session.coupled()) {
        base::require_input(config.analysis.kind == "dynamic", "a coupled solid moves: [analysis] kind = \"dynamic\"");
        boundary_.emplace(model_.mesh(), config.interface.groups);
    } else if (config.analysis.kind == "dynamic") {
        base::require_input(config.time.dt > 0 && config.time.end > 0, "[time] dt = ", config.time.dt,
                            " s and end = ", config.time.end, " s: a solid that runs alone needs both above zero");
    }
}

void SolidSimulation::report_cut() const
{
    const Mesh& mesh = model_.mesh();
    const Team& team = mesh.team();
    if (team.size() == 1) return;
    const double mean = team.sum(static_cast<double>(mesh.own_elements())) / team.size();
    const double most = team.max(static_cast<double>(mesh.own_elements()));
    const double held = team.sum(static_cast<double>(mesh.elements())) / team.size();
    session_.log().info(base::text("cut for ", team.size(), " ranks: ", mean, " elements each, at most ", most,
                                   "; copies along the cut make ", 100 * (held / mean - 1), " % more"));
}

void SolidSimulation::report_stability() const
{
    const MaterialConfig& material = config_.material;
    if (material.kinematics == "small") return;
    const auto& range = material.stability_range;
    const StabilityReport report = drucker_stability(make_material(material).law, range[0], range[1]);
    const std::string line = base::text("material ", config_.material_name, " (", material.law, "): ", report.text);
    report.stable ? session_.log().info(line) : session_.log().warn(line);
}

void SolidSimulation::check() const
{
    session_.log().info(base::text("the input is in order: ", all_elements(model_.mesh()), " elements ",
                                   name_of(model_.mesh().type), ", ", all_nodes(model_.mesh()), " nodes"));
    if (session_.coupled()) session_.check_flow(data_flow(config_, model_, session_));
}

void SolidSimulation::run()
{
    if (config_.analysis.kind != "modal") output_.emplace(config_, session_, model_);
    if (session_.coupled())
        run_coupled();
    else if (config_.analysis.kind == "static")
        run_static();
    else if (config_.analysis.kind == "modal")
        run_modal();
    else
        run_alone();
}

void SolidSimulation::run_static()
{
    StaticSolution solution(model_.mesh(), model_.forces(), model_.supports(),
                            static_settings(config_, LoadTime::factor));
    solution.report_to([&](const std::string& line) { session_.log().warn(line); });
    solution.solve(motion_, config_.analysis.load_steps, [&](double factor) {
        now_ = {factor, now_.step + 1, 0, factor == 1};
        std::string residuals;
        for (const double residual : solution.residuals()) residuals += base::text(" ", residual);
        session_.log().info(base::text("load factor ", factor, ": residuals", residuals, " N"));
        output_->write(now_, motion_, solution.energies(), solution.reaction(),
                       Eigen::VectorXd::Zero(model_.forces().dofs()));
    });
    finish(
        base::JsonObject().set("iterations", solution.iterations()).set("strain_energy", solution.energies().strain));
}

/// Natural frequencies about the unloaded state or the equilibrium.
void SolidSimulation::run_modal()
{
    base::require_input(!model_.contacts(), "[analysis] kind = \"modal\" knows no contact: take [[contact]] out, or ",
                        "support the body where it touches");
    const SolidForces& forces = model_.forces();
    const bool loaded = config_.analysis.initial_equilibrium;
    if (loaded) settle();
    if (const double part = loaded ? asymmetry(forces, motion_) : 0; part > 1e-6)
        session_.log().warn(base::text("follower loads make the tangent unsymmetric, by ", part,
                                       " of its largest entry: the modes are those of its symmetric part"));
    const auto modes =
        find_modes(model_.mesh(), forces, model_.supports(), motion_, loaded ? 1 : 0, config_.analysis.modes);
    for (std::size_t i = 0; i < modes.size(); ++i)
        session_.log().info(base::text("mode ", i + 1, ": ", modes[i].frequency(), " Hz"));
    if (modes.front().angular_frequency < 0)
        session_.log().warn("the state is unstable: a negative frequency is that of a motion that grows, "
                            "-sqrt(-w^2)/(2 pi); the loads are beyond buckling");
    if (session_.is_root()) write_modes(session_.own_dir(), model_.mesh().dimension, modes);
    FieldFile fields(session_.own_dir(), model_.mesh(), forces.map(), session_.comm());
    write_shapes(fields, model_.mesh(), forces.map(), motion_, modes,
                 [&](const Eigen::VectorXd& displacement) { return forces.body().stress(displacement); });
    finish(base::JsonObject().set("first_frequency_Hz", modes.front().frequency()));
}

/// The state that the motion starts from.
void SolidSimulation::prepare()
{
    if (config_.analysis.initial_equilibrium) settle();
    const auto dimension = std::ssize(config_.initial.velocity);
    for (Eigen::Index i = 0; i < motion_.velocity.size(); ++i)
        motion_.velocity[i] = config_.initial.velocity[static_cast<std::size_t>(i % dimension)];
    if (model_.contacts() && config_.time.alpha > -0.1)
        session_.log().warn(base::text("[time] alpha = ", config_.time.alpha,
                                       ": impacts want -0.1 or less, else they feed high frequencies"));
}

/// Brings the body to rest under its own weight and loads.
void SolidSimulation::settle()
{
    StaticSolution solution(model_.mesh(), model_.forces(), model_.supports(),
                            static_settings(config_, LoadTime::start));
    solution.report_to([&](const std::string& line) { session_.log().warn(line); });
    solution.solve(motion_, config_.analysis.load_steps, [](double) {});
    session_.log().info(base::text("initial equilibrium: largest displacement ",
                                   model_.forces().map().largest(motion_.displacement), " m, after ",
                                   solution.iterations(), " iterations"));
}

void SolidSimulation::run_alone()
{
    const double end = config_.time.end;
    prepare();
    step_.start(motion_);
    write();
    base::Progress progress(session_.log(), 0, end);
    const long steps = std::lround(std::ceil(end / config_.time.dt * (1 - 1e-12)));
    while (!now_.last) {
        session_.participant().check_signals();
        advance(config_.time.dt);
        now_.last = now_.step >= steps || session_.participant().stop_requested();
        progress.update(now_.time, now_.step, now_.dt);
        write();
    }
    progress.finish();
    finish({});
}

void SolidSimulation::advance(double dt)
{
    const auto scope = session_.timers().scope("step");
    session_.participant().set_clock(now_.step, now_.time);
    step_.advance(motion_, dt);
    now_ = {now_.time + dt, now_.step + 1, dt, false};
}

void SolidSimulation::write()
{
    const auto scope = session_.timers().scope("output");
    output_->write(now_, motion_, step_.energies(), step_.reaction(), step_.forces().interface);
}

void SolidSimulation::finish(base::JsonObject figures)
{
    const double thousands = step_.steps() / 1000.0;
    figures.set("dimension", model_.mesh().dimension)
        .set("elements", all_elements(model_.mesh()))
        .set("nodes", all_nodes(model_.mesh()))
        .set("steps", now_.step)
        .set("state_hash", state_hash(model_.mesh(), motion_));
    if (step_.steps() > 0)
        figures.set("hht_steps", step_.sub_steps())
            .set("newton_iterations_per_step", static_cast<double>(step_.iterations()) / step_.steps())
            .set("refactorisations_per_1000_steps", step_.factorisations() / thousands)
            .set("energy_balance_error", step_.energies().balance_error);
    session_.write_summary(figures);
}

} // namespace fem
