// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/reproducible_sum.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace coupler {

/// One solid rank's part of the wet surface, as the solid registers it.
///
/// Facets are linear: a segment (a, b) in 2D with the outward normal n = (t_y, -t_x), t = b - a, so that the body lies
/// on the left; in 3D a triangle or quadrilateral, counterclockwise seen from outside. A facet belongs to exactly one
/// rank of the solid; a node may be listed by several ranks, with the same id and the same motion.
struct WetSurface {
    int dimension = 2;                           ///< 2 or 3
    std::vector<std::int64_t> node_ids;          ///< global, [nodes]
    std::vector<double> reference;               ///< reference positions [m], [nodes * dimension]
    std::vector<std::int64_t> facet_ids;         ///< global, unique over all ranks of the solid, [facets]
    std::vector<std::array<int, 4>> facet_nodes; ///< local node indices, -1 where unused, [facets]
};

/// Motion of the nodes of a surface at one instant; every array is [nodes * dimension], node by node.
struct SurfaceMotion {
    std::vector<double> position;     ///< current position [m]
    std::vector<double> velocity;     ///< [m/s]
    std::vector<double> acceleration; ///< the one the fluid moves its walls with [m/s^2]
};

/// The load that the solid receives for its part of the surface.
///
/// A node listed by several solid ranks receives on each of them only what came through that rank's own facets: the
/// true nodal force is the sum over the ranks, as in any finite element assembly.
struct SurfaceLoad {
    double impedance = 0;              ///< rho c of the fluid [kg/(m^2 s)]
    std::vector<double> force;         ///< conservative: nodal forces [N] (2D: N/m), [nodes * dimension]; else empty
    std::vector<double> pressure;      ///< averaged: pressure of every facet [Pa], [facets]; else empty
    std::vector<double> wall_velocity; ///< mean velocity vbar_n of the nodes while the fluid measured this load [m/s]:
                                       ///< V + A dt/2 of the motion last sent; [nodes * dimension]
};

/// One step of the fluid as both sides see it: packet `step` is exchanged at `time`, and a step of `dt` follows.
struct Window {
    std::int64_t step = -1;      ///< -1: the greeting; n: load n, measured over fluid step n-1 (0: at the start)
    double time = 0;             ///< [s]
    double dt = 0;               ///< length of the step that starts at `time` [s]
    bool last = false;           ///< the solid answers with its motion at the end time, then both leave
    bool stop_requested = false; ///< both leave early on request (exit code 5); the same on every rank
};

/// The fluid's energies; sums since the start where they are works, losses or what left. 2D: per metre of depth.
struct FluidEnergies {
    double kinetic = 0;       ///< [J]
    double potential = 0;     ///< [J]
    double internal = 0;      ///< [J]
    double external_work = 0; ///< done on the fluid by prescribed walls and boundaries, not by an interface [J]
    double outflow = 0;       ///< energy that left with the particles taken out [J]
    double dissipated = 0;    ///< all numerical and physical dissipations together [J]
};

/// What the fluid tells about itself in every packet: totals over its ranks, the same on each of them.
/// Forces and moments act on the solid of this interface. Works are cumulated since the start. 2D: per metre of depth.
struct FluidReport : FluidEnergies {
    std::array<double, 3> force{};  ///< of the load that travels with this report [N]
    std::array<double, 3> moment{}; ///< of the same, about the origin [N m]
    double work_on_solid = 0;       ///< Runge-Kutta-weighted sum of F.v_wall dt, without the jumps [J]
    double path_work = 0; ///< of each load along the solid's own way over the step that it was measured in [J]
    double jump_work = 0; ///< load times the wall's jump when a new motion corrects it [J]
    double wait = 0;      ///< seconds waited for the solid so far, largest over the ranks [s]
};

/// What the solid tells about itself in every packet: totals over its ranks, the same on each of them.
struct SolidReport {
    std::array<double, 3> force{};  ///< of the load as applied in the step that ended at this instant [N]
    std::array<double, 3> moment{}; ///< of the same, about the origin [N m]
    double work = 0;                ///< work of the fluid's load on the solid, cumulated [J]
    double displacement_max = 0;    ///< largest displacement of a wet node [m]
    double kinetic = 0;             ///< [J]
    double strain = 0;              ///< [J]
    double potential = 0;           ///< of gravity [J]
    double external_work = 0;       ///< of supports and loads other than the fluid's [J]
    double dissipated = 0;          ///< numerical dissipation, damping, friction [J]
    double wait = 0;                ///< seconds waited for the fluid so far, largest over the ranks [s]
};

/// Axis-parallel box of the particles that a fluid rank owns, widened by the reach of its walls. Empty when low > high
/// in any direction: such a rank is sent no facet. In 2D the third component is not looked at.
struct RegionBox {
    std::array<double, 3> low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
                              std::numeric_limits<double>::max()};
    std::array<double, 3> high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
                               std::numeric_limits<double>::lowest()};
};

/// The facets that one fluid rank was sent, sorted by facet id; the nodes are sorted by node id, each once.
struct FacetBatch {
    int dimension = 2;
    std::vector<std::int64_t> node_ids;          ///< [nodes], ascending
    std::vector<std::int64_t> facet_ids;         ///< [facets], ascending
    std::vector<std::array<int, 4>> facet_nodes; ///< indices into the node arrays, -1 where unused, [facets]
    SurfaceMotion motion;                        ///< [nodes * dimension] each
};

/// The loads of a fluid rank on the facets of the batch that its step used, in that batch's order.
///
/// Fill either kind (or both); an array left empty is not sent. The sums are exact, so that the result on the solid
/// does not depend on how particles are dealt out to ranks.
struct FacetLoads {
    /// Conservative: momentum given to the wall divided by dt, shared out to the facet's corners with the shape
    /// functions [N] (2D: N/m); [facets * 4 * dimension], index (facet * 4 + corner) * dimension + component.
    std::vector<base::ReproducibleSum> corner_force;
    std::vector<base::ReproducibleSum> weight;            ///< averaged: time mean of sum w_j [m^d], [facets]
    std::vector<base::ReproducibleSum> weighted_pressure; ///< averaged: time mean of sum w_j p_j* [Pa m^d], [facets]
    std::vector<double> full_weight; ///< averaged: weight of a patch covered all over [m^d], [facets]
};

/// Which load the solid applies.
enum class LoadKind { conservative, averaged };

/// Properties of one interface. The fluid fills impedance and pressure_limit; the rest comes from coupling.toml.
struct InterfaceSettings {
    std::string name = "wet"; ///< used in messages
    std::string partner;      ///< role on the other side; empty: the only other role
    LoadKind load = LoadKind::conservative;
    double impedance = 0;                                            ///< fluid: rho0 c0 [kg/(m^2 s)]
    double pressure_limit = std::numeric_limits<double>::infinity(); ///< fluid: |load| beyond this stops the run [Pa]
    double motion_jump_limit = 1.0; ///< solid: a node that moves farther in one step stops the run [mean facet size]
    double coverage_limit = 0.3;    ///< averaged: no pressure where weight / full_weight is below this [-]
};

} // namespace coupler
