// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/surface.hpp"
#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/mesh/linear_facets.hpp"

namespace fem {

/// The part of the body's surface that the fluid may touch, and the way between surface arrays (one entry per wet
/// node, ascending) and the body's own vectors (one per node of the mesh). On several ranks it holds the facets of the
/// halo as well; each facet is registered by the rank that owns its element.
class WetBoundary {
public:
    /// Collective. \throws base::Error bad_input when a group is unknown or none is named.
    WetBoundary(const Mesh& mesh, const std::vector<std::string>& groups);

    /// Linear facets on the mesh's node ids, see linear_facets.
    const std::vector<std::array<int, 4>>& facets() const { return facets_; }
    /// Nodes of the facets, ascending.
    const std::vector<int>& surface_nodes() const { return nodes_; }
    /// As the coupling library wants it registered: this rank's own facets and their nodes.
    coupler::WetSurface surface() const;
    /// Of the registered nodes.
    coupler::SurfaceMotion motion(const Motion& motion) const;
    /// The load on all facets and nodes of this boundary, from those that all ranks received for their own: forces are
    /// summed in rank order. Collective. \param own of the registered facets and nodes.
    coupler::SurfaceLoad complete(const coupler::SurfaceLoad& own) const;
    /// A surface array spread over all nodes of the mesh, zero elsewhere.
    Eigen::VectorXd spread(const std::vector<double>& surface_values) const;
    /// Entry per surface node of a vector over all nodes.
    std::vector<double> gather(const Eigen::VectorXd& field) const;
    /// Length of the largest displacement of a wet node [m]. Collective.
    double largest_displacement(const Motion& motion) const;

private:
    void number_facets(const std::vector<MeshFace>& faces);
    std::vector<double> gather(const Eigen::VectorXd& field, const std::vector<int>& nodes) const;

    const Mesh* mesh_;
    std::vector<std::array<int, 4>> facets_;
    std::vector<std::int64_t> facet_ids_; ///< in the whole surface, the same on any number of ranks
    std::vector<int> own_facets_;         ///< indices of those registered here
    std::vector<int> nodes_, own_nodes_;  ///< of all facets, and of those registered here
};

/// Force and moment about the origin of nodal forces [N, N m] (2D: N/m, N), at the current positions. Collective.
struct Resultants {
    std::array<double, 3> force{}, moment{};
};
Resultants resultants(const Mesh& mesh, const Motion& motion, const Eigen::VectorXd& forces);

} // namespace fem
