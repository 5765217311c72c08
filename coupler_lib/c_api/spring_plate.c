/* SPDX-License-Identifier: MIT
 * A plate on a spring, in C, in the place of fem_solver:
 *
 *     mpirun -n 1 fake_fluid coupling.toml : -n 1 spring_plate coupling.toml [KEY=VALUE ...]
 */
#include <rivage.h>

#include <stdio.h>

static const double mass = 100, stiffness = 1e6; /* [kg/m], [N/m^2] */

static int run(rivage_participant* me)
{
    const int64_t node_ids[] = {0, 1}, facet_ids[] = {0};
    const double reference[] = {1, 0, 0, 0};      /* from (1, 0) to (0, 0): the body lies on the left */
    const int32_t facet_nodes[] = {0, 1, -1, -1};
    double u = 0, v = 0;
    rivage_solid* wet = NULL;
    rivage_window window = {-1, 0, 0, 0, 0};
    int code = rivage_solid_open(me, 2, 2, node_ids, reference, 1, facet_ids, facet_nodes, &wet);
    while (code == RIVAGE_OK && !window.last) {
        code = rivage_solid_receive(wet, &window); /* load n, the time, the next dt */
        if (code != RIVAGE_OK) break;
        const double* force = rivage_solid_force(wet);
        const double a = (force[1] + force[3] - stiffness * u) / mass;
        const double position[] = {1, u, 0, u}, velocity[] = {0, v, 0, v}, acceleration[] = {0, a, 0, a};
        const rivage_solid_report report = {.kinetic = 0.5 * mass * v * v, .strain = 0.5 * stiffness * u * u};
        code = rivage_solid_send(wet, position, velocity, acceleration, &report); /* where it is at that time */
        v += window.dt * a;
        u += window.dt * v;
    }
    if (code == RIVAGE_OK) printf("plate: u = %.6e m at t = %g s\n", u, window.time);
    if (code == RIVAGE_OK) code = rivage_solid_close(wet);
    return code;
}

int main(int argc, char** argv)
{
    rivage_participant* me = NULL;
    if (argc < 2) {
        fprintf(stderr, "usage: %s coupling.toml [KEY=VALUE ...]\n", argv[0]);
        return RIVAGE_BAD_INPUT;
    }
    int code = rivage_mpi_start("solid", 30);
    if (code == RIVAGE_OK)
        code = rivage_join(rivage_world(), "solid", argv[1], (const char* const*)(argv + 2), argc - 2, &me);
    if (code == RIVAGE_OK) {
        code = run(me);
        if (code == RIVAGE_OK)
            code = rivage_leave(me);
        else
            rivage_fail(me, code, rivage_last_error()); /* every other rank ends with this message */
    }
    rivage_mpi_end();
    return code;
}
