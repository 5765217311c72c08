// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/config/solid_config.hpp"
#include "fem_solver/contact/contacts.hpp"
#include "fem_solver/dofs/supports.hpp"

namespace fem {

/// The solid as solid.toml describes it: mesh, supports, and everything that pulls at the nodes.
class SolidModel {
public:
    /// Collective over the team. \throws base::Error bad_input for unknown groups and unusable meshes.
    explicit SolidModel(const SolidConfig& config, const Team& team = {});
    SolidModel(const SolidModel&) = delete;

    const Mesh& mesh() const { return mesh_; }
    const Supports& supports() const { return supports_; }
    SolidForces& forces() { return forces_; }
    const SolidForces& forces() const { return forces_; }
    /// What the body may touch; none without [[contact]].
    const Contacts* contacts() const { return contacts_; }

private:
    void add_support(const SupportConfig& support);
    void add_drive(const DriveConfig& drive);
    void add_load(const LoadConfig& load);
    void add_contacts(const std::vector<ContactConfig>& contacts, bool dynamic);

    Mesh mesh_;
    Supports supports_;
    SolidForces forces_;
    const Contacts* contacts_ = nullptr;
};

/// The material of a configuration.
Material make_material(const MaterialConfig& config);

} // namespace fem
