// SPDX-License-Identifier: MIT
#include "sph_solver/operators/neighbours_in_reach.hpp"

namespace sph {

template<int D>
void select_in_reach(NeighbourList& reached, const PairRecords<D>& records, const NeighbourList& neighbours,
                     const std::vector<int>& owned, double support)
{
    reached.offsets.resize(neighbours.offsets.size());
    reached.indices.resize(neighbours.indices.size());
    const double limit = support * support;
    int* out = reached.indices.data();
    std::size_t count = 0;
    for (std::size_t k = 0; k < owned.size(); ++k) {
        const double* x_i = records.state(owned[k]);
        reached.offsets[k] = count;
        for (const int j : neighbours.of(k)) {
            const double* x_j = records.state(j);
            double square = 0;
            for (int a = 0; a < D; ++a) square += (x_j[a] - x_i[a]) * (x_j[a] - x_i[a]);
            out[count] = j; // written always, kept where the count moves on: no branch to mispredict
            count += square < limit ? 1 : 0;
        }
    }
    reached.offsets[owned.size()] = count;
    reached.indices.resize(count);
}

template void select_in_reach<2>(NeighbourList&, const PairRecords<2>&, const NeighbourList&, const std::vector<int>&,
                                 double);
template void select_in_reach<3>(NeighbourList&, const PairRecords<3>&, const NeighbourList&, const std::vector<int>&,
                                 double);

} // namespace sph
