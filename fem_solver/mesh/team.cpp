// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/team.hpp"

namespace fem {

void Team::sum(double* values, int count) const
{
    if (comm_) MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, comm_->handle());
}

std::vector<double> Team::sum(std::vector<double> values) const
{
    sum(values.data(), static_cast<int>(values.size()));
    return values;
}

int Team::rank_of_largest(double value) const
{
    if (!comm_) return 0;
    struct {
        double value;
        int rank;
    } mine{value, rank()}, largest{};
    MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm_->handle());
    return largest.rank;
}

std::string Team::first_text(const std::string& mine) const
{
    if (!comm_) return mine;
    const int root = rank_of_largest(mine.empty() ? 0 : 1);
    return comm_->broadcast(mine, root);
}

} // namespace fem
