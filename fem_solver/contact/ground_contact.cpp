// SPDX-License-Identifier: MIT
#include "fem_solver/contact/ground_contact.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace fem {

GroundContact::GroundContact(const Mesh& mesh, const MatrixPattern& pattern, std::shared_ptr<const base::Ground> ground,
                             ContactSettings settings, std::vector<ContactPoint> points)
    : mesh_(&mesh),
      pattern_(&pattern),
      ground_(std::move(ground)),
      settings_(std::move(settings)),
      faces_(mesh.faces(settings_.group)),
      points_(std::move(points)),
      reference_areas_(face_areas(mesh, faces_, Eigen::VectorXd::Zero(std::ssize(mesh.coordinates)))),
      accepted_(points_.size()),
      now_(points_.size())
{
    const Motion rest = Motion::at_rest(std::ssize(mesh.coordinates));
    const Eigen::Vector3d shift = moved_ground(0);
    for (std::size_t k = 0; k < points_.size(); ++k) accepted_[k].place = position(points_[k], rest) - shift;
}

double GroundContact::stiffness() const
{
    double largest = 0;
    for (const ContactPoint& point : points_)
        if (point.own) largest = std::max(largest, point.area);
    return largest * std::max(settings_.constants.normal_penalty, settings_.constants.tangential_penalty);
}

void GroundContact::restore()
{
    for (std::size_t k = 0; k < points_.size(); ++k) now_[k] = accepted_[k].multipliers;
    augmentations_ = 0;
    complaint_.clear();
}

void GroundContact::add_force(const Motion& motion, double time, Eigen::VectorXd& normal,
                              Eigen::VectorXd& friction) const
{
    visit(motion, time, [&](std::size_t k, const base::GroundPoint& ground, const ContactTraction& traction) {
        add(points_[k], traction.pressure * ground.normal, normal);
        add(points_[k], traction.friction, friction);
    });
}

void GroundContact::add_tangent(const Motion& motion, double time, Matrix& matrix) const
{
    const int d = mesh_->dimension;
    visit(motion, time, [&](std::size_t k, const base::GroundPoint&, const ContactTraction& traction) {
        const ContactPoint& point = points_[k];
        for (std::size_t a = 0; a < point.nodes.size(); ++a)
            for (std::size_t b = 0; b < point.nodes.size(); ++b)
                pattern_->add_block(matrix, point.nodes[a], point.nodes[b],
                                    -point.area * point.values[a] * point.values[b] *
                                        traction.slope.topLeftCorner(d, d));
    });
}

Augmentation GroundContact::augment(const Motion& motion, double time)
{
    if (!settings_.augmented) return Augmentation::settled;
    std::vector<Multipliers> next(points_.size());
    visit(motion, time, [&](std::size_t k, const base::GroundPoint&, const ContactTraction& traction) {
        next[k] = {traction.pressure, traction.friction};
    });
    double worst = 0; // over the tolerated one
    std::size_t where = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const double off = points_[k].own ? miss(k, next[k]) : 0; // a copy knows part of its faces only
        if (off > worst) where = k;
        worst = std::max(worst, off);
    }
    now_ = std::move(next);
    if (!mesh_->team().any(worst > 1)) return Augmentation::settled;
    if (++augmentations_ <= settings_.max_augmentations) return Augmentation::again;
    complain(motion, time, where, worst);
    return Augmentation::unsettled;
}

void GroundContact::accept(const Motion& motion, double time)
{
    const Eigen::Vector3d shift = moved_ground(time);
    std::vector<State> next(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) {
        next[k].place = position(points_[k], motion) - shift;
        next[k].slip = accepted_[k].slip;
    }
    visit(motion, time, [&](std::size_t k, const base::GroundPoint& ground, const ContactTraction& traction) {
        next[k].multipliers = {settings_.augmented ? traction.pressure : 0, traction.friction};
        const Eigen::Vector3d way = next[k].place - accepted_[k].place;
        if (!traction.sticks) next[k].slip += (way - ground.normal * ground.normal.dot(way)).norm();
    });
    accepted_ = std::move(next);
    restore();
}

ContactResultants GroundContact::resultants(const Motion& motion, double time) const
{
    ContactResultants sum;
    const std::vector<double> stretch = stretches(motion);
    visit(motion, time, [&](std::size_t k, const base::GroundPoint& ground, const ContactTraction& traction) {
        if (!points_[k].own) return;
        const double area = points_[k].area;
        sum.normal += area * traction.pressure * ground.normal;
        sum.friction += area * traction.friction;
        sum.area += area * stretch[k];
        sum.pressure = std::max(sum.pressure, traction.pressure / stretch[k]);
        sum.penetration = std::max(sum.penetration, -ground.gap);
    });
    const Team& team = mesh_->team();
    team.sum(sum.normal.data(), 3);
    team.sum(sum.friction.data(), 3);
    sum.area = team.sum(sum.area);
    sum.pressure = team.max(sum.pressure);
    sum.penetration = team.max(sum.penetration);
    return sum;
}

