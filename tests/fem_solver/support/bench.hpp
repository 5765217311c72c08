// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/time/static_solution.hpp"

namespace fem_test {

/// A unit block of cells whose nodes are moved to `map(s, t)`, with supports and loads, brought to rest.
class Bench {
public:
    using Map = std::function<std::array<double, 2>(double, double)>;

    Bench(fem::ElementType type, std::vector<int> cells, const Map& map, const fem::Law& law,
          const fem::BodySettings& settings = {})
        : mesh(mapped(type, std::move(cells), map)), forces(mesh, {law, 1000}, settings), supports(mesh)
    {}

    /// Displacement in equilibrium under the full load.
    Eigen::VectorXd rest(int load_steps)
    {
        fem::StaticSolution solution(mesh, forces, supports, {1e-10, 40, 0.1});
        fem::Motion motion = fem::Motion::at_rest(forces.dofs());
        solution.solve(motion, load_steps, [](double) {});
        return motion.displacement;
    }
    void add_traction(const std::string& group, const std::vector<double>& traction)
    {
        forces.add_load(std::make_unique<fem::DeadLoad>(fem::traction_force(mesh, mesh.faces(group), traction)));
    }
    void add_pressure(const std::string& group, const fem::PressureField& pressure)
    {
        forces.add_load(fem::make_follower_pressure(mesh, forces.pattern(), mesh.faces(group), pressure));
    }

    fem::Mesh mesh;
    fem::SolidForces forces;
    fem::Supports supports;

private:
    static fem::Mesh mapped(fem::ElementType type, std::vector<int> cells, const Map& map)
    {
        fem::Mesh mesh = fem::make_block({type, {0, 0}, {1, 1}, std::move(cells)});
        for (int i = 0; i < mesh.nodes(); ++i) {
            const auto x = map(mesh.node(i)[0], mesh.node(i)[1]);
            std::copy(x.begin(), x.end(), mesh.coordinates.begin() + 2 * i);
        }
        return mesh;
    }
};

} // namespace fem_test
