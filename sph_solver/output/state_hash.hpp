// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/state/particles.hpp"

#include <string>

namespace sph {

/// Fingerprint of the conserved fields of all particles, 16 hexadecimal digits, the same on every rank.
///
/// Each particle is hashed with its number, and the hashes are added up modulo 2^64: the sum depends on every bit of
/// every particle, but neither on their order nor on the partition. Collective.
template<int D> std::string state_hash(const Particles<D>& particles, const base::Communicator& comm);

} // namespace sph
