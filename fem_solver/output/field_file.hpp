// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/xdmf.hpp"
#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/mesh/mesh.hpp"

namespace fem {

/// fields.xdmf and fields.h5: the deformed mesh with displacement, velocity and Cauchy stress over time.
class FieldFile {
public:
    FieldFile(const std::string& folder, const Mesh& mesh, const base::Communicator& comm);

    /// \param stress 9 numbers per element [Pa].
    void write(double time, const Motion& motion, const std::vector<double>& stress);

private:
    std::vector<double> in_space(const Eigen::VectorXd& field) const;

    const Mesh* mesh_;
    base::XdmfTopology topology_;
    base::XdmfWriter file_;
};

} // namespace fem
