// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/scatter.hpp"
#include "fem_solver/mesh/mesh.hpp"

#include <Eigen/Core>

namespace fem {

/// Vectors over the nodes of a body that several ranks share, entry `node * dimension + component`, own nodes first.
///
/// Motions are right on all entries, own and halo; forces, residuals and rows of matrices on own entries only, which is
/// all that sums and maxima look at. On one rank everything is own. Every function but own() is collective.
class DofMap {
public:
    explicit DofMap(const Mesh& mesh);

    const Team& team() const { return mesh_->team(); }
    /// Number of own entries: the first ones of each vector.
    Eigen::Index own() const { return own_; }

    /// Sum of a_i b_i over all entries of the body.
    double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
    /// max |v_i|; infinite where an entry is not a number.
    double largest(const Eigen::VectorXd& v) const;
    /// The entry of max |v_i| on the rank that holds it, -1 on the others.
    struct Largest {
        double value;
        Eigen::Index entry;
    };
    Largest find_largest(const Eigen::VectorXd& v) const;

    /// Copies the owners' entries to the halo.
    void refresh(Eigen::VectorXd& v) const;
    /// Numbers for the equations of the whole body: rank by rank, own entries in order; of all local entries.
    const std::vector<std::int64_t>& equations() const { return equations_; }

private:
    void make_scatter();
    void number();

    const Mesh* mesh_;
    Eigen::Index own_;
    base::Scatter scatter_;
    std::vector<std::int64_t> equations_;
};

} // namespace fem
