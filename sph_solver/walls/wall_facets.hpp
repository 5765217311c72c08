// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/geometry.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <array>
#include <string>
#include <vector>

namespace sph {

/// A piece of a wall: a segment (2D) or a triangle (3D), by the numbers of its vertices. The body lies on the left of a
/// segment; a triangle's corners run counterclockwise seen from the fluid. So the normal points into the fluid.
template<int D> struct WallFacet {
    std::array<int, D> vertex{};
    int body = 0;                ///< index into the names of the bodies
    int source = -1;             ///< facet of the body or batch that it is a part of
    std::array<int, D> corner{}; ///< which corner of the source each of my corners is
};

/// Vertices that move, with their state at the start of the step; arrays of [vertices].
template<int D> struct VertexMotion {
    std::vector<Vec<D>> position;     ///< X [m]
    std::vector<Vec<D>> velocity;     ///< V [m/s]
    std::vector<Vec<D>> acceleration; ///< A [m/s^2]
};

/// All facets of this rank: first the fixed walls, then the moving facets of the interface, and where they are within
/// the step. A vertex moves as
///
///     x(s) = X + V s + A s^2 / 2,   v(s) = V + A s,   a = A,   s = time since the start of the step
///
/// and a facet's points follow its corners linearly.
template<int D> class WallFacets {
public:
    /// Adds facets that do not move as one body; `facets` count its vertices from 0. Before any moving ones.
    void add_fixed(const std::string& body, const std::vector<Vec<D>>& vertices, std::vector<WallFacet<D>> facets);

    /// Replaces the moving facets. `facets` count vertices from 0 = the first moving one.
    void set_moving(const std::string& body, const VertexMotion<D>& motion, std::vector<WallFacet<D>> facets);

    /// Takes the moving vertices to `s` seconds after the start of the step.
    void move(double s);

    int size() const { return static_cast<int>(facets_.size()); }
    int first_moving() const { return fixed_facets_; }
    bool moves(int facet) const { return facet >= fixed_facets_; }
    const WallFacet<D>& operator[](int facet) const { return facets_[static_cast<std::size_t>(facet)]; }
    const base::Simplex<D>& corners(int facet) const { return corners_[static_cast<std::size_t>(facet)]; }
    const Vec<D>& normal(int facet) const { return normals_[static_cast<std::size_t>(facet)]; } ///< into the fluid
    Vec<D> velocity(int facet, const std::array<double, D>& weight) const;     ///< [m/s] at a point of the facet
    Vec<D> acceleration(int facet, const std::array<double, D>& weight) const; ///< [m/s^2] at a point of the facet
    const std::vector<std::string>& bodies() const { return bodies_; }
    const std::vector<Vec<D>>& positions() const { return position_; } ///< of all vertices, now [m]
    int fixed_vertices() const { return fixed_vertices_; }

private:
    void append(const std::vector<WallFacet<D>>& facets, int first_vertex);
    void update_facets(int first);

    std::vector<std::string> bodies_;
    std::vector<WallFacet<D>> facets_;
    std::vector<base::Simplex<D>> corners_;
    std::vector<Vec<D>> normals_;
    std::vector<Vec<D>> position_, velocity_; ///< now, of all vertices
    VertexMotion<D> start_;                   ///< of the moving vertices
    int fixed_facets_ = 0, fixed_vertices_ = 0, fixed_bodies_ = 0;
};

} // namespace sph
