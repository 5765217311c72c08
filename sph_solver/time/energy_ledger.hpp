// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "coupler_lib/foundation/reproducible_sum.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/state/outflow.hpp"
#include "sph_solver/time/evaluation.hpp"

#include <array>

namespace sph {

/// The fluid's account at one instant; 2D: per metre of depth. Works and dissipations are sums since the start.
struct EnergyBalance {
    double kinetic = 0;                           ///< sum P^2 / (2 m) [J]
    double potential = 0;                         ///< -sum m g.x [J]
    double internal = 0;                          ///< sum m u(rho) [J]
    double total = 0;                             ///< kinetic + potential + internal [J]
    double mass = 0;                              ///< [kg]
    std::array<double, 3> momentum{};             ///< [kg m/s]
    double work_by_walls = 0;                     ///< of fixed or prescribed bodies on the fluid [J]
    double work_by_interface = 0;                 ///< of the coupled solid on the fluid [J]
    double outflow_mass = 0;                      ///< left through openings [kg]
    std::array<double, 3> outflow_momentum{};     ///< [kg m/s]
    double outflow_energy = 0;                    ///< [J]
    std::array<double, 3> impulse_of_walls{};     ///< of fixed or prescribed bodies on the fluid [kg m/s]
    std::array<double, 3> impulse_of_interface{}; ///< of the coupled solid on the fluid [kg m/s]
    double trapped_particles = 0;                 ///< of the outflow, what was taken out between closing walls
    double trapped_mass = 0;                      ///< [kg]
    double trapped_energy = 0;                    ///< [J]
    double dissipation_riemann = 0;               ///< lost in the pressures of fluid pairs [J]
    double dissipation_mass_flux = 0;             ///< lost in their mass fluxes [J]
    double dissipation_walls = 0;                 ///< lost between fluid and wall images [J]
    double viscous = 0;                           ///< lost to viscosity; an inviscid fluid has none [J]
    double balance_error = 0; ///< what these do not explain of the change of `total` [J], second order in dt
};

/// Keeps the fluid's energy account. The rates of loss are summed pair by pair (grouped by particle) with the
/// integrator's weights, never taken as a remainder. With h = u + p/rho, for the fluid pairs of particle i:
///
///     D_riemann   = -(v.dP_p - p dw)                                     dP_p, dw: by pressures, of volume
///     D_mass_flux = -(v.dP_m - v^2/2 dm + h dm - g.x dm)                 dP_m, dm: carried by the mass flux
///
/// (The last term is potential energy that changes its height with the mass that crosses.) Walls:
/// operators/wall_flux.hpp. Sums over particles are exact integers (base::ReproducibleSum): they do not depend on the
/// partition.
template<int D> class EnergyLedger : public StageObserver<D> {
public:
    explicit EnergyLedger(const FluidModel<D>& model) : model_(model) {}

    void observe(const Particles<D>& particles, const Walls<D>& walls, const Evaluation<D>& evaluation, double weight,
                 double dt) override;

    /// The account now, the same on every rank; the first call sets the zero of the balance. Collective.
    EnergyBalance balance(const Particles<D>& particles, const Outflow<D>& outflow, const base::Communicator& comm);

private:
    void add_energies(std::vector<base::ReproducibleSum>& sums, const Particles<D>& particles) const;

    FluidModel<D> model_;
    base::ReproducibleSum riemann_, mass_flux_, viscous_; ///< dissipated on this rank so far
    WallPower walls_;                                     ///< work and loss at the walls so far, this rank
    bool started_ = false;
    double start_total_ = 0;
};

} // namespace sph
