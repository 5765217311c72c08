// SPDX-License-Identifier: MIT
// Probes that look at one place: pressure, velocity, wall_pressure.
#include "sph_solver/output/probe.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

/// Means of fields over the particles, weighted: the sum of the weights, then that of each weighted field.
class WeightedMeans {
public:
    explicit WeightedMeans(std::size_t fields) : sums_(1 + fields) {}

    void add(double weight, std::size_t field, double value) { sums_[1 + field].add(weight * value); }
    void add_weight(double weight) { sums_[0].add(weight); }

    void append(std::vector<double>& values, const base::Communicator& comm) const
    {
        const auto sums = comm.total(sums_);
        const double weight = sums[0].value();
        for (std::size_t k = 1; k < sums.size(); ++k) values.push_back(weight > 0.0 ? sums[k].value() / weight : 0.0);
    }

private:
    std::vector<base::ReproducibleSum> sums_;
};

template<int D> Vec<D> point_of(const ProbeConfig& config) { return Eigen::Map<const Vec<D>>(config.point.data()); }

template<int D> class PointPressure final : public Probe<D> {
public:
    PointPressure(const ProbeConfig& config, const ProbeScale<D>& scale)
        : point_(point_of<D>(config)), kernel_(scale.kernel)
    {}

    std::vector<std::string> columns() const override { return {".pressure[Pa]"}; }

    void append(std::vector<double>& values, const Particles<D>& particles,
                const base::Communicator& comm) const override
    {
        WeightedMeans means(1);
        for (const int owned : particles.owned) {
            const auto j = static_cast<std::size_t>(owned);
            const double r = (particles.position[j] - point_).norm();
            if (r >= kernel_.support()) continue;
            const double weight = particles.volume[j] * kernel_.value(r);
            means.add_weight(weight);
            means.add(weight, 0, particles.pressure[j]);
        }
        means.append(values, comm);
    }

private:
    Vec<D> point_;
    CubicSpline<D> kernel_;
};

template<int D> class PointVelocity final : public Probe<D> {
public:
    PointVelocity(const ProbeConfig& config, const ProbeScale<D>& scale)
        : point_(point_of<D>(config)), kernel_(scale.kernel)
    {}

    std::vector<std::string> columns() const override
    {
        std::vector<std::string> names = {".vx[m/s]", ".vy[m/s]", ".vz[m/s]"};
        names.resize(D);
        return names;
    }

    void append(std::vector<double>& values, const Particles<D>& particles,
                const base::Communicator& comm) const override
    {
        WeightedMeans means(D);
        for (const int owned : particles.owned) {
            const auto j = static_cast<std::size_t>(owned);
            const double r = (particles.position[j] - point_).norm();
            if (r >= kernel_.support()) continue;
            const double weight = particles.volume[j] * kernel_.value(r);
            means.add_weight(weight);
            for (int d = 0; d < D; ++d) means.add(weight, static_cast<std::size_t>(d), particles.velocity[j][d]);
        }
        means.append(values, comm);
    }

private:
    Vec<D> point_;
    CubicSpline<D> kernel_;
};

template<int D> class WallPressure final : public Probe<D> {
public:
    WallPressure(const ProbeConfig& config, const ProbeScale<D>& scale)
        : point_(point_of<D>(config)), reach_(Vec<D>::Constant(0.5 * std::max(config.size, scale.spacing)))
    {
        reach_[axis_number(config)] = 1.5 * scale.spacing;
    }

    std::vector<std::string> columns() const override { return {".wall_pressure[Pa]"}; }

    void append(std::vector<double>& values, const Particles<D>& particles,
                const base::Communicator& comm) const override
    {
        WeightedMeans means(1);
        for (const int owned : particles.owned) {
            const auto j = static_cast<std::size_t>(owned);
            if (((particles.position[j] - point_).array().abs() > reach_.array()).any()) continue;
            means.add_weight(particles.volume[j]);
            means.add(particles.volume[j], 0, particles.pressure[j]);
        }
        means.append(values, comm);
    }

private:
    Vec<D> point_, reach_;
};

} // namespace

template<int D> std::unique_ptr<Probe<D>> make_point_probe(const ProbeConfig& config, const ProbeScale<D>& scale)
{
    if (config.quantity == "pressure") return std::make_unique<PointPressure<D>>(config, scale);
    if (config.quantity == "velocity") return std::make_unique<PointVelocity<D>>(config, scale);
    if (config.quantity == "wall_pressure") return std::make_unique<WallPressure<D>>(config, scale);
    return nullptr;
}

template std::unique_ptr<Probe<2>> make_point_probe(const ProbeConfig&, const ProbeScale<2>&);
template std::unique_ptr<Probe<3>> make_point_probe(const ProbeConfig&, const ProbeScale<3>&);

} // namespace sph
