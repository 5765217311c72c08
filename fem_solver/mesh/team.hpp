// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"

#include <optional>
#include <string>
#include <vector>

namespace fem {

/// The ranks that share one body: a communicator, or nobody but this rank, which then needs no MPI and no waiting.
/// Every function but rank(), size() and comm() is collective.
class Team {
public:
    /// This rank alone.
    Team() = default;
    explicit Team(const base::Communicator& comm)
    {
        if (comm.size() > 1) comm_ = comm;
    }

    int rank() const { return comm_ ? comm_->rank() : 0; }
    int size() const { return comm_ ? comm_->size() : 1; }
    /// The communicator of a team of several ranks; null when alone.
    const base::Communicator* comm() const { return comm_ ? &*comm_ : nullptr; }

    double sum(double value) const { return comm_ ? comm_->sum(value) : value; }
    std::int64_t sum(std::int64_t value) const { return comm_ ? comm_->sum(value) : value; }
    double min(double value) const { return comm_ ? comm_->min(value) : value; }
    double max(double value) const { return comm_ ? comm_->max(value) : value; }
    std::int64_t max(std::int64_t value) const { return comm_ ? comm_->max(value) : value; }
    bool any(bool value) const { return comm_ ? comm_->any(value) : value; }

    /// Entry by entry, `count` numbers in place.
    void sum(double* values, int count) const;
    std::vector<double> sum(std::vector<double> values) const;

    /// The rank of the largest value, the lowest of several.
    int rank_of_largest(double value) const;
    /// The text of the lowest rank that has one.
    std::string first_text(const std::string& mine) const;
    /// Everybody's items, concatenated in rank order.
    template<class T> std::vector<T> gather_all(const std::vector<T>& mine) const
    {
        return comm_ ? comm_->gather_all(mine) : mine;
    }

private:
    std::optional<base::Communicator> comm_;
};

} // namespace fem
