// SPDX-License-Identifier: MIT
#include "sph_solver/walls/wall_facets.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace sph {

template<int D>
void WallFacets<D>::add_fixed(const WallBody& body, const std::vector<Vec<D>>& vertices,
                              std::vector<WallFacet<D>> facets)
{
    base::ensure(still_facets_ == size(), "walls that stand still are added before those that move");
    add_rigid(body, vertices, std::move(facets));
    still_facets_ = rigid_facets_;
    still_vertices_ = rigid_vertices_;
}

template<int D>
void WallFacets<D>::add_driven(const WallBody& body, const std::vector<Vec<D>>& vertices,
                               std::vector<WallFacet<D>> facets, RigidMotion<D> motion)
{
    driven_.push_back({position_.size(), vertices, std::move(motion)});
    add_rigid(body, vertices, std::move(facets));
    move(0.0);
}

template<int D>
void WallFacets<D>::add_rigid(const WallBody& body, const std::vector<Vec<D>>& vertices,
                              std::vector<WallFacet<D>> facets)
{
    base::ensure(rigid_facets_ == size(), "rigid walls are added before the interface");
    for (auto& facet : facets) facet.body = rigid_bodies_;
    bodies_.push_back(body);
    position_.insert(position_.end(), vertices.begin(), vertices.end());
    resize_vertices(position_.size());
    append(facets, rigid_vertices_);
    rigid_facets_ = size();
    rigid_vertices_ = static_cast<int>(position_.size());
    rigid_bodies_ = static_cast<int>(bodies_.size());
}

template<int D> void WallFacets<D>::resize_vertices(std::size_t count)
{
    position_.resize(count);
    velocity_.resize(count, Vec<D>::Zero());
    acceleration_.resize(count, Vec<D>::Zero());
}

template<int D>
void WallFacets<D>::set_moving(const WallBody& body, const VertexMotion<D>& motion, std::vector<WallFacet<D>> facets)
{
    const auto kept = static_cast<std::size_t>(rigid_facets_);
    facets_.resize(kept);
    corners_.resize(kept);
    normals_.resize(kept);
    bodies_.resize(static_cast<std::size_t>(rigid_bodies_));
    bodies_.push_back(body);
    start_ = motion;
    resize_vertices(static_cast<std::size_t>(rigid_vertices_) + motion.position.size());
    for (auto& facet : facets) facet.body = rigid_bodies_;
    move_interface(0.0);
    append(facets, rigid_vertices_);
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
    for (const Driven& body : driven_) place(body, step_start_ + s);
    move_interface(s);
    update_facets(still_facets_);
}

template<int D> void WallFacets<D>::place(const Driven& body, double time)
{
    const RigidPlace<D> place = body.motion.at(time);
    for (std::size_t v = 0; v < body.in_file.size(); ++v) {
        position_[body.first_vertex + v] = place.position(body.in_file[v]);
        velocity_[body.first_vertex + v] = place.velocity_of(body.in_file[v]);
        acceleration_[body.first_vertex + v] = place.acceleration_of(body.in_file[v]);
    }
}

template<int D> void WallFacets<D>::move_interface(double s)
{
    const auto first = static_cast<std::size_t>(rigid_vertices_);
    for (std::size_t v = 0; v < start_.position.size(); ++v) {
        position_[first + v] = start_.position[v] + s * start_.velocity[v] + (0.5 * s * s) * start_.acceleration[v];
        velocity_[first + v] = start_.velocity[v] + s * start_.acceleration[v];
        acceleration_[first + v] = start_.acceleration[v];
    }
}

template<int D> void WallFacets<D>::update_facets(int first)
{
    for (auto f = static_cast<std::size_t>(first); f < facets_.size(); ++f) {
        for (std::size_t c = 0; c < D; ++c) corners_[f][c] = position_[static_cast<std::size_t>(facets_[f].vertex[c])];
        const Vec<D> area = base::area_vector(corners_[f]);
        const double measure = area.norm();
        base::require(measure > 0, base::ExitCode::bad_input, "a facet of wall '",
                      bodies_[static_cast<std::size_t>(facets_[f].body)].name, "' at (", corners_[f][0].transpose(),
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
    const auto& vertex = (*this)[facet].vertex;
    for (std::size_t c = 0; c < D; ++c) value += weight[c] * acceleration_[static_cast<std::size_t>(vertex[c])];
    return value;
}

template class WallFacets<2>;
template class WallFacets<3>;

} // namespace sph
