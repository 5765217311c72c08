// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/kernel.hpp"
#include "sph_solver/walls/images.hpp"
#include "sph_solver/walls/walls.hpp"

#include <cmath>
#include <numbers>

/// Walls and fluids for tests. The unit of length is the particle spacing dx; h = 1.23.
namespace sph::sample {

constexpr double smoothing_length = 1.23;

template<int D> WallSettings<D> unit_settings()
{
    WallSettings<D> settings;
    settings.spacing = 1;
    settings.support = 2 * smoothing_length;
    return settings;
}

inline Vec<2> polar(double r, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    return {r * std::cos(angle), r * std::sin(angle)};
}

/// A chain of segments, solid on the left.
inline void add_line(Walls<2>& walls, const std::vector<Vec<2>>& points)
{
    std::vector<double> coordinates;
    std::vector<std::array<int, 4>> facets;
    for (const auto& point : points) coordinates.insert(coordinates.end(), {point.x(), point.y()});
    for (int p = 0; p + 1 < static_cast<int>(points.size()); ++p) facets.push_back({p, p + 1, -1, -1});
    walls.add_fixed({"line"}, coordinates, facets);
}

inline Walls<2> lines(const std::vector<std::vector<Vec<2>>>& chains)
{
    Walls<2> walls(unit_settings<2>());
    for (const auto& chain : chains) add_line(walls, chain);
    return walls;
}

/// The inside of a cube from 0 to `side`, six quadrilaterals.
inline Walls<3> cube_walls(double side)
{
    Walls<3> walls(unit_settings<3>());
    std::vector<double> coordinates;
    for (int v = 0; v < 8; ++v)
        for (int d = 0; d < 3; ++d) coordinates.push_back((v >> d & 1) != 0 ? side : 0.0);
    walls.add_fixed({"cube"}, coordinates,
                    {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}});
    return walls;
}

/// Particles at the given places with volume `volume` each.
template<int D> Particles<D> particles_at(const std::vector<Vec<D>>& positions, double volume = 1)
{
    Particles<D> particles;
    particles.resize(positions.size());
    particles.position = positions;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        particles.id[i] = static_cast<std::int64_t>(i);
        particles.volume[i] = volume;
        particles.velocity[i].setZero();
        particles.density_gradient[i].setZero();
        particles.velocity_gradient[i].setZero();
    }
    particles.own_all();
    return particles;
}

/// The planes of one particle.
template<int D> std::vector<MirrorPlane<D>> planes_at(Walls<D>& walls, const Vec<D>& x)
{
    const auto particles = particles_at<D>({x});
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    return walls.contacts().planes;
}

/// What a particle sees of a fluid that fills a region: kernel integral (1 when all space is filled once) and
/// sum w |W'| n (0 in the same case; the wall's share of it is 0.44 at dx/2 from a flat wall in 2D).
template<int D> struct SeenIn {
    double volume = 0;
    Vec<D> gradient = Vec<D>::Zero();
};
using Seen = SeenIn<2>;

/// x itself and, around it, the points of a fine lattice that lie in the fluid; the lattice is the same for every x.
template<int D, class IsFluid> std::vector<Vec<D>> lattice_around(const Vec<D>& x, const IsFluid& is_fluid, double fine)
{
    const double support = 2 * smoothing_length;
    std::vector<Vec<D>> positions{x};
    const int side = static_cast<int>(std::ceil(2 * support / fine)) + 1;
    for (int k = 0; k < (D == 2 ? side * side : side * side * side); ++k) {
        Vec<D> y;
        for (int d = 0, rest = k; d < D; ++d, rest /= side)
            y[d] = (std::floor((x[d] - support) / fine) + rest % side + 0.5) * fine;
        if ((y - x).norm() < support && (y - x).norm() > 0 && is_fluid(y)) positions.push_back(y);
    }
    return positions;
}

/// Sums over a fluid on a fine lattice and over its images.
template<int D, class IsFluid>
SeenIn<D> look_around(Walls<D>& walls, const Vec<D>& x, const IsFluid& is_fluid, double fine = D == 2 ? 0.05 : 0.15)
{
    const CubicSpline<D> kernel(smoothing_length);
    const auto positions = lattice_around<D>(x, is_fluid, fine);
    std::vector<int> neighbours;
    for (int j = 1; j < static_cast<int>(positions.size()); ++j) neighbours.push_back(j);
    const double volume = std::pow(fine, D);
    Particles<D> particles = particles_at<D>(positions, volume);
    particles.owned = {0};
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);

    SeenIn<D> seen;
    const auto add = [&](const Vec<D>& x_ij, double weight) {
        const double r = x_ij.norm();
        seen.volume += weight * volume * kernel.value(r);
        seen.gradient += (weight * volume * kernel.slope(r) / r) * x_ij;
    };
    for (const int j : neighbours) add(positions[static_cast<std::size_t>(j)] - x, 1.0);
    const ImageFinder<D> finder(walls.settings());
    for (const WallContact& contact : walls.contacts().contacts)
        finder.for_each(contact, walls.contacts().planes, positions, neighbours, [&](const Image<D>& image) {
            if (image.source != 0) add(image.x_ij, image.weight);
        });
    return seen;
}

} // namespace sph::sample
