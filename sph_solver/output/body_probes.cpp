// SPDX-License-Identifier: MIT
// Probes that look at all water in a box: front, back, mass, kinetic, semi_axes.
#include "sph_solver/output/probe.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>

namespace sph {
namespace {

template<int D> class Extreme final : public Probe<D> {
public:
    Extreme(const ProbeConfig& config, const ProbeScale<D>& scale)
        : box_(config),
          name_("." + config.quantity + "[m]"),
          axis_(axis_number(config)),
          sign_(config.quantity == "front" ? 1.0 : -1.0),
          spacing_(scale.spacing)
    {}

    std::vector<std::string> columns() const override { return {name_}; }

    void append(std::vector<double>& values, const Particles<D>& particles,
                const base::Communicator& comm) const override
    {
        double furthest = -std::numeric_limits<double>::infinity();
        for (const int owned : particles.owned) {
            const Vec<D>& x = particles.position[static_cast<std::size_t>(owned)];
            if (box_.holds(x)) furthest = std::max(furthest, sign_ * x[axis_]);
        }
        furthest = comm.max(furthest);
        values.push_back(std::isfinite(furthest) ? sign_ * (furthest + 0.5 * spacing_)
                                                 : std::numeric_limits<double>::quiet_NaN());
    }

private:
    ProbeBox<D> box_;
    std::string name_;
    int axis_;
    double sign_, spacing_;
};

template<int D> class Mass final : public Probe<D> {
public:
    explicit Mass(const ProbeConfig& config) : box_(config) {}

    std::vector<std::string> columns() const override { return {D == 2 ? ".mass[kg/m]" : ".mass[kg]"}; }

    void append(std::vector<double>& values, const Particles<D>& particles,
                const base::Communicator& comm) const override
    {
        base::ReproducibleSum sum;
        for (const int owned : particles.owned) {
            const auto j = static_cast<std::size_t>(owned);
            if (box_.holds(particles.position[j])) sum.add(particles.mass[j]);
        }
        values.push_back(comm.total(sum).value());
    }

private:
    ProbeBox<D> box_;
};

template<int D> class Kinetic final : public Probe<D> {
public:
    explicit Kinetic(const ProbeConfig& config) : box_(config) {}

    std::vector<std::string> columns() const override { return {D == 2 ? ".kinetic[J/m]" : ".kinetic[J]"}; }

    void append(std::vector<double>& values, const Particles<D>& particles,
                const base::Communicator& comm) const override
    {
        base::ReproducibleSum sum;
        for (const int owned : particles.owned) {
            const auto j = static_cast<std::size_t>(owned);
            if (box_.holds(particles.position[j]))
                sum.add(0.5 * particles.momentum[j].squaredNorm() / particles.mass[j]);
        }
        values.push_back(comm.total(sum).value());
    }

private:
    ProbeBox<D> box_;
};

/// Sums of w, w x and w x x^T give the moments about the centroid.
template<int D> class SemiAxes final : public Probe<D> {
public:
    explicit SemiAxes(const ProbeConfig& config) : box_(config) {}

    std::vector<std::string> columns() const override
    {
        std::vector<std::string> names = {".semi_axis_1[m]", ".semi_axis_2[m]", ".semi_axis_3[m]"};
        names.resize(D);
        return names;
    }

    void append(std::vector<double>& values, const Particles<D>& particles,
                const base::Communicator& comm) const override
    {
        std::vector<base::ReproducibleSum> sums(1 + D + D * D);
        for (const int owned : particles.owned) {
            const auto j = static_cast<std::size_t>(owned);
            if (box_.holds(particles.position[j])) add(sums, particles.volume[j], particles.position[j]);
        }
        sums = comm.total(sums);
        const double weight = sums[0].value();
        if (weight <= 0.0) {
            values.insert(values.end(), D, std::numeric_limits<double>::quiet_NaN());
            return;
        }
        Vec<D> centroid;
        Mat<D> moments;
        for (int a = 0; a < D; ++a) centroid[a] = sums[static_cast<std::size_t>(1 + a)].value() / weight;
        for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b)
                moments(a, b) =
                    sums[static_cast<std::size_t>(1 + D + D * a + b)].value() / weight - centroid[a] * centroid[b];
        const Vec<D> lambda = Eigen::SelfAdjointEigenSolver<Mat<D>>(moments, Eigen::EigenvaluesOnly).eigenvalues();
        for (int a = D; a-- > 0;) values.push_back(std::sqrt((D + 2) * std::max(lambda[a], 0.0)));
    }

private:
    static void add(std::vector<base::ReproducibleSum>& sums, double w, const Vec<D>& x)
    {
        sums[0].add(w);
        for (int a = 0; a < D; ++a) {
            sums[static_cast<std::size_t>(1 + a)].add(w * x[a]);
            for (int b = 0; b < D; ++b) sums[static_cast<std::size_t>(1 + D + D * a + b)].add(w * x[a] * x[b]);
        }
    }

    ProbeBox<D> box_;
};

} // namespace

template<int D> std::unique_ptr<Probe<D>> make_body_probe(const ProbeConfig& config, const ProbeScale<D>& scale)
{
    if (config.quantity == "front" || config.quantity == "back") return std::make_unique<Extreme<D>>(config, scale);
    if (config.quantity == "mass") return std::make_unique<Mass<D>>(config);
    if (config.quantity == "kinetic") return std::make_unique<Kinetic<D>>(config);
    if (config.quantity == "semi_axes") return std::make_unique<SemiAxes<D>>(config);
    return nullptr;
}

template std::unique_ptr<Probe<2>> make_body_probe(const ProbeConfig&, const ProbeScale<2>&);
template std::unique_ptr<Probe<3>> make_body_probe(const ProbeConfig&, const ProbeScale<3>&);

} // namespace sph
