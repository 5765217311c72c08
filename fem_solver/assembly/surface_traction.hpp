// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/load.hpp"

#include <memory>

namespace fem {

/// A traction that the surface carries with it. Its components along the reference face's tangents G_k and unit normal
/// are kept, t_0 = c_k G_k + c_n n_0 [Pa per reference area], and act along what the face has become:
///
///     f_a = integral of N_a (c_k g_k dA_0 + c_n n da),     g_k = dx/dxi_k
///
/// The tangential part turns and stretches with the face, the normal part is a follower pressure of -c_n.
/// \param traction t_0, one entry per dimension. \param pattern, mesh outlive the load.
std::unique_ptr<Load> make_follower_traction(const Mesh& mesh, const MatrixPattern& pattern,
                                             const std::vector<MeshFace>& faces, const std::vector<double>& traction);

/// Springs to the ground, f = - K u. They do not take part in the raising of a static load.
class Springs final : public Load {
public:
    /// \param stiffness K with the pattern of the body's matrices [N/m] (2D: N/m^2).
    explicit Springs(Matrix stiffness) : stiffness_(std::move(stiffness)) {}

    void add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const override;
    void add_tangent(const Motion& motion, double scale, double velocity_slope, Matrix& matrix) const override;

private:
    Matrix stiffness_;
};

/// Springs spread over faces, K_ab = integral of k_i N_a N_b dA along axis i. \param stiffness k_i per reference area
/// [N/m^3], one entry per dimension.
Matrix spring_stiffness(const Mesh& mesh, const MatrixPattern& pattern, const std::vector<MeshFace>& faces,
                        const std::vector<double>& stiffness);

} // namespace fem
