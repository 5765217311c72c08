// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/contact_force.hpp"
#include "fem_solver/assembly/load.hpp"
#include "fem_solver/assembly/solid_body.hpp"
#include "fem_solver/dofs/dof_map.hpp"

#include <functional>
#include <string>

namespace fem {

/// Nodal forces of one instant by origin [N] (2D: N/m).
struct Forces {
    Eigen::VectorXd internal;               ///< f_int(u)
    Eigen::VectorXd damping;                ///< C v
    Eigen::VectorXd gravity;                ///< M g
    Eigen::VectorXd loads;                  ///< pressures, tractions, nodal forces of the configuration
    Eigen::VectorXd interface;              ///< what the fluid sent
    Eigen::VectorXd correction;             ///< what the coupling scheme adds to it (impedance)
    Eigen::VectorXd contact;                ///< pressure of what the body touches
    Eigen::VectorXd friction;               ///< friction there
    std::vector<Eigen::VectorXd> each_load; ///< the parts of `loads`, one for each load

    static Forces zero(Eigen::Index dofs);
    /// g = f_int + C v - f_ext, the unbalanced force without inertia.
    Eigen::VectorXd unbalanced() const;
    /// a times this plus b times other, origin by origin.
    Forces blend(double a, const Forces& other, double b) const;
};

/// Stiffness-proportional and mass-proportional damping, C = eta K_0 + mass M (K_0: undeformed stiffness).
struct Damping {
    double stiffness = 0; ///< eta [s]
    double mass = 0;      ///< [1/s]
};

/// Everything that pulls at the nodes: body, damping, gravity and loads, with mass and tangent. Built once, in setup.
class SolidForces {
public:
    /// Collective over the mesh's ranks, as all that returns energies or says whether something happened.
    SolidForces(const Mesh& mesh, const Material& material, const BodySettings& settings);
    SolidForces(const SolidForces&) = delete;

    void set_damping(const Damping& damping);
    void set_gravity(const std::vector<double>& acceleration);
    /// \param factor of time t [s], which multiplies the load. \param name for its column of works.
    using TimeFactor = std::function<double(double t)>;
    void add_load(std::unique_ptr<Load> load, std::string name = "", TimeFactor factor = {});
    const std::vector<std::string>& load_names() const { return load_names_; }
    void set_interface_load(std::unique_ptr<Load> load) { interface_ = std::move(load); }
    void set_correction(std::unique_ptr<Load> load) { correction_ = std::move(load); }
    /// Where a sub-step ends within the window of a fluid's load: the interface's forces are (1 - share) those of the
    /// window's start, as they were there, and share those of its end.
    void set_window(double share, const Forces& start);
    void set_contact(std::unique_ptr<ContactForce> contact);

    /// What the body may touch; touches nothing unless set_contact was called.
    ContactForce& contact() const { return *contact_; }
    const DofMap& map() const { return map_; }
    const MatrixPattern& pattern() const { return pattern_; }
    Eigen::Index dofs() const { return mass_.rows(); }
    const Matrix& mass() const { return mass_; }
    /// Stiffness of the undeformed, unloaded body.
    const Matrix& initial_stiffness() const { return initial_stiffness_; }
    SolidBody& body() const { return *body_; }

    /// All forces for a motion. \param scale factor on gravity and loads (static load stepping; 1 otherwise).
    /// \param time at which the loads' factors are taken [s].
    Inversion evaluate(const Motion& motion, double scale, Forces& forces, double time = 0) const;
    /// mass_factor M + stiffness_factor (dg/du + velocity_slope dg/dv), g the unbalanced force.
    struct TangentFactors {
        double mass, stiffness, velocity_slope, scale;
        double time = 0;
    };
    Matrix tangent(const Motion& motion, const TangentFactors& factors) const;

    double kinetic_energy(const Motion& motion) const
    {
        return 0.5 * map_.dot(motion.velocity, inertia(motion.velocity));
    }
    double strain_energy(const Motion& motion) const
    {
        return map_.team().sum(body_->strain_energy(motion.displacement));
    }
    double lost_energy() const { return map_.team().sum(body_->lost_energy()); }
    /// What remembers takes note of a motion that has come about: the material, and the contact at its time [s].
    void accept(const Motion& motion, double time) const
    {
        body_->accept(motion.displacement);
        contact_->accept(motion, time);
    }
    /// Potential of gravity, - g . M u; zero in the reference state.
    double potential_energy(const Motion& motion) const { return -map_.dot(motion.displacement, gravity_); }
    /// M times a field.
    Eigen::VectorXd inertia(const Eigen::VectorXd& field) const;
    /// Round-off level of a nodal force, eps K max(4 h, 2 |u|) with the largest diagonal K, the element size h and the
    /// largest displacement: what a residual cannot fall below [N].
    double round_off(const Motion& motion) const
    {
        return round_off_ * std::max(4 * element_size_, 2 * map_.largest(motion.displacement));
    }

private:
    double load_factor(std::size_t k, double time) const { return factors_[k] ? factors_[k](time) : 1; }

    DofMap map_;
    MatrixPattern pattern_;
    std::unique_ptr<SolidBody> body_;
    Matrix mass_, sparse_mass_, initial_stiffness_, damping_;
    bool damped_ = false;
    Eigen::VectorXd gravity_;
    std::vector<std::unique_ptr<Load>> loads_;
    std::vector<TimeFactor> factors_;
    std::vector<std::string> load_names_;
    std::unique_ptr<Load> interface_, correction_;
    double window_share_ = 1;
    Eigen::VectorXd interface_start_, correction_start_;
    std::unique_ptr<ContactForce> contact_ = std::make_unique<NoContact>();
    double element_size_ = 0, round_off_ = 0; // [m], eps K [N/m], contact included
};

} // namespace fem
