// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/surface.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace coupler {

class Participant;

/// The solid's end of the interface: one per solid rank, owner of that rank's part of the wet surface.
///
/// The life of a run:
///
///     SolidInterface wet(participant, settings, surface);      // register
///     wet.receive(load, fluid); wet.send(motion at t0, ...);   // greeting, window.step == -1: load is zero
///     window = wet.receive(load, fluid);                       // load 0: solve the initial acceleration
///     wet.send(motion at t0, ...);
///     (step window.time -> window.time + window.dt with f_1 = load 0)
///     window = wet.receive(load, fluid); wet.send(motion at t1, ...); (step with f_1 = load 1) ...
///
/// until `window.last`: answer once more with the motion at window.time, then leave.
class SolidInterface {
public:
    /// Collective over the solid's ranks. Throws base::Error(bad_input) on a facet id that occurs twice, a node index
    /// out of range, a facet of no extent or with the wrong number of nodes.
    SolidInterface(Participant& participant, InterfaceSettings settings, WetSurface surface);
    ~SolidInterface();
    SolidInterface(const SolidInterface&) = delete;
    SolidInterface& operator=(const SolidInterface&) = delete;

    /// Waits for the packet of every fluid rank and sums the loads exactly (independent of the fluid's partition).
    ///
    /// \param load   conservative: `force`; averaged: `pressure` = weighted_pressure / weight, zero where the coverage
    ///               weight / full_weight is below the limit; arrays of the other kind are left empty
    /// \param fluid  the fluid's report
    /// \return the window, the same on every solid rank
    /// Throws base::Error as FluidInterface::receive does.
    Window receive(SurfaceLoad& load, FluidReport& fluid);

    /// Answers the last `receive`: every fluid rank is sent the facets whose current box touches its region.
    ///
    /// Throws base::Error(numerical_failure) when a value is not a number or a node jumped beyond the limit since the
    /// last `send`, naming node, position and rank.
    void send(const SurfaceMotion& motion, const SolidReport& report);

    [[nodiscard]] const WetSurface& surface() const; ///< as registered
    /// Fingerprint of all loads received so far, this rank, 16 hexadecimal digits: every bit of every sum, in order.
    /// The same whatever the number of fluid ranks that sent them.
    [[nodiscard]] std::string loads_hash() const;
    [[nodiscard]] double wait_seconds() const;         ///< waited in `receive` so far, this rank [s]
    [[nodiscard]] std::int64_t bytes_sent() const;     ///< payload sent so far, this rank [byte]
    [[nodiscard]] std::int64_t bytes_received() const; ///< payload received so far, this rank [byte]

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace coupler
