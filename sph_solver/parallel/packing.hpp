// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/exchange.hpp"
#include "sph_solver/state/particles.hpp"

#include <vector>

namespace sph {

/// Appends the conserved fields of particle i to a message.
template<int D> void pack_particle(Particles<D>& particles, std::size_t i, std::vector<char>& message)
{
    for_each_field(particles, [&](const FieldInfo& info, auto& column) {
        if (info.role == Role::conserved) base::append_bytes(message, column[i]);
    });
}

/// Appends the particles of a message to the columns, as owned or as halo copies; returns how many came.
template<int D> int unpack_particles(Particles<D>& particles, const std::vector<char>& message, bool owned)
{
    int count = 0;
    const char* bytes = message.data();
    while (bytes != message.data() + message.size()) {
        const std::size_t i = particles.size();
        particles.resize(i + 1);
        for_each_field(particles, [&](const FieldInfo& info, auto& column) {
            if (info.role == Role::conserved) base::read_bytes(bytes, column[i]);
        });
        particles.is_owned[i] = owned ? 1 : 0;
        ++count;
    }
    return count;
}

} // namespace sph
