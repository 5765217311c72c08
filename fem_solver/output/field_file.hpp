// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/xdmf.hpp"
#include "fem_solver/dofs/dof_map.hpp"
#include "fem_solver/dofs/motion.hpp"

namespace fem {

/// Pressure [Pa] and way slipped [m] at each own node; both empty where the body touches nothing.
struct ContactFields {
    std::vector<double> pressure, slip;
};

/// fields.xdmf and fields.h5: the deformed mesh with displacement, velocity, Cauchy stress and contact over time, the own
/// nodes and elements of one rank after those of the other. Every function is collective.
class FieldFile {
public:
    FieldFile(const std::string& folder, const Mesh& mesh, const DofMap& dofs, const base::Communicator& comm);

    /// \param stress 9 numbers per own element [Pa].
    void write(double time, const Motion& motion, const std::vector<double>& stress, const ContactFields& contact);

private:
    std::vector<double> in_space(const Eigen::VectorXd& field) const;

    const Mesh* mesh_;
    base::XdmfTopology topology_;
    base::XdmfWriter file_;
};

} // namespace fem
