// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/operators/pair_records.hpp"
#include "sph_solver/walls/images.hpp"
#include "sph_solver/walls/walls.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sph {

/// Images that one particle sees and that were mirrored in the same planes one after the other.
struct ImageGroup {
    std::size_t contact = 0;        ///< whose images: WallContacts::contacts
    std::array<int, 3> path{};      ///< WallContacts::planes, `order` of them
    int order = 0;                  ///< 1 to 3
    bool own_first = false;         ///< the first image is that of the particle itself
    std::uint8_t fillers = 0;       ///< entries at the end that only fill a unit up
    std::size_t begin = 0, end = 0; ///< sources, in whole units
    std::size_t weights = all_one;  ///< first weight, or all_one: only the fillers' are 0

    static constexpr std::size_t all_one = static_cast<std::size_t>(-1);
};

/// All images of one evaluation, found once for both passes. Only the source and the share of its volume are kept for
/// each image: where it is and what its state is follow from its group's planes (operators/image_packs.hpp).
///
/// Groups of one plane without cuts share their weights. Groups are filled up to whole units with the particle itself at
/// the weight zero. Their order, and that of the images in them, depends on the order of contacts and neighbours alone.
template<int D> class WallImages {
public:
    /// \pre walls.find_contacts and records.load_states for the present positions; `neighbours` are those in reach.
    void find(const Walls<D>& walls, const PairRecords<D>& records, const Particles<D>& particles,
              const ReachedNeighbours& neighbours);

    const std::vector<ImageGroup>& groups() const { return groups_; }
    const int* sources() const { return sources_.data(); }
    /// Weights of a group's sources from number `at` on.
    const double* weights(const ImageGroup& group, std::size_t at) const
    {
        if (group.weights != ImageGroup::all_one) return &weights_[group.weights + (at - group.begin)];
        return &ones_[ones_.size() - row_unit + at - (group.end - group.fillers)];
    }

private:
    struct Bucket {
        std::vector<int> sources;
        std::vector<double> weights;
    };
    void add_behind_plane(std::size_t contact, const Walls<D>& walls, const PairRecords<D>& records,
                          std::span<const int> neighbours);
    void add_in_buckets(std::size_t contact, const Walls<D>& walls, const Particles<D>& particles,
                        std::span<const int> neighbours);
    void flush_bucket(std::size_t code, const WallContact& contact, std::size_t number);
    void close_group(ImageGroup group, int particle);
    void hold_ones(std::size_t count);

    std::vector<ImageGroup> groups_;
    std::vector<int> sources_;
    std::vector<double> weights_;    ///< of groups that have their own
    std::vector<double> ones_;       ///< as many as the largest group has sources, and a unit of zeros behind them
    std::array<Bucket, 39> buckets_; ///< one for each path of up to three of three planes
};

} // namespace sph
