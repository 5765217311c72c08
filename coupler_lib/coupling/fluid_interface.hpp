// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/surface.hpp"

#include <cstdint>
#include <memory>

namespace coupler {

class Participant;

/// The fluid's end of the interface: one per fluid rank.
///
/// Each `send` goes to every rank of the solid, each `receive` takes one answer from every rank of the solid; there is
/// no root. The life of a run, with n counting fluid steps:
///
///     send(Window{-1, t0, 0}, box, {}, batch, report); batch = receive(...)     // greeting: where are the facets?
///     (evaluate load 0 at t0)
///     send(Window{0, t0, dt0}, box, loads, batch, report); batch = receive(...)  // motion at t0 with its acceleration
///     (step t0 -> t1 with the walls X + V s + A s^2/2, measuring load 1)
///     send(Window{1, t1, dt1}, box, loads, batch, report); ...
///
/// until a window says `last`: it is answered with the motion at the end time, and nothing follows.
class FluidInterface {
public:
    /// \param participant  of this rank, coupled; must outlive the interface
    /// \param settings     impedance [kg/(m^2 s)] and limits of the fluid
    /// \param dimension    2 or 3; a solid of another dimension is an error at the greeting
    FluidInterface(Participant& participant, InterfaceSettings settings, int dimension);
    ~FluidInterface();
    FluidInterface(const FluidInterface&) = delete;
    FluidInterface& operator=(const FluidInterface&) = delete;

    /// Sends load `window.step` to the ranks of the solid that own the facets, and asks for the facets in my region.
    ///
    /// \param window     the same on every fluid rank
    /// \param my_region  where I want facets for the coming step
    /// \param loads      for the facets of `used`, in its order; only facets with a load travel
    /// \param used       the batch that the step used (that of the last `receive`)
    /// \param report     totals over the fluid, the same on every fluid rank
    /// Throws base::Error(numerical_failure) when a load is beyond the pressure limit, naming facet, position and rank.
    void send(const Window& window, const RegionBox& my_region, const FacetLoads& loads, const FacetBatch& used,
              const FluidReport& report);

    /// Waits for the solid's answer to the last `send` and returns the facets in my region, with their motion at
    /// `window.time`. The reference stays valid until the next `receive`; `solid` gets the solid's report.
    ///
    /// Throws base::Error: partner_lost (silent beyond the deadline, left early), numerical_failure (not a number),
    /// bad_input (packet does not fit: both sides' view is named).
    const FacetBatch& receive(SolidReport& solid);

    /// True after `receive` when some rank of either side was asked to stop: the same on every fluid rank. The next
    /// window must then say `last` and `stop_requested`.
    [[nodiscard]] bool stop_agreed() const;

    [[nodiscard]] double wait_seconds() const;         ///< waited in `receive` so far, this rank [s]
    [[nodiscard]] std::int64_t bytes_sent() const;     ///< payload sent so far, this rank [byte]
    [[nodiscard]] std::int64_t bytes_received() const; ///< payload received so far, this rank [byte]

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace coupler
