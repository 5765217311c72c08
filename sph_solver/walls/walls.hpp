// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/box_grid.hpp"
#include "sph_solver/state/particles.hpp"
#include "sph_solver/walls/contact_finder.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sph {

/// How many particles sit where they must not.
struct Penetration {
    std::int64_t count = 0; ///< particle centres inside a wall
    double deepest = 0;     ///< depth of the deepest one [dx]
};

/// All walls of this rank, still ones, driven ones and the moving interface, as the particles see them: which particles are near
/// walls, and the
/// planes in which each of them mirrors its neighbours (docs/theory/walls.md).
///
/// A step: start_step, set_moving (new motion) -> prepare (with every new neighbour list, or when `stale()`) -> for each stage
/// move(s), find_contacts(particles).
template<int D> class Walls {
public:
    explicit Walls(const WallSettings<D>& settings)
        : settings_(settings), still_grid_(settings.support), moving_grid_(settings.support)
    {}

    const WallSettings<D>& settings() const { return settings_; }
    const WallFacets<D>& facets() const { return facets_; }

    /// A rigid body that does not move: facets with up to four corners (-1: unused) as indices of vertices, whose
    /// coordinates
    /// stand one after the other [m]. 2D: the solid is on the left of a -> b; 3D: counterclockwise seen from the fluid.
    /// All of them come before the first add_driven.
    void add_fixed(const WallBody& body, const std::vector<double>& coordinates,
                   const std::vector<std::array<int, 4>>& facets);
    /// A rigid body that moves as prescribed, facets as above. Before the first set_moving.
    void add_driven(const WallBody& body, const std::vector<double>& coordinates,
                    const std::vector<std::array<int, 4>>& facets, RigidMotion<D> motion);
    /// The step that comes starts at `time` [s]: where driven bodies are follows from it.
    void start_step(double time) { facets_.start_step(time); }
    /// New motion of the interface from the start of the coming step; the facets may be others than before.
    void set_moving(const WallBody& body, const VertexMotion<D>& motion, const std::vector<WallFacet<D>>& facets);
    /// Takes the moving walls to `s` seconds after the start of the step.
    void move(double s) { facets_.move(s); }

    /// Notes the owned particles within reach = support + skin of a wall, and their facets. Holds until the neighbour
    /// list
    /// changes, as long as particles and walls have not moved by more than skin / 2 each.
    void prepare(const Particles<D>& particles, double skin);
    /// Which facets touch which, for the present place of those that move; prepare does it too. To be called at
    /// the start of every step: ranks prepare at different times, what they find must not depend on that.
    void renew_touching();
    /// Other facets than at the last prepare: prepare must be called again.
    bool stale() const { return stale_; }
    /// Largest distance that a corner of any facet has gone since the last prepare [m].
    double largest_displacement() const;

    /// Finds the planes of all owned particles near walls, for the present positions of both.
    void find_contacts(const Particles<D>& particles);
    const WallContacts<D>& contacts() const { return contacts_; }

    /// May two particles interact, or does a wall stand between them? False where the straight way between them goes in
    /// at one side of a plate and out at the other, or leads more than 0.3 dx through a wall in which one of them is
    /// stuck.
    /// Depends on the positions alone and is symmetric. \pre prepare since the last set_moving.
    bool may_interact(const Vec<D>& x_i, const Vec<D>& x_j) const;
    /// May a wall stand between x and anything within reach of it? \pre as for may_interact
    bool may_separate(const Vec<D>& x) const { return !still_grid_.near(x).empty() || !moving_grid_.near(x).empty(); }

    /// Counts the owned particles inside walls; this rank's part. \pre find_contacts
    Penetration penetration() const;

private:
    void fill_grids(double reach);
    /// Calls visit(facet) for all facets, ascending, that may be within reach of x.
    template<class Visit> void visit_near(const Vec<D>& x, Visit&& visit) const
    {
        for (const int f : still_grid_.near(x)) visit(f);
        for (const int f : moving_grid_.near(x)) visit(f);
    }

    WallSettings<D> settings_;
    WallFacets<D> facets_;
    Touching<D> touching_;
    base::BoxGrid<D> still_grid_, moving_grid_; ///< facets, their boxes widened by the reach
    double still_reach_ = -1;                   ///< that of the still grid, negative: it must be made anew
    bool stale_ = true;
    std::vector<Vec<D>> prepared_at_; ///< vertices at the last prepare

    struct Row {
        std::size_t row;
        int begin, end; ///< in candidates_
    };
    std::vector<Row> rows_; ///< owned particles within reach of a wall
    std::vector<int> candidates_;
    WallContacts<D> contacts_;
};

} // namespace sph
