// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/exchange.hpp"

namespace base {
namespace {

constexpr int exchange_tag = 73;

std::vector<std::int64_t> incoming_sizes(const Communicator& comm, const std::vector<std::vector<char>>& buffers)
{
    std::vector<std::int64_t> outgoing(buffers.size());
    for (std::size_t r = 0; r < buffers.size(); ++r) outgoing[r] = static_cast<std::int64_t>(buffers[r].size());
    std::vector<std::int64_t> incoming(buffers.size());
    MPI_Alltoall(outgoing.data(), 1, MPI_INT64_T, incoming.data(), 1, MPI_INT64_T, comm.handle());
    return incoming;
}

} // namespace

std::vector<std::vector<char>> exchange_bytes(const Communicator& comm, const std::vector<std::vector<char>>& buffers)
{
    ensure(buffers.size() == static_cast<std::size_t>(comm.size()), "exchange_bytes: one buffer for each rank");
    if (comm.size() == 1) return buffers;
    const std::vector<std::int64_t> sizes = incoming_sizes(comm, buffers);
    std::vector<std::vector<char>> received(buffers.size());
    std::vector<MPI_Request> requests;
    for (std::size_t r = 0; r < sizes.size(); ++r) {
        received[r].resize(static_cast<std::size_t>(sizes[r]));
        if (sizes[r] == 0) continue;
        MPI_Irecv(received[r].data(), static_cast<int>(sizes[r]), MPI_BYTE, static_cast<int>(r), exchange_tag,
                  comm.handle(), &requests.emplace_back());
    }
    for (std::size_t r = 0; r < buffers.size(); ++r) {
        if (buffers[r].empty()) continue;
        MPI_Isend(buffers[r].data(), static_cast<int>(buffers[r].size()), MPI_BYTE, static_cast<int>(r), exchange_tag,
                  comm.handle(), &requests.emplace_back());
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    return received;
}

} // namespace base
