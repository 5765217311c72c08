// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"

#include <array>
#include <cstddef>

namespace sph {

/// What a rank's time in a step is spent on, and in what it is counted.
enum class Work : std::size_t {
    particle, ///< what is done once for each particle: one particle
    pair,     ///< passes over the neighbours: one neighbour
    image,    ///< images at walls: one neighbour of a particle for each of its planes
};
inline constexpr std::size_t work_kinds = 3;

/// Measures what a particle, a neighbour and an image cost in CPU time on this machine: the weights of the cut.
///
/// CPU time of the thread and not wall time: a rank that shares its core is not taken for one with more work.
/// Measured costs steer the cut and nothing else, so results do not depend on them.
class WorkMeter {
public:
    /// \param wanted false: measures nothing and costs nothing
    explicit WorkMeter(bool wanted) : wanted_(wanted) {}

    using Counts = std::array<double, work_kinds>; ///< of each kind of work

    class Scope {
    public:
        Scope(WorkMeter& meter, Work kind) : meter_(meter), kind_(kind), start_(meter.cpu_seconds()) {}
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        ~Scope() { meter_.add_seconds(kind_, meter_.cpu_seconds() - start_); }

    private:
        WorkMeter& meter_;
        Work kind_;
        double start_;
    };

    /// CPU time of the scope goes to `kind`.
    [[nodiscard]] Scope measure(Work kind) { return {*this, kind}; }
    void add_seconds(Work kind, double seconds) { seconds_[static_cast<std::size_t>(kind)] += seconds; }
    /// How much of each kind has been done in the measured scopes, so many times.
    void add_counts(const Counts& counts, int times);

    /// Takes over what has been measured since the last call, on all ranks; older measurements fade. Collective.
    /// \return CPU seconds of this rank since the last call
    double calibrate(const base::Communicator& comm);

    /// Mean seconds for one of a kind over all ranks; 0 while none was measured.
    [[nodiscard]] double cost(Work kind) const;

private:
    [[nodiscard]] double cpu_seconds() const;

    bool wanted_;
    Counts seconds_{}, counts_{};             ///< of this rank since the last calibration
    Counts known_seconds_{}, known_counts_{}; ///< of all ranks, faded
};

} // namespace sph
