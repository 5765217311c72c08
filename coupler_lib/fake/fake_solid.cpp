// SPDX-License-Identifier: MIT
// A spring-mass piston with a flat rigid wet surface, in the place of fem_solver.
//
//     mpirun -n 1 sph_solver coupling.toml : -n 1 fake_solid coupling.toml
//
//        fluid
//     ===========   wet surface, m [kg/m^2]
//        /\/\/      k [N/m^3]
#include "coupler_lib/base/csv.hpp"
#include "coupler_lib/base/json.hpp"
#include "coupler_lib/coupling/acceleration_filter.hpp"
#include "coupler_lib/coupling/patience.hpp"
#include "coupler_lib/coupling/solid_interface.hpp"
#include "coupler_lib/fake/piston_surface.hpp"
#include "coupler_lib/session/session.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace {

using namespace coupler;

/// DIR/solid/probes.csv and energy.csv.
class Tables {
public:
    explicit Tables(const std::string& folder)
        : probes_(folder + "/probes.csv", {"t[s]", "piston.ux[m]", "piston.uy[m]", "piston.u[m]", "piston.v[m/s]",
                                           "piston.a[m/s^2]", "piston.load[Pa]"}),
          energy_(folder + "/energy.csv",
                  {"t[s]", "dt[s]", "kinetic[J/m]", "strain[J/m]", "potential[J/m]", "work_interface[J/m]",
                   "work_supports[J/m]", "work_loads[J/m]", "contact[J/m]", "friction[J/m]",
                   "numerical_dissipation[J/m]", "balance_error[J/m]"})
    {}

    void write(const Window& window, const Oscillator& piston, const PistonSurface& surface)
    {
        const auto along = surface.displacement_vector(piston.displacement());
        probes_.row({window.time, along[0], along[1], piston.displacement(), piston.velocity(), piston.acceleration(),
                     piston.applied_load()});
        const double area = surface.length();
        energy_.row({window.time, window.dt, area * piston.kinetic(), area * piston.strain(), area * piston.potential(),
                     area * piston.work(), 0, 0, 0, 0, area * piston.numerical_dissipation(),
                     area * piston.balance_error()});
    }

private:
    base::CsvWriter probes_, energy_;
};

/// One run of the piston.
class PistonRun {
public:
    PistonRun(Session& session, const FakeSolidConfig& config)
        : session_(session),
          config_(config),
          surface_(config.surface, session.comm()),
          piston_(config.piston),
          wet_(session.participant(), session.coupling().interface_of(session.role()).settings(session.role()),
               surface_.wet()),
          filter_(session.coupling().scheme.acceleration == "nodal" ? 0 : session.coupling().scheme.acceleration_steps),
          prediction_(session.coupling().scheme.load_prediction())
    {
        if (session.is_root()) tables_.emplace(session.own_dir());
    }

    void run()
    {
        if (meets_fault("start", 0) == Fault::leave) return;
        answer(wet_.receive(load_, fluid_)); // greeting: where the surface is
        window_ = wet_.receive(load_, fluid_);
        piston_.start(surface_.axial(load_));
        if (!answer(window_)) return;
        const auto pass = session_.coupling().scheme.serial() ? &PistonRun::follow : &PistonRun::keep_pace;
        while (!window_.last)
            if (!(this->*pass)()) return;
        if (meets_fault("end", window_.step) == Fault::leave) return;
        session_.write_summary(summary());
    }

private:
    Fault meets_fault(const std::string& moment, std::int64_t step) const
    {
        return act_out(config_.fault, moment, step, session_.comm().rank());
    }

    /// Parallel: the fluid makes this step at the same time. \return false: a fault ends the run here
    bool keep_pace()
    {
        if (!step()) return false;
        window_ = wet_.receive(load_, fluid_);
        return answer(window_);
    }

    /// Serial: the fluid has made this step already. \return false: a fault ends the run here
    bool follow()
    {
        const Window next = wet_.receive(load_, fluid_);
        if (!step()) return false;
        window_ = next;
        return answer(window_);
    }

    /// The window's step with the load received last. \return false: the fault "leave" ends the run here
    bool step()
    {
        Patience::nap(config_.run.sleep);
        if (meets_fault("step", window_.step) == Fault::leave) return false;
        prediction_->apply(load_, motion().velocity, window_.dt);
        piston_.advance(load_of_step(), window_.dt);
        surface_.resultants(load_, piston_.displacement(), piston_.applied_load(), report_);
        return true;
    }

    SurfaceMotion motion() const
    {
        return surface_.motion(piston_.displacement(), piston_.velocity(), piston_.acceleration());
    }

    /// Sends the motion at the window's time and writes a row. \return false: the fault "leave" ends the run here
    bool answer(const Window& window)
    {
        const Fault fault = meets_fault("exchange", window.step);
        if (fault == Fault::leave) return false;
        SurfaceMotion now = motion();
        filter_.apply(window.time, now);
        if (fault == Fault::nan) now.velocity.at(0) = std::numeric_limits<double>::quiet_NaN();
        fill_report();
        wet_.send(now, report_);
        if (tables_ && window.step >= 0) tables_->write(window, piston_, surface_);
        return true;
    }

    OscillatorLoad load_of_step() const
    {
        const double share = session_.coupling().scheme.impedance_share();
        const double cosine = surface_.axis_cosine(); // the reaction rho c v.n acts along n
        return {surface_.axial(load_), share * load_.impedance * cosine * cosine, surface_.axial(load_.wall_velocity)};
    }

    void fill_report()
    {
        const double area = surface_.length();
        report_.work = area * piston_.work();
        report_.displacement_max = std::abs(piston_.displacement());
        report_.kinetic = area * piston_.kinetic();
        report_.strain = area * piston_.strain();
        report_.potential = area * piston_.potential();
        report_.dissipated = area * piston_.numerical_dissipation();
        report_.wait = session_.comm().max(wet_.wait_seconds());
    }

    base::JsonObject summary()
    {
        base::JsonObject figures;
        figures.set("steps", window_.step)
            .set("wait_s", report_.wait)
            .set("bytes_received_rank0", wet_.bytes_received());
        return figures;
    }

    Session& session_;
    const FakeSolidConfig& config_;
    PistonSurface surface_;
    Oscillator piston_;
    SolidInterface wet_;
    AccelerationFilter filter_;
    std::unique_ptr<LoadPrediction> prediction_;
    Window window_; ///< of the last packet
    SurfaceLoad load_;
    FluidReport fluid_;
    SolidReport report_;
    std::optional<Tables> tables_;
};

} // namespace

int main(int argc, char** argv)
{
    const ProgramInfo program{"fake_solid", "solid",
                              "A spring-mass piston with a flat wet surface, in the place of fem_solver.",
                              [](base::ConfigReader& reader) { read_fake_solid(reader); }};
    return run_program(program, argc, argv, [](Session& session) {
        auto reader = session.reader();
        const FakeSolidConfig config = read_fake_solid(reader);
        base::require_input(session.coupled(), "fake_solid runs coupled only: give it coupling.toml");
        if (session.check_only()) {
            DataFlow flow;
            flow.dimension = 2;
            flow.fields = interface_fields(2, session.coupling().interface_of(session.role()), session.role());
            flow.groups = {{"piston", config.surface.facets}};
            flow.density = config.piston.mass; // a rigid piston answers as a whole: a layer of 1 m
            flow.wave_speed = 1e30;
            flow.thickness = 1;
            return session.check_flow(flow);
        }
        PistonRun(session, config).run();
    });
}
