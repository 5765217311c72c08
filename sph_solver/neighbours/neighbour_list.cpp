// SPDX-License-Identifier: MIT
#include "sph_solver/neighbours/neighbour_list.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <limits>

namespace sph {
namespace {

constexpr std::size_t readable = 16; // words behind the last row
constexpr int largest = std::numeric_limits<std::uint16_t>::max();

/// How many of the first neighbours have room in one block.
std::size_t block_length(std::span<const int> row)
{
    std::size_t count = 0;
    while (count < row.size() && count < largest && row[count] - row[0] <= largest) ++count;
    return count;
}

} // namespace

void NeighbourList::clear()
{
    begins_.assign(1, 0);
    words_.clear();
    entries_ = longest_ = 0;
}

void NeighbourList::append(std::span<const int> row)
{
    entries_ += row.size();
    longest_ = std::max(longest_, row.size());
    while (!row.empty()) {
        const std::size_t count = block_length(row);
        const auto base = static_cast<unsigned>(row[0]);
        words_.insert(words_.end(), {static_cast<std::uint16_t>(base), static_cast<std::uint16_t>(base >> 16),
                                     static_cast<std::uint16_t>(count)});
        const std::size_t begin = words_.size();
        words_.resize(begin + count);
        for (std::size_t n = 0; n < count; ++n) words_[begin + n] = static_cast<std::uint16_t>(row[n] - row[0]);
        row = row.subspan(count);
    }
    base::require(words_.size() <= std::numeric_limits<std::uint32_t>::max(), base::ExitCode::bad_input,
                  "a rank's neighbour list has more than 2^32 entries; use more ranks");
    begins_.push_back(static_cast<std::uint32_t>(words_.size()));
}

void NeighbourList::finish()
{
    words_.resize(words_.size() + readable);
    if (words_.capacity() > words_.size() + words_.size() / 8) words_.shrink_to_fit();
    begins_.shrink_to_fit();
}

std::vector<int> NeighbourList::of(std::size_t k) const
{
    std::vector<int> row(longest_ + readable);
    row.resize(static_cast<std::size_t>(copy(k, row.data()) - row.data()));
    return row;
}

} // namespace sph
