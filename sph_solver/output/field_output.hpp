// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/xdmf.hpp"
#include "sph_solver/state/particles.hpp"

#include <string>

namespace sph {

/// Writes all particles to fields.h5 with fields.xdmf beside it, for ParaView: the point cloud with velocity, pressure,
/// density, volume, mass, number and rank, units and descriptions from the field table.
template<int D> class FieldOutput {
public:
    /// \param folder where the two files go; collective
    FieldOutput(const std::string& folder, const base::Communicator& comm);

    /// Adds one instant. Collective; derived fields of owned particles must be up to date.
    void write(double time, const Particles<D>& particles);

private:
    base::Communicator comm_;
    base::XdmfWriter writer_;
};

} // namespace sph
