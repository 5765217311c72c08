// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/dofs/sparse_matrix.hpp"

#include <string>

namespace fem {

/// How an augmentation went.
enum class Augmentation {
    settled,  ///< nothing changed that counts
    again,    ///< equilibrium must be sought anew
    unsettled ///< and that has gone on for too long
};

/// Contact of the body with what it may touch. Its multipliers stand still while Newton's method finds an equilibrium with
/// them; `augment` then brings them nearer to the truth. Nothing is forgotten or kept unless a step is accepted.
class ContactForce {
public:
    virtual ~ContactForce() = default;

    /// The most it adds to a node's stiffness [N/m] (2D: N/m^2).
    virtual double stiffness() const = 0;
    /// Back to the state at the end of the last accepted step.
    virtual void restore() = 0;
    /// Adds the forces on the body [N] (2D: N/m): of the pressure and of friction.
    virtual void add_force(const Motion& motion, double time, Eigen::VectorXd& normal,
                           Eigen::VectorXd& friction) const = 0;
    /// Adds -d(force)/du to `matrix`.
    virtual void add_tangent(const Motion& motion, double time, Matrix& matrix) const = 0;
    /// Takes the forces of an equilibrium for the new multipliers. Collective.
    virtual Augmentation augment(const Motion& motion, double time) = 0;
    /// What does not settle, where and by how much, in words.
    virtual std::string complaint() const = 0;
    /// The step ends here.
    virtual void accept(const Motion& motion, double time) = 0;
};

/// A body that touches nothing.
class NoContact final : public ContactForce {
public:
    double stiffness() const override { return 0; }
    void restore() override {}
    void add_force(const Motion&, double, Eigen::VectorXd&, Eigen::VectorXd&) const override {}
    void add_tangent(const Motion&, double, Matrix&) const override {}
    Augmentation augment(const Motion&, double) override { return Augmentation::settled; }
    std::string complaint() const override { return ""; }
    void accept(const Motion&, double) override {}
};

} // namespace fem
