// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack.hpp"
#include "sph_solver/operators/pair_records.hpp"
#include "sph_solver/operators/wall_images.hpp"
#include "sph_solver/walls/mirror_plane.hpp"

#include <array>

/// \file
/// The mirrored states of walls/images.hpp for a pack of images with the same path, in the records' numbers (q = rho/rho0).
namespace sph {

/// One mirroring, with what all images of a group have in common.
template<int D> struct MirrorStep {
    std::array<double, D> normal{};   ///< n
    std::array<double, D> velocity{}; ///< v_w + push n [m/s]
    double push = 0;                  ///< [m/s]
    double offset = 0;                ///< x_w.n [m]
    double pull = 0;                  ///< (g - a_w).n / c0^2 [1/m]
    bool no_slip = false;

    MirrorStep() = default;
    MirrorStep(const MirrorPlane<D>& plane, const Vec<D>& gravity, double c0, double push_now)
        : push(push_now),
          offset(plane.point.dot(plane.normal)),
          pull((gravity - plane.acceleration).dot(plane.normal) / (c0 * c0)),
          no_slip(plane.no_slip)
    {
        for (int a = 0; a < D; ++a) {
            normal[static_cast<std::size_t>(a)] = plane.normal[a];
            velocity[static_cast<std::size_t>(a)] = plane.velocity[a] + push * plane.normal[a];
        }
    }
};

template<int D> using PackVector = std::array<Pack, D>;

template<int D> [[gnu::always_inline]] inline Pack along_normal(const PackVector<D>& a, const std::array<double, D>& n)
{
    Pack sum = a[0] * n[0];
    for (std::size_t k = 1; k < D; ++k) sum = multiply_add(a[k], everywhere(n[k]), sum);
    return sum;
}

/// a + f n
template<int D>
[[gnu::always_inline]] inline void add_along_normal(PackVector<D>& a, Pack f, const std::array<double, D>& n)
{
    for (std::size_t k = 0; k < D; ++k) a[k] = multiply_add(f, everywhere(n[k]), a[k]);
}

/// Images side by side, their values.
template<int D> struct ImagePack {
    PackVector<D> x, velocity; ///< x' [m], v' [m/s]
    Pack ratio;                ///< q'
    std::array<Pack, 3> slope; ///< dq/ds that each mirroring has used, q (g - a_w).n / c^2 [1/m]
};

/// The path of a group, forwards for values and backwards for gradients.
template<int D> class MirrorPath {
public:
    /// \param pushes whether walls push what comes too near: in the forces, not in gradients
    MirrorPath(const ImageGroup& group, const std::vector<MirrorPlane<D>>& planes, const WallSettings<D>& settings,
               double c0, bool pushes)
        : order_(static_cast<std::size_t>(group.order)), least_height_(0.5 * settings.image_distance * settings.spacing)
    {
        for (std::size_t k = 0; k < order_; ++k) {
            const MirrorPlane<D>& plane = planes[static_cast<std::size_t>(group.path[k])];
            steps_[k] = MirrorStep<D>(plane, settings.gravity, c0, pushes ? plane.push : 0.0);
        }
    }

    /// x' = x - 2 s n, q' = q - 2 s slope, v' as the wall wants it, one mirroring after the other.
    /// \param source columns x, v, q, w.  \param has_own lane 0 is the particle itself, which stays off the wall
    [[gnu::always_inline]] inline ImagePack<D> values(const std::array<Pack, 8>& source, bool has_own) const
    {
        ImagePack<D> image;
        for (std::size_t a = 0; a < D; ++a) {
            image.x[a] = source[a];
            image.velocity[a] = source[D + a];
        }
        const Pack q = image.ratio = source[2 * D];
        const Pack inverse_c2 = 1.0 / (q * q * q * q * q * q); // c0^2 / c^2
        for (std::size_t k = 0; k < order_; ++k) {
            const MirrorStep<D>& step = steps_[k];
            Pack s = along_normal<D>(image.x, step.normal) - step.offset;
            if (has_own && k == 0) s[0] = maximum(s[0], least_height_);
            add_along_normal<D>(image.x, -2.0 * s, step.normal);
            image.slope[k] = image.ratio * inverse_c2 * step.pull;
            image.ratio = image.ratio - 2.0 * s * image.slope[k];
            mirror_velocity(image.velocity, step);
        }
        return image;
    }

    /// What pushing adds to v', the same for all images of the group. The volumes' rates go without it.
    std::array<double, D> pushed() const
    {
        std::array<double, D> sum{};
        for (std::size_t k = 0; k < order_; ++k) {
            const MirrorStep<D>& step = steps_[k];
            double along = 0;
            for (std::size_t a = 0; a < D; ++a) along += sum[a] * step.normal[a];
            for (std::size_t a = 0; a < D; ++a)
                sum[a] =
                    (step.no_slip ? -sum[a] : sum[a] - 2 * along * step.normal[a]) + 2 * step.push * step.normal[a];
        }
        return sum;
    }

    /// What the gradients of the images predict along x: grad q'.x and grad v' x.
    /// \param gradient of the sources: columns grad q, then grad v row by row
    template<std::size_t Size>
    [[gnu::always_inline]] inline void predict(Pack& ratio_slope, PackVector<D>& velocity_slope,
                                               const std::array<Pack, Size>& gradient, const ImagePack<D>& image,
                                               const PackVector<D>& x) const
    {
        PackVector<D> back = x; // x seen by the sources: grad (f o mirror) . x = grad f . back
        ratio_slope = Pack{};
        for (std::size_t k = order_; k-- > 0;) {
            const Pack height = along_normal<D>(back, steps_[k].normal);
            ratio_slope += 2.0 * image.slope[k] * height;
            add_along_normal<D>(back, -2.0 * height, steps_[k].normal);
        }
        for (std::size_t b = 0; b < D; ++b) ratio_slope = multiply_add(gradient[b], back[b], ratio_slope);
        for (std::size_t a = 0; a < D; ++a) {
            velocity_slope[a] = gradient[D + a * D] * back[0];
            for (std::size_t b = 1; b < D; ++b)
                velocity_slope[a] = multiply_add(gradient[D + a * D + b], back[b], velocity_slope[a]);
        }
        for (std::size_t k = 0; k < order_; ++k) mirror_slope(velocity_slope, steps_[k]);
    }

private:
    /// v' = v - 2 ((v - v_w).n) n  (slip),   2 v_w - v  (no slip)
    [[gnu::always_inline]] static void mirror_velocity(PackVector<D>& v, const MirrorStep<D>& step)
    {
        for (std::size_t a = 0; a < D; ++a) v[a] = v[a] - step.velocity[a];
        mirror_slope(v, step);
        for (std::size_t a = 0; a < D; ++a) v[a] = v[a] + step.velocity[a];
    }

    [[gnu::always_inline]] static void mirror_slope(PackVector<D>& v, const MirrorStep<D>& step)
    {
        if (step.no_slip) {
            for (std::size_t a = 0; a < D; ++a) v[a] = -v[a];
        } else {
            add_along_normal<D>(v, -2.0 * along_normal<D>(v, step.normal), step.normal);
        }
    }

    std::array<MirrorStep<D>, 3> steps_;
    std::size_t order_;
    double least_height_;
};

} // namespace sph
