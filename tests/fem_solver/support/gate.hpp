// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/supports.hpp"
#include "fem_solver/mesh/block_mesh.hpp"

namespace fem_test {

/// The rubber gate, 79 x 5 mm, clamped at its top, with the water's hydrostatic pressure on its left face.
class Gate {
public:
    Gate(fem::ElementType type, const fem::Law& law, const fem::BodySettings& settings = {},
         std::vector<int> cells = {4, 40})
        : mesh(fem::make_block({type, {0.1, 0.0}, {0.105, 0.079}, std::move(cells)})),
          forces(mesh, {law, 1100}, settings),
          supports(mesh)
    {
        supports.fix("top", {"x", "y"});
        tip = 2 * mesh.nearest_node({0.1025, 0.0});
    }

    void add_water()
    {
        forces.add_load(fem::make_follower_pressure(mesh, forces.pattern(), mesh.faces("left"),
                                                    [](const double* x) { return 1000 * 9.81 * (0.14 - x[1]); }));
    }

    fem::Mesh mesh;
    fem::SolidForces forces;
    fem::Supports supports;
    int tip = 0; ///< degree of freedom of the tip's ux
};

inline fem::NeoHookean rubber(double young = 12e6, double poisson = 0.4)
{
    return {fem::Lame::from_young(young, poisson)};
}

} // namespace fem_test
