// SPDX-License-Identifier: MIT
// How a cube of particles is cut: work, particles and halo copies of the ranks, beside what a cut into boxes
// would need. Prints counts, no times:
//
//     mpirun --oversubscribe -n 32 count_cuts 58        # 58^3 = 195,112 particles
#include "sph_solver/neighbours/neighbour_search.hpp"
#include "sph_solver/parallel/domain.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace sph;

constexpr int D = 3;

/// Every rank takes its share of the lattice, in no order.
Particles<D> share_of(const base::Communicator& comm, int side)
{
    Particles<D> particles = sample::jittered_lattice<D>(side, 1.0, 0.1, 1000.0);
    std::vector<std::uint8_t> mine(particles.size());
    for (std::size_t i = 0; i < mine.size(); ++i) mine[i] = static_cast<int>(i) % comm.size() == comm.rank() ? 1 : 0;
    keep_particles(particles, mine);
    return particles;
}

/// Mean halo of a rank when the cube is cut into boxes, the best way to do so: `reach` [dx] beyond every face that has
/// a neighbour.
double halo_of_boxes(int ranks, double side, double reach)
{
    const auto mean_width = [&](int pieces) { return side / pieces + reach * 2.0 * (pieces - 1) / pieces; };
    double least = std::pow(side, 3);
    for (int a = 1; a <= ranks; ++a)
        for (int b = 1; a * b <= ranks; ++b)
            if (ranks % (a * b) == 0)
                least = std::min(least, mean_width(a) * mean_width(b) * mean_width(ranks / a / b));
    return least - std::pow(side, 3) / ranks;
}

double largest_over_mean(const base::Communicator& comm, std::size_t mine)
{
    const auto value = static_cast<double>(mine);
    return comm.max(value) * comm.size() / comm.sum(value);
}

void run(const base::Communicator& comm, int side)
{
    const double support = 2.0 * 1.23;
    NeighbourSearch<D> search(support, 0.15 * support);
    Domain<D> domain(comm, search.grid(), {.limit = 0.0, .rebuilds_between = 1, .gain = -1.0});
    Particles<D> particles = share_of(comm, side);
    for (int round = 0; round < 2; ++round) { // by particles, then by neighbours
        domain.redistribute(particles);
        search.build(particles);
        std::vector<double> costs;
        for (std::size_t k = 0; k < search.list().rows(); ++k)
            costs.push_back(1e-9 * static_cast<double>(10 + search.list().of(k).size()));
        domain.record_work(particles, costs, 1.0);
    }
    const std::size_t owned = particles.owned.size(), halo = particles.size() - owned;
    const double mean_owned = std::pow(side, 3) / comm.size();
    const double boxes = halo_of_boxes(comm.size(), side, search.reach());
    const double work = largest_over_mean(comm, search.list().entries() + 10 * owned);
    const double most_owned = largest_over_mean(comm, owned);
    const double mean_halo = comm.sum(static_cast<double>(halo)) / comm.size();
    const double most_halo = comm.max(static_cast<double>(halo));
    if (!comm.is_root()) return;
    std::printf("ranks %d, blocks %zu, particles a rank %.0f: work largest/mean %.3f, particles largest/mean %.3f, "
                "halo mean %.0f (%.2f of the best boxes' %.0f), largest %.0f\n",
                comm.size(), domain.blocks().size(), mean_owned, work, most_owned, mean_halo, mean_halo / boxes, boxes,
                most_halo);
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    run(base::Communicator::world(), argc > 1 ? std::atoi(argv[1]) : 58);
    MPI_Finalize();
    return 0;
}
