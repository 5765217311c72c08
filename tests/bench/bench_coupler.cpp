// SPDX-License-Identifier: MIT
// Median time of one exchange through the coupling library beside the same bytes sent raw, in the same run.
//
//     mpirun -n 2 bench_coupler          1 fluid rank + 1 solid rank
//     mpirun -n 4 bench_coupler 1000     2 + 2, only with 1,000 points
//
//     fluid:  load ->            -> motion     every wet point is loaded; each fluid rank sees its part of the surface
//     solid:       -> sum, answer ->
//
// The raw swap is the least that any exchange can do: each pair of ranks that shares facets sends each other as many
// bytes, both ways at once, into buffers posted before. Both times are taken on fluid rank 0.
#include "coupler_lib/coupling/fluid_interface.hpp"
#include "coupler_lib/coupling/mpi_session.hpp"
#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/coupling/solid_interface.hpp"
#include "tests/bench/bench_surface.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace coupler;

struct Size {
    int dimension;
    int points;
    int exchanges;
};

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

ParticipantSettings settings()
{
    int rank = 0, size = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    ParticipantSettings settings;
    settings.role = rank < size / 2 ? "fluid" : "solid";
    settings.expected_roles = {"fluid", "solid"};
    return settings;
}

/// Seconds of each exchange, and the bytes that one took on this rank.
struct Times {
    std::vector<double> seconds;
    std::int64_t sent = 0, received = 0;
};

Times exchange_as_fluid(Participant& me, const Size& size)
{
    InterfaceSettings limits;
    limits.pressure_limit = 1e9; // guards on, as in every run
    FluidInterface wet(me, limits, size.dimension);
    const RegionBox region = bench::slice(me.comm().rank(), me.comm().size());
    const FacetBatch nothing;
    FluidReport report;
    SolidReport solid;
    wet.send({-1, 0, 0}, region, {}, nothing, report);
    const FacetBatch* batch = &wet.receive(solid);
    const FacetLoads loads = bench::loads_on(*batch);
    Times times;
    std::int64_t sent = 0, received = 0;
    for (int step = 0; step <= size.exchanges; ++step) {
        if (step == size.exchanges) sent = wet.bytes_sent(), received = wet.bytes_received();
        const double start = MPI_Wtime();
        wet.send({step, step * 1e-3, 1e-3, step == size.exchanges}, region, loads, *batch, report);
        batch = &wet.receive(solid);
        times.seconds.push_back(MPI_Wtime() - start);
    }
    times.sent = wet.bytes_sent() - sent;
    times.received = wet.bytes_received() - received;
    return times;
}

void exchange_as_solid(Participant& me, const Size& size)
{
    const WetSurface surface = bench::strip(size.dimension, size.points, me.comm().rank(), me.comm().size());
    SolidInterface wet(me, {}, surface);
    SurfaceMotion motion{surface.reference, surface.reference, surface.reference};
    SurfaceLoad load;
    FluidReport report;
    for (bool last = false; !last;) {
        last = wet.receive(load, report).last;
        wet.send(motion, {});
    }
}

/// The bytes of one exchange to each partner, both ways at once. \param out, in  bytes of this rank to all partners
std::vector<double> swap_raw(Participant& me, const Size& size, std::int64_t out, std::int64_t in)
{
    const auto partners = me.partner_ranks();
    const auto each = [&partners](std::int64_t bytes) { return static_cast<std::size_t>(bytes) / partners.size(); };
    std::vector<std::vector<char>> outgoing(partners.size()), incoming(partners.size());
    std::vector<MPI_Request> requests(2 * partners.size());
    std::vector<double> seconds;
    for (std::size_t k = 0; k < partners.size(); ++k) {
        outgoing[k].resize(each(out));
        incoming[k].resize(each(in));
    }
    for (int step = 0; step < size.exchanges; ++step) {
        MPI_Barrier(me.coupling_comm());
        const double start = MPI_Wtime();
        for (std::size_t k = 0; k < partners.size(); ++k) {
            MPI_Irecv(incoming[k].data(), static_cast<int>(incoming[k].size()), MPI_BYTE, partners[k], 1,
                      me.coupling_comm(), &requests[2 * k]);
            MPI_Isend(outgoing[k].data(), static_cast<int>(outgoing[k].size()), MPI_BYTE, partners[k], 1,
                      me.coupling_comm(), &requests[2 * k + 1]);
        }
        MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
        seconds.push_back(MPI_Wtime() - start);
    }
    return seconds;
}

void print(const Participant& me, const Size& size, const std::string& what, double value)
{
    const std::string name = base::text("coupler_", size.dimension, "d_", size.points, "_points");
    const std::string ranks = base::text(me.comm().size(), "+", me.ranks_of("solid").size());
    std::printf("{\"bench\": \"%s\", \"metric\": \"%s\", \"value\": %.4g, \"ranks\": \"%s\"}\n", name.c_str(),
                what.c_str(), value, ranks.c_str());
    std::fflush(stdout);
}

void measure(Participant& me, const Size& size)
{
    Times times;
    const bool fluid = me.role() == "fluid";
    fluid ? void(times = exchange_as_fluid(me, size)) : exchange_as_solid(me, size);
    std::int64_t bytes[2] = {times.sent, times.received};
    MPI_Bcast(bytes, 2, MPI_INT64_T, 0, me.coupling_comm());
    const auto raw = fluid ? swap_raw(me, size, bytes[0], bytes[1]) : swap_raw(me, size, bytes[1], bytes[0]);
    if (me.world_rank() != 0) return;
    print(me, size, "exchange_us", 1e6 * median(times.seconds));
    print(me, size, "raw_swap_us", 1e6 * median(raw));
    print(me, size, "bytes_sent", static_cast<double>(times.sent));
    print(me, size, "bytes_received", static_cast<double>(times.received));
}

} // namespace

int main(int argc, char** argv)
{
    const MpiSession mpi(argc, argv, "bench", 30);
    Participant me(settings());
    const int only = argc > 1 ? std::atoi(argv[1]) : 0; // points; 0: all sizes
    for (const Size& size :
         {Size{2, 100, 4000}, {2, 1000, 2000}, {2, 10000, 400}, {3, 100, 4000}, {3, 1000, 2000}, {3, 10000, 400}})
        if (only == 0 || only == size.points) measure(me, size);
    me.finish();
    return 0;
}
