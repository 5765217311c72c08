// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pair_flux.hpp"
#include "sph_solver/state/particles.hpp"
#include "sph_solver/walls/mirror_plane.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace sph {

/// One image of particle j as particle i sees it: j mirrored in path[0], then in path[1], ...
template<int D> struct Image {
    int source = 0;               ///< j, or i itself
    Vec<D> x_ij = Vec<D>::Zero(); ///< from i to the image [m]
    double squared_distance = 0;  ///< |x_ij|^2 [m^2]
    double weight = 1;            ///< share of the source's volume that the image has, in (0, 1]
    int order = 0;                ///< number of mirrorings, 1 to 3
    std::array<const MirrorPlane<D>*, 3> path{};
    std::array<double, 3> height{}; ///< over path[k] before the k-th mirroring [m], positive
};

/// Finds all images that a particle sees, without storing them.
///
/// A neighbour j (and i itself) with s = (x_j - x_w).n > 0 has the image x' = x_j - 2 s n; in a corner the images of
/// two
/// planes are mirrored again in the other one, up to three times. So that every piece of space behind the walls is
/// filled once, whatever the corner's angle, an image made by plane P last counts only where it is deeper behind P than
/// behind any other plane in front of which j stands (with a linear change over 0.3 dx, both together always 1), and
/// fades out
/// at a cut of P, within a quarter of dx along the wall.
template<int D> class ImageFinder {
public:
    explicit ImageFinder(const WallSettings<D>& settings)
        : squared_support_(settings.support * settings.support),
          blend_(0.15 * settings.spacing),
          fade_(0.25 * settings.spacing),
          least_height_(0.5 * settings.image_distance * settings.spacing)
    {}

    /// Calls visit(const Image<D>&) for i's own images, then for those of its neighbours, in the order of the list.
    template<class Visit>
    void for_each(const WallContact& contact, const std::vector<MirrorPlane<D>>& planes,
                  const std::vector<Vec<D>>& position, std::span<const int> neighbours, Visit&& visit) const
    {
        const std::span<const MirrorPlane<D>> mine(planes.data() + contact.plane_begin,
                                                   static_cast<std::size_t>(contact.plane_end - contact.plane_begin));
        const Vec<D>& x_i = position[static_cast<std::size_t>(contact.particle)];
        images_of(contact.particle, x_i, x_i, mine, least_height_, visit);
        for (const int j : neighbours) {
            const Vec<D>& x_j = position[static_cast<std::size_t>(j)];
            if ((x_j - x_i).squaredNorm() < squared_support_) images_of(j, x_j, x_i, mine, 0.0, visit);
        }
    }

private:
    struct Source {
        const Vec<D>&x_j, &x_i;
        std::span<const MirrorPlane<D>> planes;
        std::array<double, max_planes> height; ///< of x_j over each plane [m]
    };

    template<class Visit>
    void images_of(int j, const Vec<D>& x_j, const Vec<D>& x_i, std::span<const MirrorPlane<D>> planes, double least,
                   Visit& visit) const
    {
        Source source{x_j, x_i, planes, {}};
        for (std::size_t p = 0; p < planes.size(); ++p) {
            source.height[p] = (x_j - planes[p].point).dot(planes[p].normal);
            if (least > 0) source.height[p] = std::max(source.height[p], least);
        }
        Image<D> image;
        image.source = j;
        for (std::size_t p = 0; p < planes.size(); ++p) extend(image, x_j, source, p, visit);
    }

    /// Mirrors what stands at x in plane p, reports the image, and goes on to the planes not yet used.
    template<class Visit>
    void extend(Image<D> image, const Vec<D>& x, const Source& source, std::size_t p, Visit& visit) const
    {
        const MirrorPlane<D>& plane = source.planes[p];
        const double s = image.order == 0 ? source.height[p] : (x - plane.point).dot(plane.normal);
        if (source.height[p] <= 0 || s <= 0) return;
        const Vec<D> x_image = x - (2 * s) * plane.normal;
        image.x_ij = x_image - source.x_i;
        image.squared_distance = image.x_ij.squaredNorm();
        if (image.squared_distance >= squared_support_) return;
        if (image.order < 2 || image.path[0] != &plane)
            image.weight *= within_cuts(plane, source.x_j - (2 * source.height[p]) * plane.normal);
        if (image.weight <= 0) return;
        const auto step = static_cast<std::size_t>(image.order++);
        image.path[step] = &plane;
        image.height[step] = s;
        const double whole = image.weight;
        image.weight *= share_of(p, x_image, source);
        if (image.weight > 0) visit(static_cast<const Image<D>&>(image));
        image.weight = whole;
        if (image.order == 3) return;
        for (std::size_t q = 0; q < source.planes.size(); ++q)
            if (may_follow(image, &source.planes[q])) extend(image, x_image, source, q, visit);
    }

    /// Not the same plane twice running; and of the two orders that lead to the image in three planes only one.
    static bool may_follow(const Image<D>& image, const MirrorPlane<D>* next)
    {
        if (next == image.path[static_cast<std::size_t>(image.order - 1)]) return false;
        return image.order < 2 || next == image.path[0] || image.path[0] < image.path[1];
    }

    /// Share that plane p has in the space around x: 1 where x lies deeper behind p than behind all others, 0 where
    /// less deep.
    double share_of(std::size_t p, const Vec<D>& x, const Source& source) const
    {
        const std::size_t count = source.planes.size();
        if (count == 1) return 1;
        std::array<double, max_planes> depth{};
        for (std::size_t q = 0; q < count; ++q) depth[q] = (source.planes[q].point - x).dot(source.planes[q].normal);
        double sum = 0, mine = 0;
        for (std::size_t k = 0; k < count; ++k) {
            double claim = 1;
            for (std::size_t q = 0; q < count; ++q)
                if (q != k && source.height[q] > 0)
                    claim *= std::clamp(0.5 + (depth[k] - depth[q]) / (2 * blend_), 0.0, 1.0);
            if (k == p) mine = claim;
            if (source.height[k] > 0) sum += claim;
        }
        return mine > 0 ? mine / sum : 0;
    }

    double within_cuts(const MirrorPlane<D>& plane, const Vec<D>& x) const
    {
        double weight = 1;
        for (const Cut<D>& cut : plane.cuts)
            weight *= std::clamp(0.5 - (cut.normal.dot(x) - cut.offset) / (fade_ * cut.slant), 0.0, 1.0);
        return weight;
    }

    double squared_support_, blend_, fade_, least_height_;
};

