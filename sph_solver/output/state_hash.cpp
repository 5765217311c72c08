// SPDX-License-Identifier: MIT
#include "sph_solver/output/state_hash.hpp"

#include <cstdio>
#include <cstring>

namespace sph {
namespace {

/// One round of mixing 64 bits into a hash (the finaliser of splitmix64).
std::uint64_t mix(std::uint64_t hash, std::uint64_t bits)
{
    hash += bits + 0x9e3779b97f4a7c15ULL;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
    return hash ^ (hash >> 31);
}

template<class T> std::uint64_t mix_value(std::uint64_t hash, const T& value)
{
    static_assert(sizeof(T) % 8 == 0);
    for (std::size_t k = 0; k < sizeof(T) / 8; ++k) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, reinterpret_cast<const char*>(&value) + 8 * k, 8);
        hash = mix(hash, bits);
    }
    return hash;
}

} // namespace

template<int D> std::string state_hash(const Particles<D>& particles, const base::Communicator& comm)
{
    std::uint64_t sum = 0;
    for (const int owned : particles.owned) {
        std::uint64_t hash = 0;
        for_each_field(particles, [&](const FieldInfo& info, const auto& column) {
            if (info.role == Role::conserved) hash = mix_value(hash, column[static_cast<std::size_t>(owned)]);
        });
        sum += hash;
    }
    std::uint64_t total = 0;
    for (const std::uint64_t part : comm.gather_all(std::vector<std::uint64_t>{sum})) total += part;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(total));
    return digits;
}

template std::string state_hash(const Particles<2>&, const base::Communicator&);
template std::string state_hash(const Particles<3>&, const base::Communicator&);

} // namespace sph
