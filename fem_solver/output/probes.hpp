// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/config/analysis_config.hpp"
#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/mesh/mesh.hpp"

namespace fem {

/// Values at chosen nodes over time: probes.csv, columns such as "tip.ux[m]", "tip.vy[m/s]", "tip.fx[N/m]".
class Probes {
public:
    Probes(const Mesh& mesh, const std::vector<ProbeConfig>& probes);

    /// Headers, without the time.
    const std::vector<std::string>& columns() const { return columns_; }
    /// Collective. \param load of the fluid on the nodes, one entry per degree of freedom [N] (2D: N/m).
    std::vector<double> values(const Motion& motion, const Eigen::VectorXd& load) const;

private:
    struct Entry {
        Eigen::VectorXd Motion::*field; ///< null: of the load
        Eigen::Index dof;               ///< -1 where another rank owns it
    };
    const Mesh* mesh_;
    std::vector<std::string> columns_;
    std::vector<Entry> entries_;
};

} // namespace fem
