// SPDX-License-Identifier: MIT
// A flat wet surface of a given number of points for bench_coupler, cut into strips for the ranks of both sides.
#pragma once
#include "coupler_lib/coupling/surface.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

/// The unit line or square as segments or quadrilaterals; the part of one of the solid's ranks: a range of x.
inline coupler::WetSurface strip(int dimension, int points, int rank, int ranks)
{
    const int rows = dimension == 2 ? 1 : static_cast<int>(std::lround(std::sqrt(points)));
    const int cells = points / rows - 1; // along x
    const int from = cells * rank / ranks, to = cells * (rank + 1) / ranks;
    coupler::WetSurface surface;
    surface.dimension = dimension;
    for (int i = from; i <= to; ++i)
        for (int j = 0; j < rows; ++j) {
            surface.node_ids.push_back(static_cast<std::int64_t>(i) * rows + j);
            surface.reference.push_back(static_cast<double>(i) / cells);
            surface.reference.push_back(dimension == 2 ? 0.0 : static_cast<double>(j) / (rows - 1));
            if (dimension == 3) surface.reference.push_back(0.0);
        }
    for (int i = from; i < to; ++i)
        for (int j = 0; j < std::max(rows - 1, 1); ++j) {
            const int a = (i - from) * rows + j, b = a + rows;
            surface.facet_ids.push_back(static_cast<std::int64_t>(i) * rows + j);
            surface.facet_nodes.push_back(dimension == 2 ? std::array<int, 4>{a, b, -1, -1}
                                                         : std::array<int, 4>{a, b, b + 1, a + 1});
        }
    return surface;
}

/// The part of a fluid rank: a range of x.
inline coupler::RegionBox slice(int rank, int ranks)
{
    const double low = static_cast<double>(rank) / ranks, high = static_cast<double>(rank + 1) / ranks;
    return {{low, -1, -1}, {high, 2, 2}};
}

/// A conservative load on every corner.
inline coupler::FacetLoads loads_on(const coupler::FacetBatch& batch)
{
    coupler::FacetLoads loads;
    const auto dimension = static_cast<std::size_t>(batch.dimension);
    loads.corner_force.resize(4 * batch.facet_ids.size() * dimension);
    for (std::size_t facet = 0; facet < batch.facet_ids.size(); ++facet)
        for (std::size_t corner = 0; corner < 4 && batch.facet_nodes[facet][corner] >= 0; ++corner)
            for (std::size_t d = 0; d < dimension; ++d)
                loads.corner_force[(4 * facet + corner) * dimension + d].add(1.0 + 0.1 * static_cast<double>(facet));
    return loads;
}

} // namespace bench
