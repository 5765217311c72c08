// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"
#include "coupler_lib/fake/fake_config.hpp"
#include "coupler_lib/foundation/communicator.hpp"

#include <array>

namespace coupler {

/// The flat rigid surface of the piston: this rank's share of its facets, and how it moves along the axis.
class PistonSurface {
public:
    /// Facets are dealt to the ranks in blocks.
    PistonSurface(const PistonSurfaceConfig& config, const base::Communicator& comm);

    const WetSurface& wet() const { return wet_; }
    double length() const { return length_; } ///< of the whole surface [m], its wet area per metre of depth

    std::array<double, 2> displacement_vector(double displacement) const;
    double axis_cosine() const { return axis_[0] * normal_[0] + axis_[1] * normal_[1]; } ///< axis . n
    SurfaceMotion motion(double displacement, double velocity, double acceleration) const;
    /// Load along the axis per area [Pa]; collective. `pressure` acts along -n, forces as they are.
    double axial(const SurfaceLoad& load) const;
    /// Mean nodal velocity along the axis [m/s]; the same at every node.
    double axial(const std::vector<double>& nodal) const;
    /// Total force [N/m] and moment about the origin [N], z last, of a load per area along the axis plus what of the
    /// received load acts across it.
    void resultants(const SurfaceLoad& load, double displacement, double axial_load, SolidReport& report) const;

private:
    std::array<double, 2> total_force(const SurfaceLoad& load) const;

    const base::Communicator* comm_;
    WetSurface wet_;
    std::array<double, 2> axis_{}, normal_{}, centre_{};
    double length_ = 0;
};

} // namespace coupler
