// SPDX-License-Identifier: MIT
#include "fem_solver/setup/make_contact.hpp"

#include "coupler_lib/base/stl_file.hpp"
#include "fem_solver/setup/make_load.hpp"

namespace fem {
namespace {

Eigen::Vector3d in_space(const std::vector<double>& x) { return {x[0], x[1], x.size() == 3 ? x[2] : 0.0}; }

std::shared_ptr<const base::Ground> make_ground(const ContactConfig& config, int dimension)
{
    if (config.ground == "plane") return base::make_plane(in_space(config.point), in_space(config.normal));
    if (config.ground == "surface")
        return dimension == 2 ? base::make_polyline_ground(config.file)
                              : base::make_surface_ground(base::read_stl(config.file, config.scale), config.file);
    auto height = config.ground == "table"
                      ? base::make_height_file(config.file, dimension)
                      : base::make_height_formula(config.height, dimension, config.derivative_step);
    return base::make_height_ground(std::move(height), dimension);
}

} // namespace

std::unique_ptr<GroundContact> make_contact(const ContactConfig& config, const Mesh& mesh, const SolidForces& forces,
                                            bool dynamic)
{
    Eigen::VectorXd diagonal = forces.initial_stiffness().diagonal();
    forces.map().refresh(diagonal);
    auto points = contact_points(mesh, mesh.faces(config.group));
    const double stiffness = surface_stiffness(points, diagonal, mesh);
    ContactSettings settings;
    settings.group = config.group;
    settings.constants.normal_penalty = config.penalty_factor * stiffness;
    settings.constants.tangential_penalty = config.stick_factor * settings.constants.normal_penalty;
    settings.constants.friction = config.friction;
    settings.augmented = config.formulation == "automatic" ? !dynamic : config.formulation == "augmented_lagrangian";
    settings.tolerance = config.tolerance;
    settings.max_augmentations = config.max_augmentations;
    const auto x = function_of_time(config.ux), y = function_of_time(config.uy), z = function_of_time(config.uz);
    settings.ground_motion = [=](double t) { return Eigen::Vector3d(x(t), y(t), z(t)); };
    return std::make_unique<GroundContact>(mesh, forces.pattern(), make_ground(config, mesh.dimension), settings,
                                           std::move(points));
}

} // namespace fem
