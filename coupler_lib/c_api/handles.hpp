// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/c_api/rivage.h"
#include "coupler_lib/coupling/acceleration_filter.hpp"
#include "coupler_lib/coupling/fluid_interface.hpp"
#include "coupler_lib/coupling/load_prediction.hpp"
#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/coupling/solid_interface.hpp"
#include "coupler_lib/session/energy_record.hpp"
#include "coupler_lib/session/interface_record.hpp"
#include "coupler_lib/session/session.hpp"

#include <optional>
#include <string>

/// What the opaque handles of the C interface hold.
struct rivage_participant {
    rivage_participant(const coupler::ParticipantSettings& settings, coupler::CouplingConfig shared)
        : member(settings), config(std::move(shared))
    {}
    coupler::Participant member;
    coupler::CouplingConfig config;
    std::string output_dir; ///< of --out
};

struct rivage_solid {
    rivage_solid(rivage_participant& of, coupler::WetSurface surface);

    coupler::SolidInterface exchange;
    coupler::AccelerationFilter filter;
    std::unique_ptr<coupler::LoadPrediction> prediction;
    std::size_t values; ///< nodes times dimension
    coupler::Window window;
    coupler::SurfaceLoad load;
    coupler::FluidReport fluid;
};

struct rivage_fluid {
    rivage_fluid(rivage_participant& of, const coupler::InterfaceConfig& interface, int dimension, double impedance,
                 double pressure_limit, const char* output_dir);

    coupler::FluidInterface exchange;
    const coupler::FacetBatch nothing;
    const coupler::FacetBatch* batch = &nothing; ///< of the last receive
    coupler::Window window;
    coupler::FluidReport report;
    std::optional<coupler::InterfaceRecord> record; ///< on rank 0, where there is an output folder
    std::optional<coupler::EnergyRecord> energies;  ///< where it is the only interface too
};

namespace coupler::c_api {

/// Keeps the message for rivage_last_error.
int remember(int code, const std::string& message);

/// Calls it; what it throws becomes a code and a message, for nothing may be thrown through C.
template<class Call> int guarded(Call&& call) noexcept
{
    try {
        call();
        return remember(RIVAGE_OK, "");
    } catch (const base::Error& error) {
        return remember(static_cast<int>(error.code()), error.what());
    } catch (const std::exception& error) {
        return remember(RIVAGE_NUMERICAL_FAILURE, error.what());
    }
}

FluidReport from_c(const rivage_fluid_report& report);
SolidReport from_c(const rivage_solid_report& report);
rivage_fluid_report to_c(const FluidReport& report);
rivage_solid_report to_c(const SolidReport& report);

} // namespace coupler::c_api
