// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/balance.hpp"

#include <algorithm>

namespace sph {
namespace {

constexpr int first_wait = 2;  // rebuilds before the first cut by measured work
constexpr double newest = 0.3; // weight of the newest measurement in the average

} // namespace

void Balance::note(const base::Communicator& comm, double seconds)
{
    const double mean = comm.sum(seconds) / comm.size();
    const double largest = comm.max(seconds);
    if (mean <= 0.0) return;
    sum_of_largest_ += largest;
    sum_of_means_ += mean;
    const double imbalance = largest / mean;
    present_ = measured_ ? (1.0 - newest) * present_ + newest * imbalance : imbalance;
    measured_ = true;
}

bool Balance::is_due() const
{
    const bool first = cuts_ + declined_ <= 1; // the cut at the start knew nothing but the number of particles
    const int wait = first ? std::min(first_wait, settings_.rebuilds_between) : settings_.rebuilds_between;
    return rebuilds_ >= wait && measured_ && present_ > settings_.limit;
}

void Balance::tried(bool was_cut)
{
    rebuilds_ = 0;
    ++(was_cut ? cuts_ : declined_);
    if (was_cut) measured_ = false;
}

double Balance::mean() const { return sum_of_means_ > 0.0 ? sum_of_largest_ / sum_of_means_ : 1.0; }

} // namespace sph
