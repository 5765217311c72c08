// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace sph {

/// Most planes that one particle mirrors its neighbours in: a corner of three walls, or the end of a narrow gap.
inline constexpr std::size_t max_planes = 3;

/// What is fixed for all images.
template<int D> struct WallSettings {
    double spacing = 0;              ///< particle spacing dx [m]
    double support = 0;              ///< kernel support 2h [m]
    Vec<D> gravity = Vec<D>::Zero(); ///< g [m/s^2]
    double sheet_angle = 3;          ///< touching facets within this angle give one plane [degrees]
    double image_distance = 0.2;     ///< a particle's own image stays this far away [dx]
    double push_from = 0.2;          ///< images push particles that come nearer than this [dx]
    double push_rate = 0;            ///< how fast, per length that is missing [1/s]
    double trap_gap = 0;             ///< water in a gap narrower than this is trapped [dx]
};

/// A half-space that cuts images off: the fluid of another face of the same body begins at normal.x = offset.
template<int D> struct Cut {
    Vec<D> normal = Vec<D>::Zero(); ///< into that fluid
    double offset = 0;              ///< [m]
    double slant = 1;               ///< sine of the angle between it and the plane that is cut
};

/// The wall as one particle sees it: the plane through the nearest point of a sheet of facets.
template<int D> struct MirrorPlane {
    static constexpr std::size_t max_cuts = 8;

    Vec<D> point = Vec<D>::Zero();              ///< x_w [m]
    Vec<D> normal = Vec<D>::Zero();             ///< n, into the fluid
    Vec<D> velocity = Vec<D>::Zero();           ///< v_w [m/s], mean over the footprint of a moving wall
    Vec<D> acceleration = Vec<D>::Zero();       ///< a_w [m/s^2], likewise
    double push = 0;                            ///< speed of the images out of the wall, beyond v_w [m/s]
    double distance = 0;                        ///< (x_i - x_w).n [m], negative inside the wall
    bool no_slip = false;                       ///< images have the velocity 2 v_w - v instead of the mirrored one
    int facet = -1;                             ///< that x_w lies on
    std::array<double, D> weight{};             ///< shape functions of the facet's corners at x_w
    int footprint_begin = 0, footprint_end = 0; ///< of a moving wall: its part of WallContacts::footprints
    std::vector<Cut<D>> cuts;                   ///< max_cuts at most; few planes have any
};

/// One facet's part in a footprint: how much of the force its corners take, and how much of the motion they give.
template<int D> struct FootprintPart {
    int facet = -1;
    std::array<double, D> weight{}; ///< the weights of all parts of a footprint add up to 1
};

/// An owned particle near walls, and its planes: planes[plane_begin .. plane_end) of the list, nearest first.
struct WallContact {
    std::size_t row = 0; ///< k: the particle is particles.owned[k]
    int particle = 0;    ///< local index
    int plane_begin = 0, plane_end = 0;
};

/// All contacts of one instant, ascending in `row`.
template<int D> struct WallContacts {
    std::vector<WallContact> contacts;
    std::vector<MirrorPlane<D>> planes;
    std::vector<FootprintPart<D>> footprints;
};

} // namespace sph
