// SPDX-License-Identifier: MIT
// A plate on a spring, in C++: mpirun -n 1 fake_fluid coupling.toml : -n 1 spring_plate coupling.toml [KEY=VALUE ...]
#include <rivage.hpp>

#include <cstdio>

int main(int argc, char** argv)
{
    if (argc < 2) return RIVAGE_BAD_INPUT;
    return rivage::run("solid", argv[1], {argv + 2, argv + argc}, [](const rivage::Participant& me) {
        const double mass = 100, stiffness = 1e6; // [kg/m], [N/m^2]
        rivage::Solid wet(me, 2, {0, 1}, {1, 0, 0, 0}, {0},
                          {0, 1, -1, -1}); // from (1, 0) to (0, 0): the body on the left
        double u = 0, v = 0;
        while (wet.receive()) { // load n, the time, the next dt
            const double a = (wet.force()[1] + wet.force()[3] - stiffness * u) / mass;
            rivage_solid_report report{};
            report.kinetic = 0.5 * mass * v * v;
            report.strain = 0.5 * stiffness * u * u;
            wet.send({1, u, 0, u}, {0, v, 0, v}, {0, a, 0, a}, report); // where it is at that time
            v += wet.window.dt * a;
            u += wet.window.dt * v;
        }
        std::printf("plate: u = %.6e m at t = %g s\n", u, wet.window.time);
    });
}
