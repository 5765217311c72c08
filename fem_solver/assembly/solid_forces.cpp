// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/solid_forces.hpp"

#include <cmath>
#include <limits>

namespace fem {

Forces Forces::zero(Eigen::Index dofs)
{
    const Eigen::VectorXd z = Eigen::VectorXd::Zero(dofs);
    return {z, z, z, z, z, z, z, z, {}};
}

Eigen::VectorXd Forces::unbalanced() const
{
    return internal + damping - gravity - loads - interface - correction - contact - friction;
}

Forces Forces::blend(double a, const Forces& other, double b) const
{
    Forces sum{
        a * internal + b * other.internal, a * damping + b * other.damping,     a * gravity + b * other.gravity,
        a * loads + b * other.loads,       a * interface + b * other.interface, a * correction + b * other.correction,
        a * contact + b * other.contact,   a * friction + b * other.friction,   {}};
    for (std::size_t k = 0; k < each_load.size(); ++k)
        sum.each_load.push_back(a * each_load[k] + b * other.each_load[k]);
    return sum;
}

SolidForces::SolidForces(const Mesh& mesh, const Material& material, const BodySettings& settings)
    : map_(mesh),
      pattern_(mesh),
      body_(make_solid_body(mesh, pattern_, material, settings)),
      mass_(pattern_.zero()),
      initial_stiffness_(pattern_.zero()),
      damping_(pattern_.zero()),
      gravity_(Eigen::VectorXd::Zero(std::ssize(mesh.coordinates)))
{
    body_->add_mass(mass_);
    sparse_mass_ = mass_.pruned();
    body_->add_stiffness(Eigen::VectorXd::Zero(dofs()), initial_stiffness_);
    const auto elements = static_cast<double>(all_elements(mesh));
    element_size_ = bounding_box(mesh).longest_side() * std::pow(elements, -1.0 / mesh.dimension); // about
    round_off_ = std::numeric_limits<double>::epsilon() * map_.largest(initial_stiffness_.diagonal());
}

void SolidForces::set_damping(const Damping& damping)
{
    damped_ = damping.stiffness != 0 || damping.mass != 0;
    damping_.coeffs() = damping.stiffness * initial_stiffness_.coeffs() + damping.mass * mass_.coeffs();
}

void SolidForces::set_gravity(const std::vector<double>& acceleration)
{
    Eigen::VectorXd field(dofs());
    for (Eigen::Index i = 0; i < field.size(); ++i) field[i] = acceleration[i % std::ssize(acceleration)];
    gravity_ = inertia(field);
}

void SolidForces::set_contact(std::unique_ptr<ContactForce> contact)
{
    contact_ = std::move(contact);
    round_off_ += std::numeric_limits<double>::epsilon() * map_.team().max(contact_->stiffness());
}

void SolidForces::add_load(std::unique_ptr<Load> load, std::string name, TimeFactor factor)
{
    loads_.push_back(std::move(load));
    factors_.push_back(std::move(factor));
    load_names_.push_back(std::move(name));
}

void SolidForces::set_window(double share, const Forces& start)
{
    window_share_ = share;
    if (share == 1) return;
    interface_start_ = (1 - share) * start.interface;
    correction_start_ = (1 - share) * start.correction;
}

Eigen::VectorXd SolidForces::inertia(const Eigen::VectorXd& field) const { return sparse_mass_ * field; }

Inversion SolidForces::evaluate(const Motion& motion, double scale, Forces& forces, double time) const
{
    forces.internal.setZero();
    Inversion inversion = body_->add_internal_force(motion.displacement, forces.internal);
    inversion.elsewhere = map_.team().any(inversion.happened());
    if (inversion.happened()) return inversion;
    if (damped_) forces.damping.noalias() = damping_ * motion.velocity;
    forces.gravity = scale * gravity_;
    forces.loads.setZero();
    forces.each_load.resize(loads_.size());
    for (std::size_t k = 0; k < loads_.size(); ++k) {
        forces.each_load[k].setZero(dofs());
        loads_[k]->add_force(motion, scale * load_factor(k, time), forces.each_load[k]);
        forces.loads += forces.each_load[k];
    }
    forces.interface.setZero();
    if (interface_) interface_->add_force(motion, window_share_ * scale, forces.interface);
    forces.correction.setZero();
    if (correction_) correction_->add_force(motion, window_share_ * scale, forces.correction);
    if (window_share_ < 1) {
        forces.interface += interface_start_;
        forces.correction += correction_start_;
    }
    forces.contact.setZero();
    forces.friction.setZero();
    contact_->add_force(motion, time, forces.contact, forces.friction);
    return {};
}

Matrix SolidForces::tangent(const Motion& motion, const TangentFactors& factors) const
{
    Matrix k = pattern_.zero();
    body_->add_stiffness(motion.displacement, k);
    for (std::size_t i = 0; i < loads_.size(); ++i)
        loads_[i]->add_tangent(motion, factors.scale * load_factor(i, factors.time), factors.velocity_slope, k);
    const double share = window_share_ * factors.scale;
    if (interface_) interface_->add_tangent(motion, share, factors.velocity_slope, k);
    if (correction_) correction_->add_tangent(motion, share, factors.velocity_slope, k);
    contact_->add_tangent(motion, factors.time, k);
    if (damped_) k.coeffs() += factors.velocity_slope * damping_.coeffs();
    k.coeffs() = factors.stiffness * k.coeffs() + factors.mass * mass_.coeffs();
    return k;
}

} // namespace fem
