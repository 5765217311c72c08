// SPDX-License-Identifier: MIT
#include "sph_solver/walls/trapped.hpp"

#include "sph_solver/walls/contact_finder.hpp"

namespace sph {
namespace {

template<int D> bool is_trapped(const WallContacts<D>& contacts, const WallContact& contact, double gap)
{
    for (int p = contact.plane_begin; p < contact.plane_end; ++p)
        for (int q = p + 1; q < contact.plane_end; ++q) {
            const MirrorPlane<D>&a = contacts.planes[static_cast<std::size_t>(p)],
                  &b = contacts.planes[static_cast<std::size_t>(q)];
            if (a.normal.dot(b.normal) < cos_opposite && a.distance + b.distance < gap) return true;
        }
    return false;
}

} // namespace

template<int D> std::vector<std::uint8_t> find_trapped(const WallContacts<D>& contacts, double gap, std::size_t owned)
{
    if (gap <= 0) return {};
    std::vector<std::uint8_t> trapped(owned, 0);
    for (const WallContact& contact : contacts.contacts) trapped[contact.row] = is_trapped(contacts, contact, gap);
    return trapped;
}

template std::vector<std::uint8_t> find_trapped(const WallContacts<2>&, double, std::size_t);
template std::vector<std::uint8_t> find_trapped(const WallContacts<3>&, double, std::size_t);

} // namespace sph