/// The image's state: that of its source, mirrored in one plane after the other (s = height over the plane, R = I - 2
/// n n):
///
/// with v_w + push n for v_w very near the wall,
///
///     v' = v - 2 ((v - v_w).n) n  (slip),   2 v_w - v  (no slip)         grad v' = R grad v R,   - grad v R
///     p' = p + rho (g - a_w).(x' - x),   rho' = rho + (p' - p)/c^2       grad rho' = R grad rho + 2 rho ((g -
/// a_w).n)/c^2 n
///
/// For one image at a time, in plain numbers: what the packs of operators/image_packs.hpp are held against.
/// \param state in: of the source; out: of the image.  \param sound_speed c of the source [m/s]
template<int D>
void mirror_state(PrimitiveState<D>& state, const Image<D>& image, double sound_speed, const WallSettings<D>& settings)
{
    for (int k = 0; k < image.order; ++k) {
        const MirrorPlane<D>& plane = *image.path[static_cast<std::size_t>(k)];
        const Vec<D>& n = plane.normal;
        const double slope =
            state.density * (settings.gravity - plane.acceleration).dot(n) / (sound_speed * sound_speed);
        state.density -= 2 * image.height[static_cast<std::size_t>(k)] * slope;
        state.density_gradient += (2 * (slope - state.density_gradient.dot(n))) * n;
        const Vec<D> along = state.velocity_gradient * n;
        Mat<D> gradient = state.velocity_gradient - (2 * along) * n.transpose(); // grad v R
        if (plane.no_slip) {
            state.velocity = 2 * (plane.velocity + plane.push * n) - state.velocity;
            state.velocity_gradient = -gradient;
        } else {
            state.velocity -= (2 * ((state.velocity - plane.velocity).dot(n) - plane.push)) * n;
            state.velocity_gradient = gradient - (2 * n) * (n.transpose() * gradient).eval();
        }
    }
}

} // namespace sph
