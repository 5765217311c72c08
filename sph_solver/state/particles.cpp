// SPDX-License-Identifier: MIT
#include "sph_solver/state/particles.hpp"

#include <numeric>

namespace sph {

template<int D> void Particles<D>::resize(std::size_t count)
{
    for_each_field(*this, [&](const FieldInfo&, auto& column) { column.resize(count); });
    renormaliser.assign(count, Mat<D>::Identity());
    shift.assign(count, Vec<D>::Zero());
    is_owned.resize(count);
}

template<int D> void Particles<D>::own_all()
{
    owned.resize(size());
    std::iota(owned.begin(), owned.end(), 0);
    is_owned.assign(size(), 1);
}

template<int D> void Rates<D>::reset(std::size_t count)
{
    volume.assign(count, 0.0);
    mass.assign(count, 0.0);
    momentum.assign(count, Vec<D>::Zero());
}

template struct Particles<2>;
template struct Particles<3>;
template struct Rates<2>;
template struct Rates<3>;

} // namespace sph
