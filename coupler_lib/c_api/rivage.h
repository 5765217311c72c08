/* SPDX-License-Identifier: MIT
 *
 * The coupling library for C, and for every language that can call C.
 *
 * A solver from outside takes the place of fem_solver or sph_solver in a coupled run. Functions that return int give RIVAGE_OK
 * or a code below; rivage_last_error() then says why. After an error call rivage_fail(), which ends the whole run with one
 * message, or leave with the code. Arrays are the caller's and are read before a function returns; pointers that are given
 * out stay valid until the next receive on the same handle. All numbers are SI; 2D is per metre of depth. Functions on a
 * participant that open, send, receive or close are called by each of its ranks.
 */
#ifndef RIVAGE_H
#define RIVAGE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { RIVAGE_OK = 0, RIVAGE_BAD_INPUT = 2, RIVAGE_NUMERICAL_FAILURE = 3, RIVAGE_PARTNER_LOST = 4, RIVAGE_STOPPED = 5 };

typedef struct rivage_participant rivage_participant; /* a role of a run, on this rank */
typedef struct rivage_solid rivage_solid;             /* a solid's end of its interface */
typedef struct rivage_fluid rivage_fluid;             /* a fluid's end of one interface */

/* A step of the fluid: packet `step` is exchanged at `time`, a step of `dt` follows. -1: the greeting. */
typedef struct {
    int64_t step;
    double time, dt;        /* [s] */
    int32_t last;           /* the solid answers with its motion at `time`, then both leave */
    int32_t stop_requested; /* leave early, as somebody asked */
} rivage_window;

/* Totals of the fluid [J, N, N m]; works and losses since the start; force and moment act on the solid. */
typedef struct {
    double kinetic, potential, internal, external_work, outflow, dissipated;
    double force[3], moment[3];
    double work_on_solid, path_work, jump_work, wait;
} rivage_fluid_report;

/* Totals of the solid. */
typedef struct {
    double force[3], moment[3]; /* of the load as applied in the step that ended now */
    double work;                /* of the fluid's load since the start */
    double displacement_max;    /* [m] */
    double kinetic, strain, potential, external_work, dissipated, wait;
} rivage_solid_report;

const char* rivage_last_error(void); /* of this thread, until its next call */
const char* rivage_version(void);

/* MPI_Init under a watchdog that ends the process when a partner never comes. Does nothing where MPI runs already. */
int rivage_mpi_start(const char* role, double timeout);
/* MPI_Finalize, if rivage_mpi_start made MPI_Init. */
int rivage_mpi_end(void);

/* Joins the run. Collective over `world`, a communicator as MPI_Comm_c2f gives it; rivage_world() is MPI_COMM_WORLD's.
 * coupling_file: the shared coupling.toml. arguments: the words that follow it in the command line, "coupling.time.end=0.1" or
 * "--set", "coupling.time.end=0.1" for overrides, which must be the partners'; "--as", "ROLE" in the place of `role`; "--out", "FOLDER".
 * A process may be in several runs, each over a communicator of its own. */
int rivage_join(int world, const char* role, const char* coupling_file, const char* const* arguments,
                int argument_count, rivage_participant** participant);
int rivage_world(void);
/* The end in order: says farewell, waits for the partners', frees the participant (its interfaces must be closed). */
int rivage_leave(rivage_participant* participant);
/* Tells every rank of the run, then MPI_Abort(code). Returns only where the run could not start or this rank is alone. */
void rivage_fail(rivage_participant* participant, int code, const char* message);

int rivage_comm(const rivage_participant* participant); /* of the ranks of this role, for MPI_Comm_f2c */
const char* rivage_role(const rivage_participant* participant);
const char* rivage_output_dir(const rivage_participant* participant); /* of --out; empty: not given */
int rivage_rank(const rivage_participant* participant);
int rivage_size(const rivage_participant* participant);
double rivage_end_time(const rivage_participant* participant);       /* [s], coupling.time.end */
double rivage_table_interval(const rivage_participant* participant); /* [s], coupling.output.table_interval */
int rivage_is_serial(const rivage_participant* participant); /* coupling.scheme = "serial": step after the fluid */
double rivage_impedance_share(const rivage_participant* participant); /* of rho c answered to within a step */
int rivage_solid_every(const rivage_participant* participant); /* steps of the fluid from one exchange to the next */
int rivage_stop_requested(const rivage_participant* participant);
void rivage_request_stop(rivage_participant* participant);

