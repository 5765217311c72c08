// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/foundation/communicator.hpp"

#include <cstddef>
#include <cstring>
#include <vector>

namespace base {

/// Which local items go to which rank, and where what comes from there lies: owners to halo copies.
/// `send_indices[send_offsets[k] .. send_offsets[k+1])` go to rank `neighbours[k]`; what it sends is stored at
/// `receive_indices[receive_offsets[k] .. receive_offsets[k+1])`, in the order of its own send list.
struct ScatterPlan {
    std::vector<int> neighbours;
    std::vector<int> send_offsets{0};
    std::vector<int> send_indices;
    std::vector<int> receive_offsets{0};
    std::vector<int> receive_indices;
};

/// Refreshes the halo copies of fields from their owners. Holds no field: one scatter serves all.
class Scatter {
public:
    Scatter() = default;
    Scatter(const Communicator& comm, ScatterPlan plan) : comm_(comm.handle()), plan_(std::move(plan)) {}

    const ScatterPlan& plan() const { return plan_; }

    /// Copies the owners' values of all given fields (std::vector of trivially copyable items, indexed by local
    /// number) to the halo, packed in one message for each neighbour. Collective over the neighbours.
    template <class... Fields>
    void forward(Fields&... fields) const
    {
        start(fields...);
        finish(fields...);
    }

    /// The same in two calls with work between them: the owners' values leave as they are now. One refresh at a time; the
    /// same fields must be given to both calls.
    template <class... Fields>
    void start(const Fields&... fields) const
    {
        if (plan_.neighbours.empty()) return;
        const std::size_t bytes_each = (sizeof(typename Fields::value_type) + ...);
        post_receives(bytes_each);
        for (std::size_t k = 0; k < plan_.neighbours.size(); ++k) {
            char* out = send_begin(k, bytes_each);
            (pack(fields, k, out), ...);
            send(k, bytes_each);
        }
    }

    /// Waits for the values and puts them in place.
    template <class... Fields>
    void finish(Fields&... fields) const
    {
        if (plan_.neighbours.empty()) return;
        const std::size_t bytes_each = (sizeof(typename Fields::value_type) + ...);
        finish_receives();
        for (std::size_t k = 0; k < plan_.neighbours.size(); ++k) {
            const char* in = receive_begin(k, bytes_each);
            (unpack(fields, k, in), ...);
        }
        finish_sends();
    }

private:
    template <class Field>
    void pack(const Field& field, std::size_t k, char*& out) const
    {
        for (int s = plan_.send_offsets[k]; s < plan_.send_offsets[k + 1]; ++s) {
            const auto& item = field[static_cast<std::size_t>(plan_.send_indices[static_cast<std::size_t>(s)])];
            std::memcpy(out, static_cast<const void*>(&item), sizeof(item));
            out += sizeof(item);
        }
    }

    template <class Field>
    void unpack(Field& field, std::size_t k, const char*& in) const
    {
        for (int r = plan_.receive_offsets[k]; r < plan_.receive_offsets[k + 1]; ++r) {
            auto& item = field[static_cast<std::size_t>(plan_.receive_indices[static_cast<std::size_t>(r)])];
            std::memcpy(static_cast<void*>(&item), in, sizeof(item));
            in += sizeof(item);
        }
    }

    void post_receives(std::size_t bytes_each) const;
    char* send_begin(std::size_t k, std::size_t bytes_each) const;
    const char* receive_begin(std::size_t k, std::size_t bytes_each) const;
    void send(std::size_t k, std::size_t bytes_each) const;
    void finish_receives() const;
    void finish_sends() const;

    MPI_Comm comm_ = MPI_COMM_NULL;
    ScatterPlan plan_;
    mutable std::vector<char> send_buffer_, receive_buffer_;
    mutable std::vector<MPI_Request> send_requests_, receive_requests_;
};

}  // namespace base
