// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/nearest_name.hpp"

#include <algorithm>
#include <numeric>

namespace base {
namespace {

std::size_t edit_distance(const std::string& a, const std::string& b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates)
{
    std::string nearest;
    std::size_t best = name.size() / 2 + 1;
    for (const auto& candidate : candidates) {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates)
{
    const std::string nearest = nearest_name(name, candidates);
    if (!nearest.empty()) return "; did you mean '" + nearest + "'?";
    std::string list = "; known here: ";
    for (std::size_t k = 0; k < candidates.size(); ++k) list += (k ? ", " : "") + candidates[k];
    return candidates.empty() ? "" : list;
}

}  // namespace base
