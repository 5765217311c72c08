// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/ground.hpp"
#include "fem_solver/assembly/contact_force.hpp"
#include "fem_solver/contact/contact_law.hpp"
#include "fem_solver/contact/contact_points.hpp"
#include "fem_solver/dofs/contact_resultants.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace fem {

/// What a contact with a ground is like.
struct ContactSettings {
    std::string group; ///< of faces
    ContactConstants constants;
    bool augmented = true;   ///< else penalty alone
    double tolerance = 1e-4; ///< gap that is left at a point in contact, over the size of its face
    int max_augmentations = 50;
    std::function<Eigen::Vector3d(double time)> ground_motion; ///< displacement of the ground [m]; empty: at rest
};

/// Contact of a group of faces with a rigid ground, at contact_points, with tractions per reference area; see
/// contact_traction.
class GroundContact final : public ContactForce {
public:
    /// \param mesh, pattern outlive the contact. \param points contact_points of the group's faces.
    GroundContact(const Mesh& mesh, const MatrixPattern& pattern, std::shared_ptr<const base::Ground> ground,
                  ContactSettings settings, std::vector<ContactPoint> points);

    double stiffness() const override;
    void restore() override;
    void add_force(const Motion& motion, double time, Eigen::VectorXd& normal,
                   Eigen::VectorXd& friction) const override;
    void add_tangent(const Motion& motion, double time, Matrix& matrix) const override;
    Augmentation augment(const Motion& motion, double time) override;
    std::string complaint() const override { return complaint_; }
    void accept(const Motion& motion, double time) override;

    const std::string& group() const { return settings_.group; }
    ContactResultants resultants(const Motion& motion, double time) const;
    /// Adds the pressure per present area [Pa] and the way slipped [m] at each node, means over the points around it.
    void add_fields(const Motion& motion, double time, std::vector<double>& pressure, std::vector<double>& slip) const;

private:
    /// A point at the end of the last accepted step.
    struct State {
        Multipliers multipliers;
        Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< over the ground
        double slip = 0;                                 ///< length of the way slipped [m]
    };

    Eigen::Vector3d position(const ContactPoint& point, const Motion& motion) const;
    Eigen::Vector3d moved_ground(double time) const;
    std::vector<double> stretches(const Motion& motion) const;
    template<class Action> void visit(const Motion& motion, double time, Action&& action) const;
    void add(const ContactPoint& point, const Eigen::Vector3d& traction, Eigen::VectorXd& force) const;
    double miss(std::size_t k, const Multipliers& next) const;
    void complain(const Motion& motion, double time, std::size_t where, double worst);

    const Mesh* mesh_;
    const MatrixPattern* pattern_;
    std::shared_ptr<const base::Ground> ground_;
    ContactSettings settings_;
    std::vector<MeshFace> faces_;
    std::vector<ContactPoint> points_;
    std::vector<double> reference_areas_; ///< of the faces [m^2] (2D: m)
    std::vector<State> accepted_;
    std::vector<Multipliers> now_;
    int augmentations_ = 0;
    std::string complaint_;
};

} // namespace fem
