// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/load.hpp"

#include <array>

namespace fem {

/// The acoustic answer of the fluid to a change of the wall's velocity since the load was measured.
///
///     f_a = - Z_a (v_a - w_a),    Z_a = sum over the node's wet facets of (rho c) (A / nodes) n n^T
///
/// The load that arrives was measured while the wall moved with the mean velocity w; a compressible fluid answers a
/// normal velocity change dv at once with the pressure rho c dv. Left out, this answer comes one step late and feeds
/// energy into the solid. The load is a surface damping: symmetric, positive, it only acts along the facets' normals.
/// Area and normals are those of the start of the step.
class ImpedanceLoad final : public Load {
public:
    ImpedanceLoad(const Mesh& mesh, const MatrixPattern& pattern, std::vector<std::array<int, 4>> facets);

    /// \param impedance factor times rho c of the fluid [kg/(m^2 s)]. \param wet one flag per facet; dry facets do not
    /// answer. \param displacement at the start of the step. \param reference_velocity w at all nodes [m/s].
    void set(double impedance, const std::vector<char>& wet, const Eigen::VectorXd& displacement,
             Eigen::VectorXd reference_velocity);
    void add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const override;
    void add_tangent(const Motion& motion, double scale, double velocity_slope, Matrix& matrix) const override;

private:
    void add_facet(const std::array<int, 4>& facet, double impedance, const Eigen::VectorXd& displacement);

    const Mesh* mesh_;
    const MatrixPattern* pattern_;
    std::vector<std::array<int, 4>> facets_;
    std::vector<int> slots_;              ///< per node: index of its block, -1 for nodes that are on no facet
    std::vector<int> nodes_;              ///< per block: node
    std::vector<Eigen::Matrix3d> blocks_; ///< Z_a; the leading D x D part is used
    Eigen::VectorXd reference_velocity_;
};

} // namespace fem
