// SPDX-License-Identifier: MIT
#include "sph_solver/time/work_costs.hpp"

namespace sph {
namespace {

double images(const WallContact& contact, const ReachedNeighbours& neighbours)
{
    const auto sources = static_cast<double>(neighbours.count(contact.row) + 1); // the neighbours and itself
    return (contact.plane_end - contact.plane_begin) * sources;
}

} // namespace

template<int D> WorkMeter::Counts count_work(const ReachedNeighbours& neighbours, const WallContacts<D>& contacts)
{
    WorkMeter::Counts counts{static_cast<double>(neighbours.rows()), 0.0, 0.0};
    for (std::size_t k = 0; k < neighbours.rows(); ++k) counts[1] += static_cast<double>(neighbours.count(k));
    for (const WallContact& contact : contacts.contacts) counts[2] += images(contact, neighbours);
    return counts;
}

template<int D>
std::vector<double> work_costs(const WorkMeter& meter, const ReachedNeighbours& neighbours,
                               const WallContacts<D>& contacts)
{
    std::vector<double> costs(neighbours.rows(), meter.cost(Work::particle));
    for (std::size_t k = 0; k < costs.size(); ++k)
        costs[k] += meter.cost(Work::pair) * static_cast<double>(neighbours.count(k));
    for (const WallContact& contact : contacts.contacts)
        costs[contact.row] += meter.cost(Work::image) * images(contact, neighbours);
    return costs;
}

template WorkMeter::Counts count_work<2>(const ReachedNeighbours&, const WallContacts<2>&);
template WorkMeter::Counts count_work<3>(const ReachedNeighbours&, const WallContacts<3>&);
template std::vector<double> work_costs<2>(const WorkMeter&, const ReachedNeighbours&, const WallContacts<2>&);
template std::vector<double> work_costs<3>(const WorkMeter&, const ReachedNeighbours&, const WallContacts<3>&);

} // namespace sph