void GroundContact::add_fields(const Motion& motion, double time, std::vector<double>& pressure,
                               std::vector<double>& slip) const
{
    std::vector<double> share(pressure.size(), 0.0), press(pressure.size(), 0.0), way(pressure.size(), 0.0);
    const std::vector<double> stretch = stretches(motion);
    const auto spread = [&](std::size_t k, double value, std::vector<double>& to) {
        for (std::size_t a = 0; a < points_[k].nodes.size(); ++a)
            to[static_cast<std::size_t>(points_[k].nodes[a])] +=
                std::abs(points_[k].values[a]) * points_[k].area * value;
    };
    for (std::size_t k = 0; k < points_.size(); ++k) {
        spread(k, 1, share);
        spread(k, accepted_[k].slip, way);
    }
    visit(motion, time, [&](std::size_t k, const base::GroundPoint&, const ContactTraction& traction) {
        spread(k, traction.pressure / stretch[k], press);
    });
    for (std::size_t i = 0; i < share.size(); ++i) {
        if (share[i] == 0) continue;
        pressure[i] += press[i] / share[i];
        slip[i] += way[i] / share[i];
    }
}

Eigen::Vector3d GroundContact::position(const ContactPoint& point, const Motion& motion) const
{
    const int d = mesh_->dimension;
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (std::size_t a = 0; a < point.nodes.size(); ++a)
        for (int k = 0; k < d; ++k)
            x[k] += point.values[a] * (mesh_->node(point.nodes[a])[k] + motion.displacement[point.nodes[a] * d + k]);
    return x;
}

Eigen::Vector3d GroundContact::moved_ground(double time) const
{
    return settings_.ground_motion ? settings_.ground_motion(time) : Eigen::Vector3d::Zero();
}

/// Present over reference area around each point.
std::vector<double> GroundContact::stretches(const Motion& motion) const
{
    const std::vector<double> present = face_areas(*mesh_, faces_, motion.displacement);
    std::vector<double> result;
    for (const ContactPoint& point : points_) {
        double now = 0, once = 0;
        for (const int face : point.faces) {
            now += present[static_cast<std::size_t>(face)];
            once += reference_areas_[static_cast<std::size_t>(face)];
        }
        result.push_back(now / once);
    }
    return result;
}

/// Calls `action(point, ground, traction)` for every point that touches the ground.
template<class Action> void GroundContact::visit(const Motion& motion, double time, Action&& action) const
{
    const Eigen::Vector3d shift = moved_ground(time);
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const Eigen::Vector3d place = position(points_[k], motion) - shift;
        const base::GroundPoint ground = ground_->at(place);
        const ContactTraction traction =
            contact_traction(ground, now_[k], place - accepted_[k].place, settings_.constants);
        if (traction.touches) action(k, ground, traction);
    }
}

void GroundContact::add(const ContactPoint& point, const Eigen::Vector3d& traction, Eigen::VectorXd& force) const
{
    const int d = mesh_->dimension;
    for (std::size_t a = 0; a < point.nodes.size(); ++a)
        force.segment(static_cast<Eigen::Index>(point.nodes[a]) * d, d) +=
            point.area * point.values[a] * traction.head(d);
}

/// How far new multipliers are off the present ones, as a length over the tolerated one: the gap that is left in
/// contact, and the way slid while sticking.
double GroundContact::miss(std::size_t k, const Multipliers& next) const
{
    const ContactConstants& constants = settings_.constants;
    const double gap = std::abs(next.pressure - now_[k].pressure) / constants.normal_penalty;
    const bool sticks = next.traction.norm() < (1 - 1e-9) * constants.friction * next.pressure;
    const double slid = sticks ? (next.traction - now_[k].traction).norm() / constants.tangential_penalty : 0;
    return std::max(gap, slid) / (settings_.tolerance * points_[k].size);
}

void GroundContact::complain(const Motion& motion, double time, std::size_t where, double worst)
{
    std::string left;
    if (worst > 1) {
        const Eigen::Vector3d x = position(points_[where], motion);
        left = base::text(worst * settings_.tolerance * points_[where].size, " m are left, ", worst,
                          " times the tolerated, at node ", mesh_->node_id(points_[where].nodes[0]), ", position (",
                          x[0], ", ", x[1], ", ", x[2], ") m");
    }
    complaint_ =
        base::text("has a contact, group '", settings_.group, "', that did not settle in ", settings_.max_augmentations,
                   " augmentations at t = ", time, " s: ", mesh_->team().first_text(left));
}

} // namespace fem
