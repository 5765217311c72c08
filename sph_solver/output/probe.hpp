// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/config/output_config.hpp"
#include "sph_solver/numerics/kernel.hpp"
#include "sph_solver/state/particles.hpp"

#include <memory>
#include <string>
#include <vector>

namespace sph {

/// One quantity measured on the particles of all ranks, a number or a few; the answer does not depend on the partition.
template<int D> class Probe {
public:
    virtual ~Probe() = default;

    /// Column names behind the probe's own, with units: ".pressure[Pa]".
    [[nodiscard]] virtual std::vector<std::string> columns() const = 0;

    /// Appends a value for each column, the same on every rank. Collective; derived fields must be up to date.
    virtual void append(std::vector<double>& values, const Particles<D>& particles,
                        const base::Communicator& comm) const = 0;
};

/// What every probe may need to know of the method.
template<int D> struct ProbeScale {
    CubicSpline<D> kernel;
    double spacing; ///< dx [m]
};

/// Where particles count: everywhere, or between two corners (both included).
template<int D> class ProbeBox {
public:
    explicit ProbeBox(const ProbeConfig& config) : low_(config.low), high_(config.high) {}

    [[nodiscard]] bool holds(const Vec<D>& x) const
    {
        for (std::size_t d = 0; d < low_.size(); ++d) {
            const double coordinate = x[static_cast<int>(d)];
            if (coordinate < low_[d] || coordinate > high_[d]) return false;
        }
        return true;
    }

private:
    std::vector<double> low_, high_;
};

inline int axis_number(const ProbeConfig& config) { return config.axis == "x" ? 0 : config.axis == "y" ? 1 : 2; }

/// The probe of a configuration.
///
///     pressure, velocity  f(x) = sum w_j f_j W(|x - x_j|) / sum w_j W(|x - x_j|); 0 where there is no water
///     wall_pressure       sum w_j p_j / sum w_j over the particles before a square sensor: at most 1.5 dx away from it
///                         along the axis, the wall's normal; 0 where there are none. A sensor smaller than dx is dx wide
///     front, back         largest, smallest coordinate along the axis of the particles in the box, half a spacing further;
///                         NaN without particles
///     mass, kinetic       sums over the particles in the box
///     semi_axes           of the ellipse (2D) or ellipsoid (3D) with the same second moments as the water in the box, the
///                         longest first: sqrt((D + 2) lambda_k), lambda the eigenvalues of sum w_j y_j y_j^T / sum w_j, y_j
///                         seen from the centroid
template<int D> std::unique_ptr<Probe<D>> make_probe(const ProbeConfig& config, const ProbeScale<D>& scale);

// The kinds, each with the quantities that it measures.
template<int D> std::unique_ptr<Probe<D>> make_point_probe(const ProbeConfig& config, const ProbeScale<D>& scale);
template<int D> std::unique_ptr<Probe<D>> make_body_probe(const ProbeConfig& config, const ProbeScale<D>& scale);

} // namespace sph
