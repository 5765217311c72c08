// SPDX-License-Identifier: MIT
#include "sph_solver/output/probes.hpp"

#include <cmath>
#include <limits>

namespace sph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template<int D> bool in_box(const ProbeConfig& probe, const Vec<D>& x)
{
    for (std::size_t d = 0; d < probe.low.size(); ++d) {
        const double coordinate = x[static_cast<int>(d)];
        if (coordinate < probe.low[d] || coordinate > probe.high[d]) return false;
    }
    return true;
}

std::string unit_of(const std::string& quantity, int dimension)
{
    if (quantity == "pressure") return "[Pa]";
    if (quantity == "velocity") return "[m/s]";
    if (quantity == "mass") return dimension == 2 ? "[kg/m]" : "[kg]";
    if (quantity == "kinetic") return dimension == 2 ? "[J/m]" : "[J]";
    return "[m]";
}

} // namespace

template<int D> std::vector<std::string> Probes<D>::columns() const
{
    std::vector<std::string> names;
    for (const ProbeConfig& probe : probes_) {
        const std::string unit = unit_of(probe.quantity, D);
        if (probe.quantity != "velocity") {
            names.push_back(probe.name + "." + probe.quantity + unit);
            continue;
        }
        for (int d = 0; d < D; ++d) names.push_back(probe.name + ".v" + "xyz"[d] + unit);
    }
    return names;
}

template<int D>
std::vector<double> Probes<D>::values(const Particles<D>& particles, const base::Communicator& comm) const
{
    std::vector<double> values;
    for (const ProbeConfig& probe : probes_) {
        if (probe.quantity == "pressure" || probe.quantity == "velocity") {
            append_average(values, probe, particles, comm);
        } else if (probe.quantity == "front" || probe.quantity == "back") {
            values.push_back(extreme(probe, particles, comm));
        } else {
            values.push_back(total(probe, particles, comm));
        }
    }
    return values;
}

template<int D>
void Probes<D>::append_average(std::vector<double>& values, const ProbeConfig& probe, const Particles<D>& particles,
                               const base::Communicator& comm) const
{
    const Vec<D> point = Eigen::Map<const Vec<D>>(probe.point.data());
    const bool is_pressure = probe.quantity == "pressure";
    std::vector<base::ReproducibleSum> sums(is_pressure ? 2 : 1 + D);
    for (const int owned : particles.owned) {
        const auto j = static_cast<std::size_t>(owned);
        const double r = (particles.position[j] - point).norm();
        if (r >= kernel_.support()) continue;
        const double weight = particles.volume[j] * kernel_.value(r);
        sums[0].add(weight);
        if (is_pressure) {
            sums[1].add(weight * particles.pressure[j]);
            continue;
        }
        for (int d = 0; d < D; ++d) sums[static_cast<std::size_t>(1 + d)].add(weight * particles.velocity[j][d]);
    }
    sums = comm.total(sums);
    const double weight = sums[0].value();
    for (std::size_t k = 1; k < sums.size(); ++k) values.push_back(weight > 0.0 ? sums[k].value() / weight : 0.0);
}

template<int D>
double Probes<D>::extreme(const ProbeConfig& probe, const Particles<D>& particles, const base::Communicator& comm) const
{
    const int axis = probe.axis == "x" ? 0 : probe.axis == "y" ? 1 : 2;
    const double sign = probe.quantity == "front" ? 1.0 : -1.0;
    double furthest = -infinity;
    for (const int owned : particles.owned) {
        const Vec<D>& x = particles.position[static_cast<std::size_t>(owned)];
        if (in_box<D>(probe, x)) furthest = std::max(furthest, sign * x[axis]);
    }
    furthest = comm.max(furthest);
    return std::isfinite(furthest) ? sign * (furthest + 0.5 * spacing_) : std::numeric_limits<double>::quiet_NaN();
}

template<int D>
double Probes<D>::total(const ProbeConfig& probe, const Particles<D>& particles, const base::Communicator& comm) const
{
    base::ReproducibleSum sum;
    for (const int owned : particles.owned) {
        const auto j = static_cast<std::size_t>(owned);
        if (!in_box<D>(probe, particles.position[j])) continue;
        sum.add(probe.quantity == "mass" ? particles.mass[j]
                                         : 0.5 * particles.momentum[j].squaredNorm() / particles.mass[j]);
    }
    return comm.total(sum).value();
}

template class Probes<2>;
template class Probes<3>;

} // namespace sph
