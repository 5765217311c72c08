// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

#include <Eigen/Core>

#include <vector>

namespace fem {

/// A place of the body's surface where contact is looked for; its position is the sum of values[a] x[nodes[a]].
struct ContactPoint {
    std::vector<int> nodes;
    std::vector<double> values;
    double area = 0;        ///< its part of the reference surface [m^2] (2D: m)
    double size = 0;        ///< of the faces around it [m]
    std::vector<int> faces; ///< the faces it belongs to, in the order given
    bool own = true;        ///< this rank's; others lie in its halo, with part of their area
};

/// Points of a group of faces: the nodes, each with the area A_a = sum of the integrals of N_a over its faces, which gives
/// a uniform pressure its exact nodal forces. One condition a node is what the surface can meet on a curved ground as
/// well. Corners of six-node triangles, which have no area where the face is flat, are left out. Faces of eight nodes (hexa20), whose corners have
/// a negative area, take their 2 x 2 integration points instead.
std::vector<ContactPoint> contact_points(const Mesh& mesh, const std::vector<MeshFace>& faces);

/// Area of each face in a given position [m^2] (2D: m). \param displacement of all nodes [m].
std::vector<double> face_areas(const Mesh& mesh, const std::vector<MeshFace>& faces,
                               const Eigen::VectorXd& displacement);

/// Stiffness of a surface per area [Pa/m]: the mean over its points of the largest diagonal entry of the nodes' stiffness over
/// the point's area; the scale of a good penalty. Collective. \param diagonal of the stiffness matrix, right in the halo as
/// well [N/m] (2D: N/m^2).
double surface_stiffness(const std::vector<ContactPoint>& points, const Eigen::VectorXd& diagonal, const Mesh& mesh);

} // namespace fem
