// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/foundation/reproducible_sum.hpp"

#include <cstdint>
#include <mpi.h>
#include <string>
#include <type_traits>
#include <vector>

namespace base {

/// A group of ranks that compute together: a borrowed MPI communicator with the few collectives Rivage uses.
/// Every function but rank(), size() and handle() is collective.
class Communicator {
public:
    explicit Communicator(MPI_Comm handle);
    /// All ranks of the launch. For start-up and tests only: a solver uses its participant's communicator.
    static Communicator world() { return Communicator(MPI_COMM_WORLD); }
    /// This rank alone.
    static Communicator self() { return Communicator(MPI_COMM_SELF); }

    int rank() const { return rank_; }
    int size() const { return size_; }
    bool is_root() const { return rank_ == 0; }
    MPI_Comm handle() const { return handle_; }

    /// Sum over the ranks in rank order of MPI's choice: for counts and times. Physics uses total().
    double sum(double value) const;
    std::int64_t sum(std::int64_t value) const;
    double min(double value) const;
    double max(double value) const;
    std::int64_t max(std::int64_t value) const;
    bool any(bool value) const;

    /// Sums that do not depend on the partition.
    ReproducibleSum total(const ReproducibleSum& value) const;
    std::vector<ReproducibleSum> total(const std::vector<ReproducibleSum>& values) const;

    std::string broadcast(const std::string& text, int root = 0) const;
    void barrier() const { MPI_Barrier(handle_); }

    /// Everybody's items, concatenated in rank order.
    template <class T>
    std::vector<T> gather_all(const std::vector<T>& mine) const
    {
        static_assert(std::is_trivially_copyable_v<T>);
        std::vector<T> all(gathered_bytes(mine.size() * sizeof(T)) / sizeof(T));
        gather_bytes(mine.data(), mine.size() * sizeof(T), all.data());
        return all;
    }

private:
    std::size_t gathered_bytes(std::size_t mine) const;
    void gather_bytes(const void* mine, std::size_t bytes, void* all) const;

    MPI_Comm handle_;
    int rank_ = 0;
    int size_ = 1;
};

}  // namespace base
