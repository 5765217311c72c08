// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/work_meter.hpp"

#include <ctime>
#include <numeric>
#include <vector>

namespace sph {
namespace {

constexpr double kept = 0.8; // share of the older measurements that a new one leaves

} // namespace

void WorkMeter::add_counts(const Counts& counts, int times)
{
    for (std::size_t k = 0; k < work_kinds; ++k) counts_[k] += times * counts[k];
}

double WorkMeter::calibrate(const base::Communicator& comm)
{
    std::vector<base::ReproducibleSum> sums(2 * work_kinds);
    for (std::size_t k = 0; k < work_kinds; ++k) {
        sums[k].add(seconds_[k]);
        sums[work_kinds + k].add(counts_[k]);
    }
    sums = comm.total(sums);
    for (std::size_t k = 0; k < work_kinds; ++k) {
        known_seconds_[k] = kept * known_seconds_[k] + sums[k].value();
        known_counts_[k] = kept * known_counts_[k] + sums[work_kinds + k].value();
    }
    const double mine = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
    seconds_ = {};
    counts_ = {};
    return mine;
}

double WorkMeter::cost(Work kind) const
{
    const auto k = static_cast<std::size_t>(kind);
    return known_counts_[k] > 0.0 ? known_seconds_[k] / known_counts_[k] : 0.0;
}

double WorkMeter::cpu_seconds() const
{
    if (!wanted_) return 0.0;
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace sph
