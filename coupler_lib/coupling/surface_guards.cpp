// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/surface_guards.hpp"

#include "coupler_lib/coupling/facet_geometry.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace coupler {
namespace {

std::size_t node_count(const WetSurface& surface) { return surface.node_ids.size(); }

/// Whether every value is a number. Infinity and NaN have all bits of the exponent set: adding one to it reaches the
/// sign bit; a loop without branches, which compilers vectorise.
bool all_finite(const std::vector<double>& values)
{
    std::uint64_t carry = 0;
    for (const double value : values)
        carry |= (std::bit_cast<std::uint64_t>(value) & 0x7FFFFFFFFFFFFFFFu) + 0x0010000000000000u;
    return carry >> 63 == 0;
}

/// The first entry that is not a number, as a node's index, or the number of nodes.
std::size_t first_bad_node(const std::vector<double>& values, int dimension)
{
    const auto bad = std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
    return static_cast<std::size_t>(bad - values.begin()) / static_cast<std::size_t>(dimension);
}

/// The first node whose two points are farther apart than `limit`, or the number of nodes.
template<int D> std::size_t first_beyond(const std::vector<double>& a, const std::vector<double>& b, double limit)
{
    const std::size_t nodes = std::min(a.size(), b.size()) / D;
    const auto square = [&a, &b](std::size_t node) {
        double sum = 0;
        for (std::size_t k = node * D; k < (node + 1) * D; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
        return sum;
    };
    int beyond = 0; // without a branch, so that the loop is vectorised
    for (std::size_t node = 0; node < nodes; ++node) beyond |= static_cast<int>(square(node) > limit * limit);
    if (beyond == 0) return a.size() / D;
    std::size_t node = 0;
    while (square(node) <= limit * limit) ++node;
    return node;
}

double distance(const double* a, const double* b, int dimension)
{
    double square = 0;
    for (int d = 0; d < dimension; ++d) square += (a[d] - b[d]) * (a[d] - b[d]);
    return std::sqrt(square);
}

/// " of facet 7", the first one that the node belongs to.
std::string facet_of(const WetSurface& surface, std::size_t node)
{
    for (std::size_t facet = 0; facet < surface.facet_ids.size(); ++facet)
        for (const int corner : surface.facet_nodes[facet])
            if (corner == static_cast<int>(node)) return base::text(" of facet ", surface.facet_ids[facet]);
    return "";
}

/// A quick bound: no conservative load on any facet can exceed the limit [Pa], since
///     |f_facet| <= corners sqrt(D) max |component|  <=  limit * smallest facet
bool is_clearly_below(const FacetBatch& facets, const FacetLoads& loads, double limit)
{
    const int dimension = facets.dimension;
    const std::size_t corners = dimension == 2 ? 2 : 4;
    const std::size_t used = corners * static_cast<std::size_t>(dimension);
    std::int64_t largest = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t facet = 0; facet < facets.facet_ids.size(); ++facet) {
        const auto* force = &loads.corner_force[4 * facet * static_cast<std::size_t>(dimension)];
        for (std::size_t k = 0; k < used; ++k) largest = std::max(largest, force[k].coarse_magnitude());
        smallest = std::min(smallest, facet_measure(facets.facet_nodes[facet], facets.motion.position, dimension));
    }
    const double bound = (static_cast<double>(largest) + 1) * 0x1p-16;
    return static_cast<double>(corners) * std::sqrt(dimension) * bound <= limit * smallest;
}

/// Load on a facet as a pressure [Pa]: the larger of both kinds.
double pressure_of(const FacetBatch& facets, const FacetLoads& loads, std::size_t facet)
{
    double pressure = 0;
    const auto dimension = static_cast<std::size_t>(facets.dimension);
    if (!loads.corner_force.empty()) {
        double square = 0;
        for (std::size_t d = 0; d < dimension; ++d) {
            base::ReproducibleSum sum;
            for (std::size_t corner = 0; corner < 4; ++corner)
                sum += loads.corner_force[(4 * facet + corner) * dimension + d];
            square += sum.value() * sum.value();
        }
        pressure =
            std::sqrt(square) / facet_measure(facets.facet_nodes[facet], facets.motion.position, facets.dimension);
    }
    if (!loads.weight.empty() && loads.weight[facet].value() > 0)
        pressure = std::max(pressure, std::abs(loads.weighted_pressure[facet].value() / loads.weight[facet].value()));
    return pressure;
}

} // namespace

MotionGuard::MotionGuard(const WetSurface& surface, double limit)
{
    double size = 0;
    for (const auto& nodes : surface.facet_nodes) {
        const double measure = facet_measure(nodes, surface.reference, surface.dimension);
        size += surface.dimension == 2 ? measure : std::sqrt(measure);
    }
    const auto facets = static_cast<double>(surface.facet_nodes.size());
    longest_move_ = facets > 0 ? limit * size / facets : std::numeric_limits<double>::infinity();
}

