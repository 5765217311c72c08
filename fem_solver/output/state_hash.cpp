// SPDX-License-Identifier: MIT
#include "fem_solver/output/state_hash.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>

namespace fem {
namespace {

/// FNV-1a over the bytes of each number.
std::uint64_t add(std::uint64_t hash, const std::vector<double>& field)
{
    for (const double value : field) {
        std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3ULL;
    }
    return hash;
}

/// A field of all ranks in the order of the whole mesh's nodes.
std::vector<double> in_order(const Mesh& mesh, const Eigen::VectorXd& field)
{
    const auto d = static_cast<std::size_t>(mesh.dimension);
    std::vector<std::int64_t> own_ids;
    for (int i = 0; i < mesh.own_nodes(); ++i) own_ids.push_back(mesh.node_id(i));
    const auto ids = mesh.team().gather_all(own_ids);
    const auto values = mesh.team().gather_all(std::vector<double>(field.data(), field.data() + own_ids.size() * d));
    std::vector<double> ordered(values.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
        std::copy_n(values.data() + i * d, d, ordered.data() + static_cast<std::size_t>(ids[i]) * d);
    return ordered;
}

} // namespace

std::string state_hash(const Mesh& mesh, const Motion& motion)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const auto field : {&Motion::displacement, &Motion::velocity, &Motion::acceleration})
        hash = add(hash, in_order(mesh, motion.*field));
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

} // namespace fem
