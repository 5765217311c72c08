// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/dofs/sparse_matrix.hpp"

namespace fem {

/// A force on the nodes, possibly depending on where they are and how fast they move.
class Load {
public:
    virtual ~Load() = default;

    /// Adds `scale` times the nodal forces [N] (2D: N/m) to `force`. \param scale load factor, 1 = the full load.
    virtual void add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const = 0;
    /// Adds -scale (d force/du + velocity_slope d force/dv) to `matrix`: what the load brings to the tangent of
    /// g = f_int - f_ext. Dead loads bring nothing. \param velocity_slope dv/du of the time scheme [1/s].
    virtual void add_tangent(const Motion& motion, double scale, double velocity_slope, Matrix& matrix) const = 0;
};

/// Nodal forces that do not depend on the motion.
class DeadLoad final : public Load {
public:
    explicit DeadLoad(Eigen::VectorXd force) : force_(std::move(force)) {}

    void set(Eigen::VectorXd force) { force_ = std::move(force); }
    const Eigen::VectorXd& force() const { return force_; }
    void add_force(const Motion&, double scale, Eigen::VectorXd& force) const override { force += scale * force_; }
    void add_tangent(const Motion&, double, double, Matrix&) const override {}

private:
    Eigen::VectorXd force_;
};

} // namespace fem
