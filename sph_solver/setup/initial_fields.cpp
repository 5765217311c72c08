// SPDX-License-Identifier: MIT
#include "sph_solver/setup/initial_fields.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace sph {
namespace {

template<int D> std::vector<std::string> coordinates()
{
    std::vector<std::string> names = {"x", "y", "z"};
    names.resize(D);
    return names;
}

template<int D> std::vector<double> numbers_of(const Vec<D>& x) { return {x.begin(), x.end()}; }

double density_at(const Tait& eos, double pressure, const base::Formula& formula)
{
    base::require_input(
        pressure > -eos.stiffness(), formula.where, ": the pressure \"", formula.text, "\" is ", pressure,
        " Pa somewhere in the water; no density gives less than -rho0 c0^2/7 = ", -eos.stiffness(), " Pa");
    return eos.density(pressure);
}

} // namespace

double hydrostatic_density(const Tait& eos, double gravity, double depth)
{
    constexpr double exponent = Tait::gamma - 1.0;
    const double head = exponent * gravity * std::max(depth, 0.0) / (eos.c0 * eos.c0);
    return eos.rho0 * std::pow(1.0 + head, 1.0 / exponent);
}

template<int D>
DensityField<D> initial_density(const FluidConfig& config, const WaterConfig& water, const FluidModel<D>& model,
                                double level)
{
    const Tait eos = model.eos;
    const base::Formula& formula = config.initial.pressure;
    if (config.initial.state == "field") {
        const auto pressure = std::make_shared<base::Expression>(formula, coordinates<D>());
        return [=](const Vec<D>& x) { return density_at(eos, (*pressure)(numbers_of<D>(x)), formula); };
    }
    const double gravity = model.gravity.norm();
    if (config.initial.state == "uniform" || gravity == 0.0) {
        const bool given = config.initial.state == "uniform";
        const double rho = given ? density_at(eos, base::Expression(formula, {})({}), formula) : eos.rho0;
        return [=](const Vec<D>&) { return rho; };
    }
    const Vec<D> up = -model.gravity / gravity;
    for (const double named : {config.initial.level, water.level})
        if (std::isfinite(named)) level = named;
    return [=](const Vec<D>& x) { return hydrostatic_density(eos, gravity, level - up.dot(x)); };
}

template<int D> VelocityField<D> initial_velocity(const WaterConfig& water)
{
    if (water.velocity.empty()) return {};
    auto components = std::make_shared<std::vector<base::Expression>>();
    for (const base::Formula& formula : water.velocity) components->emplace_back(formula, coordinates<D>());
    return [components](const Vec<D>& x) {
        Vec<D> v;
        for (int d = 0; d < D; ++d) v[d] = (*components)[static_cast<std::size_t>(d)](numbers_of<D>(x));
        return v;
    };
}

template DensityField<2> initial_density(const FluidConfig&, const WaterConfig&, const FluidModel<2>&, double);
template DensityField<3> initial_density(const FluidConfig&, const WaterConfig&, const FluidModel<3>&, double);
template VelocityField<2> initial_velocity(const WaterConfig&);
template VelocityField<3> initial_velocity(const WaterConfig&);

} // namespace sph
