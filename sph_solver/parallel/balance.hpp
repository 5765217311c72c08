// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"

namespace sph {

/// When to cut the domain anew.
struct RebalanceSettings {
    double limit = 1.08;       ///< largest measured time of a rank over the mean that is put up with [-]
    int rebuilds_between = 20; ///< rebuilds that must pass between two attempts
    double gain = 0.03;        ///< by how much a new cut must promise to lower the imbalance, else the old one stays
};

/// Decides when the domain is cut anew, and keeps the figures. Largest over mean time of the ranks is the imbalance.
///
/// Against cuts to and fro: the measured imbalance is averaged over some rebuilds, a number of rebuilds must pass
/// between two attempts, and an attempt whose new cut promises too little (BlockMap::repartition) changes nothing.
class Balance {
public:
    explicit Balance(const RebalanceSettings& settings) : settings_(settings) {}

    [[nodiscard]] const RebalanceSettings& settings() const { return settings_; }

    /// Notes the time [s] that this rank has spent since the last rebuild. Collective.
    void note(const base::Communicator& comm, double seconds);

    /// Lists and halo are made anew.
    void count_rebuild() { ++rebuilds_; }
    /// Is it time to try a new cut? The same on every rank.
    [[nodiscard]] bool is_due() const;
    /// An attempt was made.
    void tried(bool was_cut);

    [[nodiscard]] int cuts() const { return cuts_; }
    [[nodiscard]] int declined() const { return declined_; }
    [[nodiscard]] double present() const { return present_; } ///< averaged over the last rebuilds; 1: none measured
    [[nodiscard]] double mean() const;                        ///< over the run, weighted with the time; 1: not measured

private:
    RebalanceSettings settings_;
    int rebuilds_ = 0; ///< since the last attempt
    int cuts_ = 0, declined_ = 0;
    bool measured_ = false; ///< since the last cut
    double present_ = 1.0;
    double sum_of_largest_ = 0.0, sum_of_means_ = 0.0;
};

} // namespace sph
