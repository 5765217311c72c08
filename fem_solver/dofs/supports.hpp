// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/time_function.hpp"
#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/dofs/rigid_drive.hpp"
#include "fem_solver/dofs/sparse_matrix.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace fem {

/// Components of the nodes of named groups that are held, at zero displacement or on a given path.
class Supports {
public:
    explicit Supports(const Mesh& mesh)
        : mesh_(&mesh), fixed_(mesh.coordinates.size(), 0), owner_(mesh.coordinates.size(), -1)
    {}

    /// Holds components ("x", "y", "z") of a node group.
    /// \throws base::Error bad_input for an unknown group or component.
    void fix(const std::string& group, const std::vector<std::string>& components);

    /// Holds the normal component of a group of faces that lies in a plane across x, y or z: a plane of symmetry.
    /// \throws base::Error bad_input for an unknown group of faces, or one that lies in no such plane.
    void fix_normal(const std::string& group);

    /// Displacement along one axis of the node with a reference position, over time [m].
    using Path = std::function<base::TimeFunction(const double* reference)>;
    /// Moves a component of a node group on a path. \throws as fix.
    void prescribe(const std::string& group, const std::string& component, const Path& path);

    /// Moves all nodes of a group as one rigid body. \throws as fix.
    void drive(const std::string& group, std::shared_ptr<const RigidDrive> drive);

    /// Whether any component is moved.
    bool moves() const { return moves_; }
    /// Gives moved components their displacement, velocity and acceleration at a time [s].
    void set_motion(double time, Motion& motion) const;
    /// What moved components lack to their displacement at a time; zero elsewhere [m].
    Eigen::VectorXd gap(double time, const Eigen::VectorXd& displacement) const;

    bool fixed(int dof) const { return fixed_[dof] != 0; }
    bool empty() const { return groups_.empty(); }
    /// Names of the supported groups, in the order of `fix`.
    const std::vector<std::string>& groups() const { return groups_; }
    /// Zero in the held entries of a residual or a correction.
    void clear_rows(Eigen::VectorXd& vector) const;
    /// Zero in the held rows and columns, `diagonal` on the diagonal: the held unknowns drop out of the system.
    void clear(Matrix& matrix, double diagonal) const;
    /// Only the held entries of a vector of nodal forces, zero elsewhere.
    Eigen::VectorXd held_part(const Eigen::VectorXd& forces) const;
    /// Sum of the held entries over the nodes of a group: its reaction, one entry per dimension [N] (2D: N/m). Collective,
    /// as all sums.
    std::vector<double> reaction(const std::string& group, const Eigen::VectorXd& forces) const;
    /// Groups that are driven as rigid bodies.
    struct Driven {
        std::string group;
        std::shared_ptr<const RigidDrive> drive;
    };
    const std::vector<Driven>& driven() const { return driven_; }
    /// Moment of the reaction of a driven group about the present place of its centre [N m] (2D: N m/m, along z).
    Eigen::Vector3d moment(const Driven& driven, double time, const Motion& motion,
                           const Eigen::VectorXd& forces) const;
    /// Sums of a vector over the entries that each group holds, in the order of `groups`; an entry that two groups hold
    /// belongs to the first, so that the sums add up to that over all held entries.
    std::vector<double> sums(const Eigen::VectorXd& vector) const;

private:
    /// Holds one component of a group; returns its entries in the vectors over all nodes.
    std::vector<int> hold(const std::string& group, const std::string& component);

    struct Moved {
        int dof;
        base::TimeFunction at;
    };
    const Mesh* mesh_;
    std::vector<char> fixed_;
    std::vector<int> owner_; // number of the group that holds an entry first, or -1
    std::vector<std::string> groups_;
    std::vector<Driven> driven_;
    std::vector<Moved> moved_;
    bool moves_ = false; // here or on another rank
};

} // namespace fem
