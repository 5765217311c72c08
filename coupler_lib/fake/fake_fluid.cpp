// SPDX-License-Identifier: MIT
// A prescribed pressure on the wet surface, in the place of sph_solver.
//
//     mpirun -n 1 fake_fluid coupling.toml --as fluid : -n 1 fem_solver coupling.toml
//
//       p(t) or p(y)
//      | | | | | |
//      v v v v v v
//     =============   wet surface of the solid
#include "coupler_lib/base/csv.hpp"
#include "coupler_lib/base/json.hpp"
#include "coupler_lib/base/progress.hpp"
#include "coupler_lib/coupling/fluid_interface.hpp"
#include "coupler_lib/coupling/patience.hpp"
#include "coupler_lib/fake/facet_pressure.hpp"
#include "coupler_lib/session/energy_record.hpp"
#include "coupler_lib/session/interface_record.hpp"
#include "coupler_lib/session/session.hpp"

#include <limits>
#include <optional>

namespace {

using namespace coupler;

const RegionBox everywhere{{-1e30, -1e30, -1e30}, {1e30, 1e30, 1e30}};

/// What the root writes: interface.csv and energy_total.csv, DIR/fluid/probes.csv, progress.
class Records {
public:
    explicit Records(Session& session)
        : interface_(interface_path(session.output_dir(), "", true), 2),
          energy_(session.output_dir(), 2),
          probes_(session.own_dir() + "/probes.csv",
                  {"t[s]", "force_x[N/m]", "force_y[N/m]", "work_on_solid[J/m]", "wall[s]"}),
          progress_(session.log(), 0.0, session.coupling().time.end),
          session_(session)
    {}

    void add(const Window& window, const FluidReport& fluid, const SolidReport& solid)
    {
        interface_.add(window, fluid, solid);
        interface_.write();
        energy_.add(window.time, fluid, {solid});
        energy_.write();
        probes_.row({window.time, fluid.force[0], fluid.force[1], fluid.work_on_solid + fluid.jump_work,
                     session_.wall_seconds()});
        progress_.update(window.time, window.step, window.dt);
        if (window.last) progress_.finish();
    }
    double mismatch() const { return interface_.audit().worst_mismatch(); }

private:
    InterfaceRecord interface_;
    EnergyRecord energy_;
    base::CsvWriter probes_;
    base::Progress progress_;
    Session& session_;
};

class PressureRun {
public:
    PressureRun(Session& session, const FakeFluidConfig& config)
        : session_(session),
          config_(config),
          wet_(session.participant(), settings(session, config), 2),
          pressure_(config.fluid, config.pressure)
    {
        if (session.is_root()) records_.emplace(session);
    }

    void run()
    {
        if (meets_fault("start", 0) == Fault::leave) return;
        exchange({-1, 0, 0}, {});
        measure(0, 0);
        const double end = session_.coupling().time.end; // its steps cost nothing: one makes a window
        const double dt = config_.fluid.dt * session_.coupling().scheme.solid_every;
        for (std::int64_t step = 0;; ++step) {
            const double time = static_cast<double>(step) * dt;
            const bool stop = wet_.stop_agreed();
            const Window window{step, time, dt, stop || time > end - 1e-9 * dt, stop};
            if (!exchange(window, pressure_.loads())) return;
            if (records_) records_->add(window, report_, solid_);
            if (window.last) break;
            Patience::nap(config_.run.sleep);
            const Fault fault = meets_fault("step", step);
            if (fault == Fault::leave) return;
            measure(fault == Fault::nan ? std::numeric_limits<double>::quiet_NaN() : time, dt);
        }
        if (meets_fault("end", 0) == Fault::leave) return;
        finish();
    }

private:
    Fault meets_fault(const std::string& moment, std::int64_t step) const
    {
        return act_out(config_.fault, moment, step, session_.comm().rank());
    }

    static InterfaceSettings settings(const Session& session, const FakeFluidConfig& config)
    {
        auto settings = session.coupling().interface_of(session.role()).settings(session.role());
        settings.impedance = config.fluid.impedance;
        return settings;
    }

    /// Every facet is loaded by one rank: the one whose turn its id is.
    bool is_mine(std::int64_t facet_id) const { return facet_id % session_.comm().size() == session_.comm().rank(); }

    /// \return false: the fault "leave" ends the run here
    bool exchange(const Window& window, const FacetLoads& loads)
    {
        report_.wait = session_.comm().max(wet_.wait_seconds());
        wet_.send(window, everywhere, loads, *batch_, report_);
        if (meets_fault("exchange", window.step) == Fault::leave) return false;
        batch_ = &wet_.receive(solid_);
        if (window.step < 1) return true;
        const auto works = session_.comm().total({pressure_.jump_work(*batch_), pressure_.path_work(*batch_)});
        report_.jump_work += works[0].value();
        report_.path_work += works[1].value();
        report_.external_work = report_.work_on_solid + report_.jump_work; // whatever makes the pressure pays for it
        return true;
    }

    void measure(double time, double dt)
    {
        pressure_.measure(*batch_, time, dt, [this](std::int64_t id) { return is_mine(id); });
        auto sums = pressure_.resultants(*batch_);
        sums.push_back(pressure_.work());
        sums = session_.comm().total(sums);
        report_.force = {sums[0].value(), sums[1].value(), 0};
        report_.moment = {0, 0, sums[2].value()};
        report_.work_on_solid += sums[3].value();
    }

    void finish()
    {
        base::JsonObject figures;
        figures.set("wait_s", session_.comm().max(wet_.wait_seconds()))
            .set("bytes_received_rank0", wet_.bytes_received());
        if (records_) figures.set("interface_work_mismatch", records_->mismatch());
        session_.write_summary(figures);
    }

    Session& session_;
    const FakeFluidConfig& config_;
    FluidInterface wet_;
    FacetPressure pressure_;
    const FacetBatch nothing_{};
    const FacetBatch* batch_ = &nothing_;
    FluidReport report_;
    SolidReport solid_;
    std::optional<Records> records_;
};

} // namespace

int main(int argc, char** argv)
{
    const ProgramInfo program{"fake_fluid", "fluid",
                              "A prescribed pressure on the wet surface, in the place of sph_solver.",
                              [](base::ConfigReader& reader) { read_fake_fluid(reader); }};
    return run_program(program, argc, argv, [](Session& session) {
        auto reader = session.reader();
        const FakeFluidConfig config = read_fake_fluid(reader);
        base::require_input(session.coupled(), "fake_fluid runs coupled only: give it coupling.toml");
        if (session.check_only()) {
            DataFlow flow;
            flow.dimension = 2;
            flow.fields = interface_fields(2, session.coupling().interface_of(session.role()), session.role());
            flow.dt = config.fluid.dt;
            flow.impedance = config.fluid.impedance;
            return session.check_flow(flow);
        }
        PressureRun(session, config).run();
    });
}
