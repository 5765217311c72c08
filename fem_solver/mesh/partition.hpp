// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

namespace fem {

/// A rank for each element of a whole mesh: METIS cuts the dual graph (elements that share a face) into parts of equal
/// work, with as few shared faces as may be. \param work of each element.
std::vector<int> partition_elements(const Mesh& mesh, const std::vector<int>& work, int parts);

/// A rank for each node: one of those around it, the one that has the fewest nodes so far.
std::vector<int> partition_nodes(const Mesh& mesh, const std::vector<int>& element_ranks, int parts);

/// Work of each element, in units of a quarter of its own forces: one more for each of its faces in `busy_groups`, which
/// carry loads or contact. \throws base::Error bad_input for an unknown group.
std::vector<int> element_work(const Mesh& mesh, const std::vector<std::string>& busy_groups);

/// A rank's part of a whole mesh, with one layer of halo: its own elements and all around its own nodes.
/// \param element_ranks, node_ranks as above, the same on all ranks.
Mesh cut_mesh(const Mesh& whole, const std::vector<int>& element_ranks, const std::vector<int>& node_ranks,
              const base::Communicator& comm);

} // namespace fem
