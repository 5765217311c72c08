// SPDX-License-Identifier: MIT
#include "coupled_world.hpp"

#include <algorithm>
#include <cmath>
#include <mpi.h>

namespace coupled_test {
namespace {

std::array<int, 4> corners(std::initializer_list<int> nodes)
{
    std::array<int, 4> list{-1, -1, -1, -1};
    std::copy(nodes.begin(), nodes.end(), list.begin());
    return list;
}

void add_line(coupler::WetSurface& surface)
{
    constexpr int facets = 60;
    for (int k = 0; k <= facets; ++k) {
        const double x = 4.0 * k / facets;
        surface.reference.insert(surface.reference.end(), {x, 0.3 * std::sin(3 * x)});
    }
    for (int k = 0; k < facets; ++k) surface.facet_nodes.push_back(corners({k, k + 1}));
}

void add_sheet(coupler::WetSurface& surface)
{
    constexpr int cells = 8;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const double x = 4.0 * i / cells, y = 2.0 * j / cells;
            surface.reference.insert(surface.reference.end(), {x, y, 0.3 * std::sin(3 * x + y)});
        }
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const int a = i * (cells + 1) + j, b = a + cells + 1, c = b + 1, d = a + 1;
            if ((i + j) % 3 == 0) {
                surface.facet_nodes.push_back(corners({a, b, c}));
                surface.facet_nodes.push_back(corners({a, c, d}));
            } else {
                surface.facet_nodes.push_back(corners({a, b, c, d}));
            }
        }
}

} // namespace

int world_rank()
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

int world_size()
{
    int size = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
}

coupler::ParticipantSettings settings_for(int fluid_ranks)
{
    coupler::ParticipantSettings settings;
    settings.role = world_rank() < fluid_ranks ? "fluid" : "solid";
    settings.expected_roles = {"fluid", "solid"};
    settings.handshake_timeout = 20;
    settings.silence_timeout = 20;
    return settings;
}

std::vector<int> all_splits()
{
    std::vector<int> splits;
    for (int fluid = 1; fluid < world_size(); ++fluid) splits.push_back(fluid);
    return splits;
}

coupler::WetSurface whole_surface(int dimension, unsigned seed)
{
    coupler::WetSurface surface;
    surface.dimension = dimension;
    dimension == 2 ? add_line(surface) : add_sheet(surface);
    const std::size_t nodes = surface.reference.size() / static_cast<std::size_t>(dimension);
    for (std::size_t k = 0; k < nodes; ++k) surface.node_ids.push_back(1000 + 7 * static_cast<std::int64_t>(k));
    for (std::size_t k = 0; k < surface.facet_nodes.size(); ++k)
        surface.facet_ids.push_back(3 * static_cast<std::int64_t>(k) + 1);
    std::mt19937 random(seed);
    std::shuffle(surface.node_ids.begin(), surface.node_ids.end(), random);
    std::shuffle(surface.facet_ids.begin(), surface.facet_ids.end(), random);
    return surface;
}

coupler::WetSurface dealt_surface(const coupler::WetSurface& whole, int rank, int ranks, unsigned seed)
{
    std::mt19937 random(seed);
    coupler::WetSurface mine;
    mine.dimension = whole.dimension;
    std::vector<int> place(whole.node_ids.size(), -1);
    for (std::size_t facet = 0; facet < whole.facet_ids.size(); ++facet) {
        const int owner = static_cast<int>(random() % static_cast<unsigned>(ranks));
        if (owner != rank) continue;
        std::array<int, 4> nodes{-1, -1, -1, -1};
        for (std::size_t k = 0; k < 4 && whole.facet_nodes[facet][k] >= 0; ++k) {
            const auto node = static_cast<std::size_t>(whole.facet_nodes[facet][k]);
            if (place[node] < 0) {
                place[node] = static_cast<int>(mine.node_ids.size());
                mine.node_ids.push_back(whole.node_ids[node]);
                const double* at = &whole.reference[node * static_cast<std::size_t>(whole.dimension)];
                mine.reference.insert(mine.reference.end(), at, at + whole.dimension);
            }
            nodes[k] = place[node];
        }
        mine.facet_ids.push_back(whole.facet_ids[facet]);
        mine.facet_nodes.push_back(nodes);
    }
    return mine;
}

double nodal_value(std::int64_t node_id, int component, int step)
{
    return std::sin(0.7 * static_cast<double>(node_id) + 1.3 * component + 0.1 * step);
}

coupler::SurfaceMotion motion_of(const coupler::WetSurface& surface, int step)
{
    coupler::SurfaceMotion motion;
    motion.position = surface.reference;
    std::size_t at = 0;
    for (const std::int64_t id : surface.node_ids)
        for (int d = 0; d < surface.dimension; ++d, ++at) {
            motion.position[at] += 0.01 * nodal_value(id, d, step);
            motion.velocity.push_back(nodal_value(id, d + 10, step));
            motion.acceleration.push_back(nodal_value(id, d + 20, step));
        }
    return motion;
}

std::vector<PointLoad> random_loads(const coupler::WetSurface& whole, int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<PointLoad> loads(static_cast<std::size_t>(count));
    for (PointLoad& load : loads) {
        const std::size_t facet = random() % whole.facet_ids.size();
        load.facet_id = whole.facet_ids[facet];
        const double s = unit(random), t = unit(random);
        if (whole.dimension == 2)
            load.shape = {1 - s, s, 0, 0};
        else if (whole.facet_nodes[facet][3] < 0)
            load.shape = {1 - s, s * (1 - t), s * t, 0};
        else
            load.shape = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
        for (int d = 0; d < whole.dimension; ++d) load.force[static_cast<std::size_t>(d)] = 1e3 * (unit(random) - 0.5);
        load.weight = 1e-3 * unit(random);
        load.pressure = 1e4 * (unit(random) - 0.3);
    }
    return loads;
}

void add_load(coupler::FacetLoads& loads, const coupler::FacetBatch& batch, const PointLoad& load)
{
    const auto facet = static_cast<std::size_t>(find_id(batch.facet_ids, load.facet_id));
    const auto dimension = static_cast<std::size_t>(batch.dimension);
    for (std::size_t corner = 0; corner < 4; ++corner)
        for (std::size_t d = 0; d < dimension; ++d)
            loads.corner_force[(4 * facet + corner) * dimension + d].add(load.shape[corner] * load.force[d]);
    loads.weight[facet].add(load.weight);
    loads.weighted_pressure[facet].add(load.weight * load.pressure);
}

coupler::FacetLoads no_loads(const coupler::FacetBatch& batch)
{
    const std::size_t facets = batch.facet_ids.size();
    coupler::FacetLoads loads;
    loads.corner_force.resize(facets * 4 * static_cast<std::size_t>(batch.dimension));
    loads.weight.resize(facets);
    loads.weighted_pressure.resize(facets);
    loads.full_weight.assign(facets, 1.0);
    return loads;
}

coupler::RegionBox slice(double low, double high) { return {{low, -1e9, -1e9}, {high, 1e9, 1e9}}; }

int find_id(const std::vector<std::int64_t>& ids, std::int64_t id)
{
    const auto at = std::find(ids.begin(), ids.end(), id);
    return at == ids.end() ? -1 : static_cast<int>(at - ids.begin());
}

double world_sum(double value)
{
    double sum = 0;
    MPI_Allreduce(&value, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
}

} // namespace coupled_test
