// SPDX-License-Identifier: MIT
#include "fem_solver/dofs/dof_map.hpp"

#include "coupler_lib/foundation/exchange.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace fem {
namespace {

/// Entries of an Eigen vector as the scatter wants them.
struct Entries {
    using value_type = double;
    Eigen::VectorXd& vector;
    double& operator[](std::size_t i) { return vector[static_cast<Eigen::Index>(i)]; }
    const double& operator[](std::size_t i) const { return vector[static_cast<Eigen::Index>(i)]; }
};

} // namespace

DofMap::DofMap(const Mesh& mesh)
    : mesh_(&mesh),
      own_(static_cast<Eigen::Index>(mesh.own_nodes()) * mesh.dimension),
      equations_(mesh.coordinates.size())
{
    if (team().comm()) make_scatter();
    number();
}

/// Every rank asks the owners of its halo nodes for them.
void DofMap::make_scatter()
{
    const base::Communicator& comm = *team().comm();
    const MeshPart& part = *mesh_->part;
    const auto ranks = static_cast<std::size_t>(comm.size());
    std::vector<std::vector<char>> asked(ranks);
    std::vector<std::vector<int>> received(ranks), sent(ranks);
    const auto add = [&](std::vector<int>& entries, int node) {
        for (int k = 0; k < mesh_->dimension; ++k) entries.push_back(node * mesh_->dimension + k);
    };
    for (int node = part.own_nodes; node < mesh_->nodes(); ++node) {
        const auto owner = static_cast<std::size_t>(part.owners[static_cast<std::size_t>(node)]);
        base::append_bytes(asked[owner], mesh_->node_id(node));
        add(received[owner], node);
    }
    const auto wishes = base::exchange_bytes(comm, asked);
    const std::span own_ids(part.node_ids.data(), static_cast<std::size_t>(part.own_nodes));
    base::ScatterPlan plan;
    for (std::size_t rank = 0; rank < ranks; ++rank) {
        for (const char* bytes = wishes[rank].data(); bytes != wishes[rank].data() + wishes[rank].size();) {
            std::int64_t id = 0;
            base::read_bytes(bytes, id);
            add(sent[rank], static_cast<int>(std::ranges::lower_bound(own_ids, id) - own_ids.begin()));
        }
        if (sent[rank].empty() && received[rank].empty()) continue;
        plan.neighbours.push_back(static_cast<int>(rank));
        plan.send_indices.insert(plan.send_indices.end(), sent[rank].begin(), sent[rank].end());
        plan.receive_indices.insert(plan.receive_indices.end(), received[rank].begin(), received[rank].end());
        plan.send_offsets.push_back(static_cast<int>(plan.send_indices.size()));
        plan.receive_offsets.push_back(static_cast<int>(plan.receive_indices.size()));
    }
    scatter_ = base::Scatter(comm, std::move(plan));
}

void DofMap::number()
{
    std::int64_t first = 0;
    const std::vector<std::int64_t> counts = team().gather_all(std::vector<std::int64_t>{own_});
    for (int rank = 0; rank < team().rank(); ++rank) first += counts[static_cast<std::size_t>(rank)];
    for (std::int64_t i = 0; i < own_; ++i) equations_[static_cast<std::size_t>(i)] = first + i;
    scatter_.forward(equations_);
}

double DofMap::dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const
{
    return team().sum(a.head(own_).dot(b.head(own_)));
}

double DofMap::largest(const Eigen::VectorXd& v) const
{
    const auto own = v.head(own_);
    const double value = own.size() == 0 ? 0 : own.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    return team().max(value <= std::numeric_limits<double>::max() ? value : std::numeric_limits<double>::infinity());
}

DofMap::Largest DofMap::find_largest(const Eigen::VectorXd& v) const
{
    double value = -1;
    Eigen::Index entry = -1;
    for (Eigen::Index i = 0; i < own_; ++i) {
        const double size = std::abs(v[i]);
        if (size <= value) continue;
        entry = i;
        value = size;
        if (!(size <= std::numeric_limits<double>::max())) { // infinite or not a number
            value = std::numeric_limits<double>::infinity();
            break;
        }
    }
    const bool here = team().rank_of_largest(value) == team().rank();
    return {team().max(value), here ? entry : -1};
}

void DofMap::refresh(Eigen::VectorXd& v) const
{
    if (!team().comm()) return;
    Entries entries{v};
    scatter_.forward(entries);
}

} // namespace fem
