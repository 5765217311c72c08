// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/output/probe.hpp"

namespace sph {

/// The quantities of [[probes]], in the order of the file.
template<int D> class Probes {
public:
    Probes(const std::vector<ProbeConfig>& probes, const CubicSpline<D>& kernel, double spacing);

    /// Column names "name.quantity[unit]"; a vector has a column for each component.
    [[nodiscard]] std::vector<std::string> columns() const;

    /// Values in the order of columns(), the same on every rank. Collective; derived fields must be up to date.
    [[nodiscard]] std::vector<double> values(const Particles<D>& particles, const base::Communicator& comm) const;

private:
    std::vector<std::string> names_;
    std::vector<std::unique_ptr<Probe<D>>> probes_;
};

} // namespace sph
