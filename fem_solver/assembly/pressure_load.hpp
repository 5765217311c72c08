// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/load.hpp"

#include <array>
#include <functional>
#include <memory>

namespace fem {

/// Pressure [Pa] as a function of a point's reference position (dimension coordinates) [m].
using PressureField = std::function<double(const double* reference)>;

/// Follower pressure on the faces of elements: it stays normal to the current face.
///
///     f_a = - integral of p N_a n da,     n da = face_normal(dx/dxi) dxi        (positive p compresses)
///
/// Its tangent is not symmetric. Quadratic edges are followed as curves.
/// \param pattern, mesh outlive the load.
std::unique_ptr<Load> make_follower_pressure(const Mesh& mesh, const MatrixPattern& pattern,
                                             const std::vector<MeshFace>& faces, const PressureField& pressure);

/// Nodal forces of a pressure that keeps the direction and area of the reference state [N] (2D: N/m).
Eigen::VectorXd dead_pressure_force(const Mesh& mesh, const MatrixPattern& pattern, const std::vector<MeshFace>& faces,
                                    const PressureField& pressure);

/// Nodal forces of a traction per reference area [Pa], the same everywhere on the faces.
Eigen::VectorXd traction_force(const Mesh& mesh, const std::vector<MeshFace>& faces,
                               const std::vector<double>& traction);

/// Follower pressure on linear facets, one value per facet that may change from step to step: the averaged load of
/// the fluid. 2D: segments (a, b, -1, -1); 3D: triangles (a, b, c, -1) and quadrilaterals.
class FacetPressure final : public Load {
public:
    FacetPressure(const Mesh& mesh, const MatrixPattern& pattern, std::vector<std::array<int, 4>> facets);

    /// \param pressure one value per facet [Pa].
    void set(std::vector<double> pressure) { pressure_ = std::move(pressure); }
    void add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const override;
    void add_tangent(const Motion& motion, double scale, double velocity_slope, Matrix& matrix) const override;

private:
    const Mesh* mesh_;
    const MatrixPattern* pattern_;
    std::vector<std::array<int, 4>> facets_;
    std::vector<double> pressure_;
};

} // namespace fem
