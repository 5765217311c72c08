// SPDX-License-Identifier: MIT
#include "sph_solver/operators/wall_images.hpp"

namespace sph {
namespace {

constexpr std::size_t planes_each = max_planes; // digits of a path's code
constexpr std::array<std::size_t, 4> first_code = {0, 0, planes_each, planes_each + planes_each* planes_each};

template<int D> std::size_t code_of(const Image<D>& image, const MirrorPlane<D>* first)
{
    std::size_t code = 0;
    for (int k = 0; k < image.order; ++k)
        code = code * planes_each + static_cast<std::size_t>(image.path[static_cast<std::size_t>(k)] - first);
    return first_code[static_cast<std::size_t>(image.order)] + code;
}

ImageGroup group_of(std::size_t code, int first_plane)
{
    ImageGroup group;
    group.order = code < first_code[2] ? 1 : code < first_code[3] ? 2 : 3;
    code -= first_code[static_cast<std::size_t>(group.order)];
    for (int k = group.order; k-- > 0; code /= planes_each)
        group.path[static_cast<std::size_t>(k)] = first_plane + static_cast<int>(code % planes_each);
    return group;
}

} // namespace

template<int D>
void WallImages<D>::find(const Walls<D>& walls, const PairRecords<D>& records, const Particles<D>& particles,
                         const ReachedNeighbours& neighbours)
{
    const auto& [contacts, planes, footprints] = walls.contacts();
    groups_.clear();
    sources_.clear();
    weights_.clear();
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const WallContact& contact = contacts[c];
        const bool alone = contact.plane_end == contact.plane_begin + 1 &&
                           planes[static_cast<std::size_t>(contact.plane_begin)].cuts.empty();
        if (alone)
            add_behind_plane(c, walls, records, neighbours.of(contact.row));
        else
            add_in_buckets(c, walls, particles, neighbours.of(contact.row));
    }
}

/// The plain case, one plane and nothing cut off: x' = x_j - 2 s n of all in front of the plane, as far as seen.
template<int D>
void WallImages<D>::add_behind_plane(std::size_t contact, const Walls<D>& walls, const PairRecords<D>& records,
                                     std::span<const int> neighbours)
{
    const WallContact& of = walls.contacts().contacts[contact];
    const MirrorPlane<D>& plane = walls.contacts().planes[static_cast<std::size_t>(of.plane_begin)];
    const double support = walls.settings().support;
    const double* x_i = records.state(of.particle);
    ImageGroup group;
    group.contact = contact;
    group.path[0] = of.plane_begin;
    group.order = 1;
    group.own_first = 2 * plane.distance < support;
    group.begin = sources_.size();
    sources_.resize(group.begin + neighbours.size() + 1);
    int* out = sources_.data() + group.begin;
    *out = of.particle;
    out += group.own_first ? 1 : 0;
    for (const int j : neighbours) {
        const double* x_j = records.state(j);
        double s = 0, square = 0;
        for (int a = 0; a < D; ++a) s += (x_j[a] - plane.point[a]) * plane.normal[a];
        for (int a = 0; a < D; ++a) {
            const double x = x_j[a] - 2 * s * plane.normal[a] - x_i[a];
            square += x * x;
        }
        *out = j; // written always, kept where the place moves on: no branch to mispredict
        out += (s > 0) & (square < support * support) ? 1 : 0;
    }
    sources_.resize(static_cast<std::size_t>(out - sources_.data()));
    hold_ones(sources_.size() - group.begin);
    close_group(group, of.particle);
}

/// Several planes, or cuts: the images as ImageFinder gives them, sorted by their path.
template<int D>
void WallImages<D>::add_in_buckets(std::size_t contact, const Walls<D>& walls, const Particles<D>& particles,
                                   std::span<const int> neighbours)
{
    const auto& planes = walls.contacts().planes;
    const WallContact& of = walls.contacts().contacts[contact];
    const MirrorPlane<D>* first = &planes[static_cast<std::size_t>(of.plane_begin)];
    for (Bucket& bucket : buckets_) {
        bucket.sources.clear();
        bucket.weights.clear();
    }
    ImageFinder<D>(walls.settings()).for_each(of, planes, particles.position, neighbours, [&](const Image<D>& image) {
        Bucket& bucket = buckets_[code_of(image, first)];
        bucket.sources.push_back(image.source);
        bucket.weights.push_back(image.weight);
    });
    for (std::size_t code = 0; code < buckets_.size(); ++code) flush_bucket(code, of, contact);
}

template<int D> void WallImages<D>::flush_bucket(std::size_t code, const WallContact& contact, std::size_t number)
{
    const Bucket& bucket = buckets_[code];
    if (bucket.sources.empty()) return;
    ImageGroup group = group_of(code, contact.plane_begin);
    group.contact = number;
    group.own_first = bucket.sources[0] == contact.particle;
    group.begin = sources_.size();
    group.weights = weights_.size();
    sources_.insert(sources_.end(), bucket.sources.begin(), bucket.sources.end());
    weights_.insert(weights_.end(), bucket.weights.begin(), bucket.weights.end());
    close_group(group, contact.particle);
}

template<int D> void WallImages<D>::close_group(ImageGroup group, int particle)
{
    group.end = group.begin + whole_units(sources_.size() - group.begin);
    group.fillers = static_cast<std::uint8_t>(group.end - sources_.size());
    sources_.resize(group.end, particle);
    if (group.weights != ImageGroup::all_one) weights_.resize(group.weights + (group.end - group.begin), 0.0);
    if (group.end > group.begin) groups_.push_back(group);
}

template<int D> void WallImages<D>::hold_ones(std::size_t count)
{
    if (ones_.size() >= count + row_unit) return;
    ones_.assign(count, 1.0);
    ones_.resize(count + row_unit, 0.0);
}

template class WallImages<2>;
template class WallImages<3>;

} // namespace sph
