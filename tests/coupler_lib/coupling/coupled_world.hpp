// SPDX-License-Identifier: MIT
// A fluid and a solid inside one test program: roles by rank, a random wet surface that every rank knows as a whole,
// and random loads on it, so that what comes through the coupling can be compared with brute force.
#pragma once
#include "coupler_lib/coupling/fluid_interface.hpp"
#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/coupling/solid_interface.hpp"

#include <random>
#include <string>
#include <vector>

namespace coupled_test {

int world_rank();
int world_size();

/// World ranks 0 .. fluid_ranks-1 are the fluid, the others the solid.
coupler::ParticipantSettings settings_for(int fluid_ranks);

/// Every way to deal the ranks of this launch to two roles: 1 .. size-1 fluid ranks; empty on one rank.
std::vector<int> all_splits();

/// The whole surface, the same on every rank: a wavy line of segments, or a wavy sheet of triangles and quadrilaterals.
/// Ids are scattered and not in order.
coupler::WetSurface whole_surface(int dimension, unsigned seed);

/// The facets dealt at random to `ranks` ranks; returns those of `rank`, with their nodes.
coupler::WetSurface dealt_surface(const coupler::WetSurface& whole, int rank, int ranks, unsigned seed);

/// A smooth field of position and time, zero mean, of order 1: the value for a node's id and component.
double nodal_value(std::int64_t node_id, int component, int step);

/// Position = reference + 0.01 nodal values, velocity and acceleration random.
coupler::SurfaceMotion motion_of(const coupler::WetSurface& surface, int step);

/// A force at a point of a facet, given by the weights of the corners.
struct PointLoad {
    std::int64_t facet_id = 0;
    std::array<double, 4> shape{};
    std::array<double, 3> force{};
    double weight = 0; ///< for the averaged load
    double pressure = 0;
};

/// `count` random loads on the whole surface, the same on every rank.
std::vector<PointLoad> random_loads(const coupler::WetSurface& whole, int count, unsigned seed);

/// Adds a load to those of my batch; the facet must be there.
void add_load(coupler::FacetLoads& loads, const coupler::FacetBatch& batch, const PointLoad& load);

/// Zero loads of both kinds for a batch, with a full weight of 1 everywhere.
coupler::FacetLoads no_loads(const coupler::FacetBatch& batch);

/// A box between two values of x, unlimited otherwise.
coupler::RegionBox slice(double low, double high);

/// Index of a facet in a list of ids; -1: not there.
int find_id(const std::vector<std::int64_t>& ids, std::int64_t id);

double world_sum(double value);

} // namespace coupled_test
