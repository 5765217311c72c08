// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/packet.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <string>
#include <vector>

namespace coupler {

/// Throws base::Error(bad_input) unless the arrays in use fit the batch and the kind the solid will apply is there.
void check_load_sizes(const FacetLoads& loads, const FacetBatch& used, LoadKind applied);

/// Writes the loads on those facets that `owner` owns and that carry any load, and the counts into the header.
void write_loads(const FacetBatch& used, const FacetLoads& loads, int owner, PacketHeader& header,
                 PacketWriter& packet);

/// Sums the loads of all fluid ranks on the facets of this solid rank; exact, hence independent of their order.
class LoadSum {
public:
    LoadSum(const WetSurface& surface, const std::vector<int>& order);

    void clear();
    /// Adds what one fluid rank sent. Throws base::Error(bad_input) on a facet that is not mine. \param who the sender
    void add(PacketReader& packet, const std::string& who);
    /// Nodal forces [N], [nodes * dimension].
    void write_force(std::vector<double>& force) const;
    /// Facet pressures [Pa], weighted_pressure / weight; zero where weight / full_weight < `coverage_limit`.
    void write_pressure(std::vector<double>& pressure, double coverage_limit) const;
    /// Checksum over every bit of the sums.
    std::uint64_t fingerprint() const;
    bool has_force() const { return has_force_; }
    bool has_pressure() const { return has_pressure_; }

private:
    std::size_t find(std::int64_t id, std::size_t& hint, const std::string& who) const;

    int dimension_;
    std::size_t corners_; ///< that travel for a facet: 2 or 4
    std::vector<std::int64_t> sorted_ids_;
    std::vector<int> order_; ///< facet indices by ascending id
    const std::vector<std::array<int, 4>>& facet_nodes_;
    std::vector<base::ReproducibleSum> force_;                      ///< [nodes * dimension]
    std::vector<base::ReproducibleSum> weight_, weighted_pressure_; ///< [facets]
    std::vector<double> full_weight_;                               ///< [facets], largest that was sent
    bool has_force_ = false, has_pressure_ = false;
    std::vector<std::int64_t> ids_; ///< scratch
    std::vector<base::ReproducibleSum> sums_, more_sums_;
    std::vector<double> numbers_;
};

} // namespace coupler