/* The solid: registers its wet facets. Segments in 2D with the body on the left of (a, b), triangles or quadrilaterals in 3D,
 * counterclockwise seen from outside. facet_nodes: 4 for each facet, -1 where unused, indices into the nodes given here.
 * A facet belongs to one rank; a node may be given by several. */
int rivage_solid_open(rivage_participant* participant, int dimension, int64_t nodes, const int64_t* node_ids,
                      const double* reference, int64_t facets, const int64_t* facet_ids, const int32_t* facet_nodes,
                      rivage_solid** solid);
int rivage_solid_receive(rivage_solid* solid, rivage_window* window);
/* What came: forces [nodes * dimension], or NULL where the interface's load is averaged; pressures [facets], or NULL where it
 * is conservative; mean velocity of the nodes while the load was measured [nodes * dimension]; rho c. */
const double* rivage_solid_force(const rivage_solid* solid);
const double* rivage_solid_pressure(const rivage_solid* solid);
const double* rivage_solid_wall_velocity(const rivage_solid* solid);
double rivage_solid_impedance(const rivage_solid* solid);
int rivage_solid_fluid_report(const rivage_solid* solid, rivage_fluid_report* report);
/* What coupling.scheme makes of the load for a step of dt, in place. velocity of the nodes at its start. Once for each step. */
int rivage_solid_predict(rivage_solid* solid, const double* velocity, double dt);
/* Answers the last receive, each array [nodes * dimension]. The acceleration is filtered as coupling.acceleration says. */
int rivage_solid_send(rivage_solid* solid, const double* position, const double* velocity, const double* acceleration,
                      const rivage_solid_report* report);
int rivage_solid_close(rivage_solid* solid);

/* The fluid. partner: role of the solid, or NULL for the only one. impedance: rho c. pressure_limit: a load beyond it ends the
 * run. output_dir: rank 0 writes coupling/interface.csv there, and energy_total.csv where the fluid has one solid; NULL: nothing. */
int rivage_fluid_open(rivage_participant* participant, const char* partner, int dimension, double impedance,
                      double pressure_limit, const char* output_dir, rivage_fluid** fluid);
/* Loads on the facets of the last receive: corner_force [facets * 4 * dimension], or NULL; weight, weighted_pressure and
 * full_weight [facets], or NULL. low, high: the box of space, three numbers each, where facets are wanted. */
int rivage_fluid_send(rivage_fluid* fluid, const rivage_window* window, const double* low, const double* high,
                      const double* corner_force, const double* weight, const double* weighted_pressure,
                      const double* full_weight, const rivage_fluid_report* report);
int rivage_fluid_receive(rivage_fluid* fluid, rivage_solid_report* report);
int64_t rivage_fluid_nodes(const rivage_fluid* fluid);
int64_t rivage_fluid_facets(const rivage_fluid* fluid);
const int64_t* rivage_fluid_node_ids(const rivage_fluid* fluid);
const int64_t* rivage_fluid_facet_ids(const rivage_fluid* fluid);
const int32_t* rivage_fluid_facet_nodes(const rivage_fluid* fluid);
const double* rivage_fluid_position(const rivage_fluid* fluid);
const double* rivage_fluid_velocity(const rivage_fluid* fluid);
const double* rivage_fluid_acceleration(const rivage_fluid* fluid);
int rivage_fluid_stop_agreed(const rivage_fluid* fluid); /* the next window must be the last, with stop_requested */
int rivage_fluid_close(rivage_fluid* fluid);

#ifdef __cplusplus
}
#endif
#endif
