// SPDX-License-Identifier: MIT
#include "sph_solver/walls/rigid_motion.hpp"

#include <cmath>

namespace sph {
namespace {

template<int D> Mat<D> cross_matrix(const Vec<3>& axis)
{
    Mat<D> k = Mat<D>::Zero();
    if constexpr (D == 2) {
        k << 0, -1, 1, 0;
    } else {
        k << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
    }
    return k;
}

} // namespace

template<int D> RigidPlace<D> RigidMotion<D>::at(double t) const
{
    RigidPlace<D> place;
    place.centre = centre;
    for (int a = 0; a < D; ++a) {
        const base::TimeFunction& along = translation[static_cast<std::size_t>(a)];
        if (!along) continue;
        const base::TimeValue d = along(t);
        place.displacement[a] = d.value;
        place.velocity[a] = d.rate;
        place.acceleration[a] = d.acceleration;
    }
    if (!rotation) return place;
    const base::TimeValue theta = rotation(t);
    const Mat<D> k = cross_matrix<D>(axis);
    const Mat<D> kk = k * k;
    place.turn += std::sin(theta.value) * k + (1 - std::cos(theta.value)) * kk;
    place.spin = theta.rate * k * place.turn;
    place.spin_rate = (theta.acceleration * k + (theta.rate * theta.rate) * kk) * place.turn;
    return place;
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;

} // namespace sph
