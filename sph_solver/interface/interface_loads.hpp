// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/box_grid.hpp"
#include "coupler_lib/coupling/surface.hpp"
#include "sph_solver/walls/walls.hpp"

#include <vector>

namespace sph {

/// Gathers the loads of this rank's particles on the moving facets over one step, with the Runge-Kutta weights.
///
/// (b) Conservative, always: the force at every wall point goes to the corners of its footprint (walls/footprint.hpp), with the
/// weights that made the wall point's velocity, so that force and power are those of the fluid.
///
/// (a) Averaged, on demand: the pressure of a facet is sum w_j p_j* / sum w_j over the particles within 1.5 dx whose nearest
/// wall point lies on the facet or, where it is smaller than 2 dx, on its patch: the part of the sheet within dx of its centre.
///
///     p_j* = p_j + rho_j (g - a_w).(x_w - x_j)
///
/// A facet is one of the batch's (a quadrilateral counts as one), and the loads are in the batch's order.
template<int D> class InterfaceLoads {
public:
    /// \param averaged gather (a) too.
    InterfaceLoads(const WallSettings<D>& settings, bool averaged) : settings_(settings), averaged_(averaged) {}

    /// Starts a step: all loads zero, patches for the facets where they are now. \param facet_count of the batch
    void begin(const Walls<D>& walls, std::size_t facet_count);

    /// The facets have moved within the window; loads add up.
    void follow(const Walls<D>& walls);

    /// Adds one evaluation. \param on_wall force at each plane of walls.contacts() [N]  \param weight Runge-Kutta weight
    void add(const Particles<D>& particles, const Walls<D>& walls, const std::vector<Vec<D>>& on_wall, double weight);

    const coupler::FacetLoads& loads() const { return loads_; }

private:
    /// A facet of the batch as the averaged load sees it.
    struct Patch {
        Vec<D> area = Vec<D>::Zero();     ///< normal times measure, summed over the pieces
        Vec<D> moment = Vec<D>::Zero();   ///< sum of measure times centre
        double measure = 0;               ///< [m^(D-1)]
        Vec<D> centre() const { return moment / measure; }
    };
    void make_patches(const Walls<D>& walls);
    bool is_small(const Patch& patch) const;
    bool same_sheet(const Patch& patch, const Vec<D>& normal) const;
    double patch_measure(const Walls<D>& walls, const Patch& patch) const;
    void add_force(const Walls<D>& walls, const MirrorPlane<D>& plane, const Vec<D>& force);
    void add_average(const Particles<D>& particles, std::size_t i, const MirrorPlane<D>& plane, int source,
                     const Vec<D>& normal, double weight);

    WallSettings<D> settings_;
    bool averaged_;
    coupler::FacetLoads loads_;
    std::vector<Patch> patches_;
    base::BoxGrid<D> grid_{1.0}; ///< balls of radius dx around the centres of small facets
};

} // namespace sph
