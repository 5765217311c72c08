// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/communicator.hpp"

#include <numeric>

namespace base {
namespace {

template <class T>
T reduce(T value, MPI_Datatype type, MPI_Op operation, MPI_Comm comm)
{
    T result{};
    MPI_Allreduce(&value, &result, 1, type, operation, comm);
    return result;
}

void add_reproducible(void* in, void* inout, int* length, MPI_Datatype*)
{
    const auto* terms = static_cast<const ReproducibleSum*>(in);
    auto* sums = static_cast<ReproducibleSum*>(inout);
    for (int k = 0; k < *length; ++k) sums[k] += terms[k];
}

/// The MPI type and operation of ReproducibleSum; made once, freed with MPI itself.
struct ReproducibleMpi {
    MPI_Datatype type;
    MPI_Op operation;
    ReproducibleMpi()
    {
        MPI_Type_contiguous(sizeof(ReproducibleSum), MPI_BYTE, &type);
        MPI_Type_commit(&type);
        MPI_Op_create(&add_reproducible, 1, &operation);
    }
};

const ReproducibleMpi& reproducible_mpi()
{
    static const ReproducibleMpi instance;
    return instance;
}

std::vector<int> gather_sizes(std::size_t bytes, MPI_Comm comm, int size)
{
    const int mine = static_cast<int>(bytes);
    std::vector<int> all(static_cast<std::size_t>(size));
    MPI_Allgather(&mine, 1, MPI_INT, all.data(), 1, MPI_INT, comm);
    return all;
}

}  // namespace

Communicator::Communicator(MPI_Comm handle) : handle_(handle)
{
    MPI_Comm_rank(handle_, &rank_);
    MPI_Comm_size(handle_, &size_);
}

double Communicator::sum(double value) const { return reduce(value, MPI_DOUBLE, MPI_SUM, handle_); }
double Communicator::min(double value) const { return reduce(value, MPI_DOUBLE, MPI_MIN, handle_); }
double Communicator::max(double value) const { return reduce(value, MPI_DOUBLE, MPI_MAX, handle_); }
std::int64_t Communicator::sum(std::int64_t value) const { return reduce(value, MPI_INT64_T, MPI_SUM, handle_); }
std::int64_t Communicator::max(std::int64_t value) const { return reduce(value, MPI_INT64_T, MPI_MAX, handle_); }
bool Communicator::any(bool value) const { return reduce<int>(value, MPI_INT, MPI_LOR, handle_) != 0; }

ReproducibleSum Communicator::total(const ReproducibleSum& value) const
{
    return total(std::vector<ReproducibleSum>{value}).front();
}

std::vector<ReproducibleSum> Communicator::total(const std::vector<ReproducibleSum>& values) const
{
    if (size_ == 1) return values;
    std::vector<ReproducibleSum> result(values.size());
    const auto& mpi = reproducible_mpi();
    MPI_Allreduce(values.data(), result.data(), static_cast<int>(values.size()), mpi.type, mpi.operation, handle_);
    return result;
}

std::string Communicator::broadcast(const std::string& text, int root) const
{
    std::int64_t length = static_cast<std::int64_t>(text.size());
    MPI_Bcast(&length, 1, MPI_INT64_T, root, handle_);
    std::string result = text;
    result.resize(static_cast<std::size_t>(length));
    MPI_Bcast(result.data(), static_cast<int>(length), MPI_CHAR, root, handle_);
    return result;
}

std::size_t Communicator::gathered_bytes(std::size_t mine) const
{
    return static_cast<std::size_t>(sum(static_cast<std::int64_t>(mine)));
}

void Communicator::gather_bytes(const void* mine, std::size_t bytes, void* all) const
{
    const std::vector<int> sizes = gather_sizes(bytes, handle_, size_);
    std::vector<int> offsets(sizes.size(), 0);
    std::partial_sum(sizes.begin(), sizes.end() - 1, offsets.begin() + 1);
    MPI_Allgatherv(mine, static_cast<int>(bytes), MPI_BYTE, all, sizes.data(), offsets.data(), MPI_BYTE, handle_);
}

}  // namespace base