void MotionGuard::check(const WetSurface& surface, const SurfaceMotion& motion, const std::string& who)
{
    const int dimension = surface.dimension;
    const std::size_t values = node_count(surface) * static_cast<std::size_t>(dimension);
    base::require_input(
        motion.position.size() == values && motion.velocity.size() == values && motion.acceleration.size() == values,
        who, ": the motion has ", motion.position.size(), ", ", motion.velocity.size(), " and ",
        motion.acceleration.size(), " values of position, velocity and acceleration; the surface needs ", values);
    if (!all_finite(motion.position) || !all_finite(motion.velocity) || !all_finite(motion.acceleration)) {
        const std::size_t bad =
            std::min({first_bad_node(motion.position, dimension), first_bad_node(motion.velocity, dimension),
                      first_bad_node(motion.acceleration, dimension)});
        const auto at = static_cast<std::ptrdiff_t>(bad) * dimension;
        throw base::Error(base::ExitCode::numerical_failure,
                          base::text(who, ": the motion of wet node ", surface.node_ids[bad], facet_of(surface, bad),
                                     " (reference ", point_text(surface.reference.data() + at, dimension),
                                     ") is not a number: position ", point_text(motion.position.data() + at, dimension),
                                     ", velocity ", point_text(motion.velocity.data() + at, dimension),
                                     ", acceleration ", point_text(motion.acceleration.data() + at, dimension)));
    }
    const std::size_t node = dimension == 2 ? first_beyond<2>(motion.position, last_position_, longest_move_)
                                            : first_beyond<3>(motion.position, last_position_, longest_move_);
    if (node < node_count(surface)) {
        const auto at = static_cast<std::ptrdiff_t>(node) * dimension;
        const double move = distance(motion.position.data() + at, last_position_.data() + at, dimension);
        throw base::Error(
            base::ExitCode::numerical_failure,
            base::text(who, ": wet node ", surface.node_ids[node], facet_of(surface, node), " jumped by ", move,
                       " m in one step, from ", point_text(last_position_.data() + at, dimension), " to ",
                       point_text(motion.position.data() + at, dimension), "; the limit is ", longest_move_,
                       " m (interface.motion_jump_limit mean facet sizes): the step is too large or the run has "
                       "diverged"));
    }
    last_position_ = motion.position;
}

void check_loads(const FacetBatch& facets, const FacetLoads& loads, double limit, const std::string& who)
{
    if (!(limit < std::numeric_limits<double>::infinity())) return;
    if (loads.weight.empty() && (loads.corner_force.empty() || is_clearly_below(facets, loads, limit))) return;
    for (std::size_t facet = 0; facet < facets.facet_ids.size(); ++facet) {
        const double pressure = pressure_of(facets, loads, facet);
        if (pressure <= limit) continue;
        const auto centre = facet_centre(facets.facet_nodes[facet], facets.motion.position, facets.dimension);
        throw base::Error(base::ExitCode::numerical_failure,
                          base::text(who, ": the load on wet facet ", facets.facet_ids[facet], " at ",
                                     point_text(centre.data(), facets.dimension), " is ", pressure,
                                     " Pa, beyond the limit of ", limit, " Pa: the run has diverged"));
    }
}

void check_surface(const WetSurface& surface, const std::string& who)
{
    const int dimension = surface.dimension;
    const std::size_t nodes = node_count(surface);
    base::require_input(dimension == 2 || dimension == 3, who, ": the wet surface has dimension ", dimension,
                        ", not 2 or 3");
    base::require_input(surface.reference.size() == nodes * static_cast<std::size_t>(dimension), who,
                        ": the wet surface has ", nodes, " nodes and ", surface.reference.size(),
                        " reference coordinates in ", dimension, "D");
    base::require_input(surface.facet_ids.size() == surface.facet_nodes.size(), who, ": the wet surface has ",
                        surface.facet_ids.size(), " facet ids for ", surface.facet_nodes.size(), " facets");
    for (std::size_t facet = 0; facet < surface.facet_nodes.size(); ++facet) {
        const auto& list = surface.facet_nodes[facet];
        const int corners = corner_count(list);
        base::require_input(dimension == 2 ? corners == 2 : corners >= 3, who, ": wet facet ", surface.facet_ids[facet],
                            " has ", corners, " nodes in ", dimension, "D");
        for (int k = 0; k < corners; ++k)
            base::require_input(static_cast<std::size_t>(list[static_cast<std::size_t>(k)]) < nodes, who,
                                ": wet facet ", surface.facet_ids[facet], " uses local node ",
                                list[static_cast<std::size_t>(k)], " of ", nodes, "; they count from 0");
        base::require_input(facet_measure(list, surface.reference, dimension) > 0, who, ": wet facet ",
                            surface.facet_ids[facet], " has no extent");
    }
}

} // namespace coupler
