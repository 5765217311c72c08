// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/mpi_session.hpp"

#include "coupler_lib/coupling/watchdog.hpp"

#include <mpi.h>

namespace coupler {

MpiSession::MpiSession(int& argc, char**& argv, const std::string& role, double init_timeout,
                       const std::string& launch_advice)
{
    StartWatchdog watchdog(role, init_timeout, launch_advice);
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    watchdog.disarm();
}

MpiSession::~MpiSession()
{
    int finalized = 0;
    MPI_Finalized(&finalized);
    if (!finalized) MPI_Finalize();
}

} // namespace coupler
