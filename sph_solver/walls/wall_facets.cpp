// SPDX-License-Identifier: MIT
#include "sph_solver/walls/wall_facets.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace sph {

template<int D>
void WallFacets<D>::add_fixed(const std::string& body, const std::vector<Vec<D>>& vertices,
                              std::vector<WallFacet<D>> facets)
{
    base::ensure(fixed_facets_ == size(), "fixed walls are added before moving ones");
    bodies_.push_back(body);
    const int first_vertex = static_cast<int>(position_.size());
    position_.insert(position_.end(), vertices.begin(), vertices.end());
    velocity_.resize(position_.size(), Vec<D>::Zero());
    for (auto& facet : facets) facet.body = fixed_bodies_;
    append(facets, first_vertex);
    fixed_facets_ = size();
    fixed_vertices_ = static_cast<int>(position_.size());
    fixed_bodies_ = static_cast<int>(bodies_.size());
}

template<int D>
void WallFacets<D>::set_moving(const std::string& body, const VertexMotion<D>& motion, std::vector<WallFacet<D>> facets)
{
    const auto kept = static_cast<std::size_t>(fixed_facets_);
    facets_.resize(kept);
    corners_.resize(kept);
    normals_.resize(kept);
    bodies_.resize(static_cast<std::size_t>(fixed_bodies_));
    bodies_.push_back(body);
    start_ = motion;
    const auto vertices = static_cast<std::size_t>(fixed_vertices_) + motion.position.size();
    position_.resize(vertices);
    velocity_.resize(vertices);
    for (std::size_t v = 0; v < motion.position.size(); ++v) {
        position_[static_cast<std::size_t>(fixed_vertices_) + v] = motion.position[v];
        velocity_[static_cast<std::size_t>(fixed_vertices_) + v] = motion.velocity[v];
    }
    for (auto& facet : facets) facet.body = fixed_bodies_;
    append(facets, fixed_vertices_);
}

template<int D> void WallFacets<D>::append(const std::vector<WallFacet<D>>& facets, int first_vertex)
{
    const int first = size();
    for (WallFacet<D> facet : facets) {
        for (int& vertex : facet.vertex) vertex += first_vertex;
        facets_.push_back(facet);
    }
    corners_.resize(facets_.size());
    normals_.resize(facets_.size());
    update_facets(first);
}

template<int D> void WallFacets<D>::move(double s)
{
    const auto first = static_cast<std::size_t>(fixed_vertices_);
    for (std::size_t v = 0; v < start_.position.size(); ++v) {
        position_[first + v] = start_.position[v] + s * start_.velocity[v] + (0.5 * s * s) * start_.acceleration[v];
        velocity_[first + v] = start_.velocity[v] + s * start_.acceleration[v];
    }
    update_facets(fixed_facets_);
}

template<int D> void WallFacets<D>::update_facets(int first)
{
    for (auto f = static_cast<std::size_t>(first); f < facets_.size(); ++f) {
        for (std::size_t c = 0; c < D; ++c) corners_[f][c] = position_[static_cast<std::size_t>(facets_[f].vertex[c])];
        const Vec<D> area = base::area_vector(corners_[f]);
        const double measure = area.norm();
        base::require(measure > 0, base::ExitCode::bad_input, "a facet of wall '",
                      bodies_[static_cast<std::size_t>(facets_[f].body)], "' at (", corners_[f][0].transpose(),
                      ") has no extent");
        normals_[f] = area / measure;
    }
}

template<int D> Vec<D> WallFacets<D>::velocity(int facet, const std::array<double, D>& weight) const
{
    Vec<D> value = Vec<D>::Zero();
    const auto& vertex = (*this)[facet].vertex;
    for (std::size_t c = 0; c < D; ++c) value += weight[c] * velocity_[static_cast<std::size_t>(vertex[c])];
    return value;
}

template<int D> Vec<D> WallFacets<D>::acceleration(int facet, const std::array<double, D>& weight) const
{
    Vec<D> value = Vec<D>::Zero();
    if (!moves(facet)) return value;
    const auto& vertex = (*this)[facet].vertex;
    for (std::size_t c = 0; c < D; ++c)
        value += weight[c] * start_.acceleration[static_cast<std::size_t>(vertex[c] - fixed_vertices_)];
    return value;
}

template class WallFacets<2>;
template class WallFacets<3>;

} // namespace sph
