// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/geometry.hpp"
#include "sph_solver/numerics/vector.hpp"
#include "sph_solver/walls/rigid_motion.hpp"

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

/// What a wall is called, and how water goes along it.
struct WallBody {
    std::string name = {};
    bool no_slip = false; ///< water sticks to it (images with 2 v_w - v); else it slips
};

/// Vertices that move, with their state at the start of the step; arrays of [vertices].
template<int D> struct VertexMotion {
    std::vector<Vec<D>> position;     ///< X [m]
    std::vector<Vec<D>> velocity;     ///< V [m/s]
    std::vector<Vec<D>> acceleration; ///< A [m/s^2]
};

/// All facets of this rank, and where they are within the step: first the walls that stand still, then the rigid bodies
/// with a prescribed motion, then the facets of the interface. A vertex of a driven body is where its motion says, one of
/// the interface moves as
///
///     x(s) = X + V s + A s^2 / 2,   v(s) = V + A s,   a = A,   s = time since the start of the step
///
/// and a facet's points follow its corners linearly.
template<int D> class WallFacets {
public:
    /// Adds a body that stands still; `facets` count its vertices from 0. Before all that move.
    void add_fixed(const WallBody& body, const std::vector<Vec<D>>& vertices, std::vector<WallFacet<D>> facets);

    /// Adds a rigid body that moves as prescribed. Before any interface.
    void add_driven(const WallBody& body, const std::vector<Vec<D>>& vertices, std::vector<WallFacet<D>> facets,
                    RigidMotion<D> motion);

    /// Replaces the facets of the interface. `facets` count vertices from 0 = the first of the interface.
    void set_moving(const WallBody& body, const VertexMotion<D>& motion, std::vector<WallFacet<D>> facets);

    /// The step starts at time t [s]: driven bodies take their places from it. The interface has its own motion.
    void start_step(double time) { step_start_ = time; }

    /// Takes all that moves to `s` seconds after the start of the step.
    void move(double s);

    int size() const { return static_cast<int>(facets_.size()); }
    int first_of_interface() const { return rigid_facets_; }
    int still_facets() const { return still_facets_; } ///< the facets before all that move
    /// Is the facet a part of the interface?
    bool is_wet(int facet) const { return facet >= rigid_facets_; }
    const WallFacet<D>& operator[](int facet) const { return facets_[static_cast<std::size_t>(facet)]; }
    const base::Simplex<D>& corners(int facet) const { return corners_[static_cast<std::size_t>(facet)]; }
    const Vec<D>& normal(int facet) const { return normals_[static_cast<std::size_t>(facet)]; } ///< into the fluid
    Vec<D> velocity(int facet, const std::array<double, D>& weight) const;     ///< [m/s] at a point of the facet
    Vec<D> acceleration(int facet, const std::array<double, D>& weight) const; ///< [m/s^2] at a point of the facet
    const std::vector<WallBody>& bodies() const { return bodies_; }
    const WallBody& body_of(int facet) const { return bodies_[static_cast<std::size_t>((*this)[facet].body)]; }
    const std::vector<Vec<D>>& positions() const { return position_; } ///< of all vertices, now [m]
    int rigid_vertices() const { return rigid_vertices_; }             ///< all before the interface
    int still_vertices() const { return still_vertices_; }             ///< all before the driven bodies

private:
    struct Driven {
        std::size_t first_vertex;
        std::vector<Vec<D>> in_file; ///< X of its vertices [m]
        RigidMotion<D> motion;
    };
    void add_rigid(const WallBody& body, const std::vector<Vec<D>>& vertices, std::vector<WallFacet<D>> facets);
    void resize_vertices(std::size_t count);
    void place(const Driven& body, double time);
    void move_interface(double s);
    void append(const std::vector<WallFacet<D>>& facets, int first_vertex);
    void update_facets(int first);

    std::vector<WallBody> bodies_;
    std::vector<WallFacet<D>> facets_;
    std::vector<base::Simplex<D>> corners_;
    std::vector<Vec<D>> normals_;
    std::vector<Vec<D>> position_, velocity_, acceleration_; ///< now, of all vertices
    std::vector<Driven> driven_;
    VertexMotion<D> start_; ///< of the interface's vertices
    double step_start_ = 0; ///< [s]
    int still_facets_ = 0, still_vertices_ = 0;
    int rigid_facets_ = 0, rigid_vertices_ = 0, rigid_bodies_ = 0;
};

} // namespace sph
