// SPDX-License-Identifier: MIT
// A program that takes part in MPI but in nothing else: the handshake must notice it.
#include <ctime>
#include <mpi.h>

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const timespec minute{60, 0};
    nanosleep(&minute, nullptr);
    MPI_Finalize();
    return 0;
}
