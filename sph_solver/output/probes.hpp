// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/config/output_config.hpp"
#include "sph_solver/numerics/kernel.hpp"
#include "sph_solver/state/particles.hpp"

#include <string>
#include <vector>

namespace sph {

/// The quantities of [[probes]], measured on the particles of all ranks; the answers do not depend on the partition.
///
///     pressure, velocity  f(x) = sum w_j f_j W(|x - x_j|) / sum w_j W(|x - x_j|); 0 where there is no water
///     front, back         largest, smallest coordinate along the axis of the particles in the box, half a spacing further;
///                         NaN without particles
///     mass, kinetic       sums over the particles in the box
template<int D> class Probes {
public:
    Probes(std::vector<ProbeConfig> probes, const CubicSpline<D>& kernel, double spacing)
        : probes_(std::move(probes)), kernel_(kernel), spacing_(spacing)
    {}

    /// Column names "name.quantity[unit]"; a vector has a column for each component.
    [[nodiscard]] std::vector<std::string> columns() const;

    /// Values in the order of columns(), the same on every rank. Collective; derived fields must be up to date.
    [[nodiscard]] std::vector<double> values(const Particles<D>& particles, const base::Communicator& comm) const;

private:
    void append_average(std::vector<double>& values, const ProbeConfig& probe, const Particles<D>& particles,
                        const base::Communicator& comm) const;
    [[nodiscard]] double extreme(const ProbeConfig& probe, const Particles<D>& particles,
                                 const base::Communicator& comm) const;
    [[nodiscard]] double total(const ProbeConfig& probe, const Particles<D>& particles,
                               const base::Communicator& comm) const;

    std::vector<ProbeConfig> probes_;
    CubicSpline<D> kernel_;
    double spacing_;
};

} // namespace sph
