// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/session/energy_record.hpp"
#include "sph_solver/time/energy_ledger.hpp"
#include "sph_solver/time/fluid_step.hpp"
#include "sph_solver/wet_interface.hpp"

#include <memory>

namespace sph {

/// The fluid's side of the coupling: what crosses its interfaces, one with each solid, and the account of it.
///
/// At t_n the fluid sends the load of its step n - 1 and the next dt, and receives the surfaces' motion at t_n, with
/// which its moving walls start step n. All sides then compute t_n -> t_n+1 at the same time. With `solid_every` = k the
/// exchange comes after every k-th step, and the solids' steps are k of the fluid's.
template<int D> class SolidLink {
public:
    SolidLink(coupler::Session& session, const FluidModel<D>& model, const NeighbourSearch<D>& search, Walls<D>& walls);

    /// Whether the solids are met after so many steps.
    [[nodiscard]] bool due(std::int64_t step) const { return step % steps_ == 0; }
    /// Between two exchanges: the surfaces go on for one step [s].
    void coast(double dt);

    /// Measures the loads of every step.
    StageObserver<D>& observer() { return observer_; }

    /// Asks where the facets are and puts them into the walls. \pre particles are spread over the ranks. Collective.
    void greet(const Particles<D>& particles, double time);

    /// Measures load 0, that of the state at rest with the walls where they are, and logs how surface and water meet. Collective.
    void measure_start(FluidStep<D>& step, Particles<D>& particles);

    /// Sends the load of the last step, receives the motion at `step.time` and gives it to the walls. Collective.
    /// \param step  the last step and what follows it
    void exchange(const coupler::Window& step, const Particles<D>& particles);

    /// Energies that go with the next packets; to be renewed whenever a row is written.
    void report(const EnergyBalance& energies);

    /// Writes a row of each interface's table and of energy_total.csv for the last exchange.
    void write_row();

    [[nodiscard]] bool stop_agreed() const;

    /// Adds waits, bytes, balances to the figures of the run. Collective.
    void summarise(base::JsonObject& figures) const;

private:
    void send(const coupler::Window& window, const Particles<D>& particles);
    void receive();
    void move_walls();
    void add_to_records(const coupler::Window& window);

    coupler::Session& session_;
    Walls<D>& walls_;
    int steps_; ///< from one exchange to the next
    double region_margin_;
    double region_step_;
    coupler::RegionBox last_region_; ///< of the step before: its facets still bear the load that is sent now
    LoadObserver<D> observer_;
    std::vector<std::unique_ptr<WetInterface<D>>> interfaces_;
    coupler::FluidEnergies energies_;
    std::optional<coupler::EnergyRecord> record_; ///< on rank 0
};

} // namespace sph
