// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/scatter.hpp"

namespace base {
namespace {

constexpr int scatter_tag = 71;

int message_bytes(const std::vector<int>& offsets, std::size_t k, std::size_t bytes_each)
{
    return static_cast<int>(static_cast<std::size_t>(offsets[k + 1] - offsets[k]) * bytes_each);
}

}  // namespace

void Scatter::post_receives(std::size_t bytes_each) const
{
    const std::size_t count = plan_.neighbours.size();
    send_buffer_.resize(plan_.send_indices.size() * bytes_each);
    receive_buffer_.resize(plan_.receive_indices.size() * bytes_each);
    send_requests_.assign(count, MPI_REQUEST_NULL);
    receive_requests_.assign(count, MPI_REQUEST_NULL);
    for (std::size_t k = 0; k < count; ++k) {
        MPI_Irecv(receive_buffer_.data() + static_cast<std::size_t>(plan_.receive_offsets[k]) * bytes_each,
                  message_bytes(plan_.receive_offsets, k, bytes_each), MPI_BYTE, plan_.neighbours[k], scatter_tag, comm_,
                  &receive_requests_[k]);
    }
}

char* Scatter::send_begin(std::size_t k, std::size_t bytes_each) const
{
    return send_buffer_.data() + static_cast<std::size_t>(plan_.send_offsets[k]) * bytes_each;
}

const char* Scatter::receive_begin(std::size_t k, std::size_t bytes_each) const
{
    return receive_buffer_.data() + static_cast<std::size_t>(plan_.receive_offsets[k]) * bytes_each;
}

void Scatter::send(std::size_t k, std::size_t bytes_each) const
{
    MPI_Isend(send_begin(k, bytes_each), message_bytes(plan_.send_offsets, k, bytes_each), MPI_BYTE, plan_.neighbours[k],
              scatter_tag, comm_, &send_requests_[k]);
}

void Scatter::finish_receives() const
{
    MPI_Waitall(static_cast<int>(receive_requests_.size()), receive_requests_.data(), MPI_STATUSES_IGNORE);
}

void Scatter::finish_sends() const
{
    MPI_Waitall(static_cast<int>(send_requests_.size()), send_requests_.data(), MPI_STATUSES_IGNORE);
}

}  // namespace base
