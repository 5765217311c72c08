// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/partition.hpp"

namespace fem_test {

/// This rank's part of a mesh that all ranks of the test share.
inline fem::Mesh distributed(const fem::Mesh& whole)
{
    const base::Communicator world = base::Communicator::world();
    const auto elements = fem::partition_elements(whole, fem::element_work(whole, {}), world.size());
    return fem::cut_mesh(whole, elements, fem::partition_nodes(whole, elements, world.size()), world);
}

} // namespace fem_test
