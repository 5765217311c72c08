// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/fluid_interface.hpp"
#include "coupler_lib/session/interface_record.hpp"
#include "coupler_lib/session/session.hpp"
#include "sph_solver/interface/mapping_report.hpp"
#include "sph_solver/time/load_observer.hpp"

#include <optional>

namespace sph {

/// The fluid's end of one interface: its exchange with one solid, its place among the moving walls, and its account.
template<int D> class WetInterface {
public:
    /// \param all  the loads of all interfaces  \param number  of this one among them
    WetInterface(coupler::Session& session, const coupler::InterfaceConfig& config, const Tait& eos,
                 const LoadObserver<D>& all, std::size_t number);

    /// Takes its place behind the interfaces before it. \return the place behind this one
    InterfacePlace take_place(const InterfacePlace& first);
    const coupler::FacetBatch& batch() const { return batch_; }
    const coupler::SolidReport& solid() const { return solid_; }
    const std::string& partner() const { return config_.solid; }
    [[nodiscard]] bool stop_agreed() const { return exchange_.stop_agreed(); }

    /// Sends the load on its facets.
    void send(const coupler::Window& window, const coupler::RegionBox& region, const coupler::FluidEnergies& energies);
    /// Waits for the solid's motion; the walls do not know it yet.
    void receive();
    /// Between two exchanges: the surface goes on with the velocity and acceleration that it had, for one step [s].
    void coast(double dt);

    /// Sums over all ranks: force, moment and work of the load that is sent next. Collective.
    void sum_load(const Walls<D>& walls);
    /// The works of the load that was sent, now that its motion has come. \pre walls at the end of the step. Collective.
    void sum_works(const Walls<D>& walls);

    /// How surface and water meet at the start, also logged. Collective.
    void examine(const Walls<D>& walls);

    void add_to_record(const coupler::Window& window);
    void write_row();
    /// Waits, bytes, mapping, mismatch. Collective.
    base::JsonObject figures() const;
    /// The largest so far [-]; on rank 0.
    double mismatch() const { return record_ ? record_->audit().worst_mismatch() : 0; }
    double wait_seconds() const { return exchange_.wait_seconds(); }

private:
    coupler::Session& session_;
    coupler::InterfaceConfig config_;
    const LoadObserver<D>& loads_;
    std::size_t number_;
    InterfacePlace place_;
    coupler::FluidInterface exchange_;
    coupler::FacetBatch batch_, last_batch_; ///< the last as it was received
    std::vector<double> received_position_;  ///< of the batch, before it coasts [m]
    coupler::FluidReport report_;
    coupler::SolidReport solid_;
    MappingReport mapping_;                          ///< at the start
    std::optional<coupler::InterfaceRecord> record_; ///< on rank 0
};

} // namespace sph
