// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/facet_routing.hpp"
#include "coupler_lib/coupling/packet.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <string>
#include <vector>

namespace coupler {

/// Throws base::Error(bad_input) unless the arrays in use fit the batch and the kind the solid will apply is there.
void check_load_sizes(const FacetLoads& loads, const FacetBatch& used, LoadKind applied);

/// Packs the loads on the facets that one solid rank sent: nodal forces in the order of the nodes it sent, averaged
/// sums in the order of its facets. No ids travel: both sides know what was sent last.
class LoadWriter {
public:
    /// \param only_rank  the fluid has no other rank: forces travel as doubles
    explicit LoadWriter(bool only_rank) : only_rank_(only_rank) {}

    void write(const ReceivedFacets& part, const FacetLoads& loads, int dimension, PacketHeader& header,
               PacketWriter& packet);

private:
    template<int D> void add_corners(const ReceivedFacets& part, const FacetLoads& loads);
    void put_force(const ReceivedFacets& part, const FacetLoads& loads, int dimension, PacketWriter& packet);
    bool only_rank_;
    std::vector<base::ReproducibleSum> sums_; ///< scratch [nodes * dimension]
};

/// Sums the loads of all fluid ranks on the facets of this solid rank; exact, hence independent of their order.
class LoadSum {
public:
    explicit LoadSum(const WetSurface& surface);

    void clear();
    /// Adds what one fluid rank sent. Throws base::Error(bad_input) when the counts are not those of what this rank
    /// was given. \param given  what was sent to it last  \param who  the sender
    void add(PacketReader& packet, const FacetRoute& given, const std::string& who);
    /// Nodal forces [N], [nodes * dimension].
    void write_force(std::vector<double>& force) const;
    /// Facet pressures [Pa], weighted_pressure / weight; zero where weight / full_weight < `coverage_limit`.
    void write_pressure(std::vector<double>& pressure, double coverage_limit) const;

private:
    template<int D> void add_force(PacketReader& packet, const FacetRoute& given);
    void add_pressure(PacketReader& packet, const FacetRoute& given);

    int dimension_;
    std::vector<double> whole_force_;                               ///< [nodes * dimension], of the only fluid rank
    std::vector<base::ReproducibleSum> force_;                      ///< [nodes * dimension]
    std::vector<base::ReproducibleSum> weight_, weighted_pressure_; ///< [facets]
    std::vector<double> full_weight_;                               ///< [facets], largest that was sent
    bool has_sums_ = false, has_pressure_ = false;                  ///< since the last `clear`
};

} // namespace coupler
