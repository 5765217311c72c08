// SPDX-License-Identifier: MIT
#include "fem_solver/setup/solid_model.hpp"

#include "coupler_lib/base/csv_table.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/setup/formulation.hpp"
#include "fem_solver/setup/make_contact.hpp"
#include "fem_solver/setup/make_load.hpp"
#include "fem_solver/setup/make_mesh.hpp"

namespace fem {
namespace {

Marlow marlow(const std::string& path, double poisson)
{
    const base::CsvTable table = base::read_csv(path);
    try {
        auto curve = std::make_shared<const UniaxialCurve>(table.column("strain"), table.column("stress"));
        return {{curve}, bulk_modulus(curve->shear_modulus(), poisson)};
    } catch (const base::Error& error) {
        throw base::Error(error.code(), path + ": " + error.what());
    }
}

/// A formula of the reference position and of time, with its derivatives in time.
Supports::Path path(const base::Formula& formula, int dimension, double step)
{
    auto expression = std::make_shared<base::Expression>(formula, std::vector<std::string>{"x", "y", "z", "t"});
    return [=](const double* x) {
        const double z = dimension == 3 ? x[2] : 0;
        return base::with_derivatives(
            [=, x0 = x[0], y = x[1]](double t) {
                return (*expression)({x0, y, z, t});
            },
            step);
    };
}

Material sheet_material(const SolidConfig& config)
{
    Material material = make_material(config.material);
    if (config.model.assumption == "plane_stress") material.sheet = Sheet::plane_stress;
    material.softening = {config.material.softening_r, config.material.softening_m, config.material.softening_beta};
    return material;
}

} // namespace

Material make_material(const MaterialConfig& config)
{
    const double nu = config.poisson;
    const Lame lame = Lame::from_young(config.young, nu);
    if (config.law == "mooney_rivlin") {
        const double bulk = bulk_modulus(2 * (config.c10 + config.c01), nu);
        return {mooney_rivlin(config.c10, config.c01, bulk), config.density};
    }
    if (config.law == "ogden") {
        OgdenEnergy energy;
        for (std::size_t p = 0; p < config.moduli.size(); ++p)
            energy.terms.push_back({config.moduli[p], config.exponents[p]});
        return {Ogden{energy, bulk_modulus(energy.shear_modulus(), nu)}, config.density};
    }
    if (config.law == "marlow") return {marlow(config.curve, nu), config.density};
    if (config.law == "neo_hookean" && config.volumetric == "logarithmic") return {NeoHookeanLog{lame}, config.density};
    if (config.law == "neo_hookean") return {NeoHookean{lame}, config.density};
    if (config.kinematics == "small") return {SmallElastic{lame}, config.density};
    return {SaintVenantKirchhoff{lame}, config.density};
}

SolidModel::SolidModel(const SolidConfig& config, const Team& team)
    : mesh_(make_mesh(config, team)),
      supports_(mesh_),
      forces_(mesh_, sheet_material(config), body_settings(config.mesh))
{
    for (const SupportConfig& support : config.supports) add_support(support);
    for (const DriveConfig& drive : config.drives) add_drive(drive);
    forces_.set_damping({config.damping.stiffness, config.damping.mass});
    forces_.set_gravity(config.gravity.acceleration);
    for (const LoadConfig& load : config.loads) add_load(load);
    add_contacts(config.contacts, config.analysis.kind == "dynamic");
}

void SolidModel::add_support(const SupportConfig& support)
{
    if (!support.fix.empty()) supports_.fix(support.group, support.fix);
    if (support.symmetry) supports_.fix_normal(support.group);
    const std::pair<const char*, const base::Formula*> paths[] = {
        {"x", &support.ux}, {"y", &support.uy}, {"z", &support.uz}};
    for (const auto& [component, formula] : paths)
        if (!formula->text.empty())
            supports_.prescribe(support.group, component, path(*formula, mesh_.dimension, support.derivative_step));
}

void SolidModel::add_drive(const DriveConfig& drive)
{
    const auto point = [](const std::vector<double>& x, double z) {
        return x.empty() ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(x[0], x[1], x.size() == 3 ? x[2] : z);
    };
    const auto over_time = [&](const base::Formula& formula) {
        return base::with_derivatives(function_of_time(formula), drive.derivative_step);
    };
    supports_.drive(drive.group,
                    std::make_shared<RigidDrive>(point(drive.centre, 0), point(drive.axis, 0),
                                                 std::array{over_time(drive.x), over_time(drive.y), over_time(drive.z)},
                                                 over_time(drive.angle)));
}

void SolidModel::add_contacts(const std::vector<ContactConfig>& contacts, bool dynamic)
{
    if (contacts.empty()) return;
    auto all = std::make_unique<Contacts>();
    for (const ContactConfig& contact : contacts) all->add(make_contact(contact, mesh_, forces_, dynamic));
    contacts_ = all.get();
    forces_.set_contact(std::move(all));
}

void SolidModel::add_load(const LoadConfig& load)
{
    forces_.add_load(make_load(load, mesh_, forces_.pattern()), load.name, function_of_time(load.factor));
}

} // namespace fem
