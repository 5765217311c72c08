// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/error_channel.hpp"

#include "coupler_lib/coupling/text_packet.hpp"

#include <vector>

namespace coupler {
namespace {

constexpr int failure_tag = 1;
constexpr int farewell_tag = 2;

bool mpi_is_over()
{
    int finalized = 0;
    MPI_Finalized(&finalized);
    return finalized != 0;
}

} // namespace

ErrorChannel::ErrorChannel(MPI_Comm world) { MPI_Comm_dup(world, &comm_); }

ErrorChannel::~ErrorChannel()
{
    if (!mpi_is_over()) MPI_Comm_free(&comm_);
}

void ErrorChannel::poll()
{
    for (;;) {
        int arrived = 0;
        MPI_Message message{};
        MPI_Status status{};
        MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, comm_, &arrived, &message, &status);
        if (!arrived) return;
        int bytes = 0;
        MPI_Get_count(&status, MPI_BYTE, &bytes);
        std::string text(static_cast<std::size_t>(bytes), '\0');
        MPI_Mrecv(text.data(), bytes, MPI_BYTE, &message, MPI_STATUS_IGNORE);
        if (status.MPI_TAG == farewell_tag) {
            left_.insert(status.MPI_SOURCE);
        } else if (failure_.from < 0 || status.MPI_SOURCE < failure_.from) {
            TextUnpacker unpacker(text);
            failure_.from = status.MPI_SOURCE;
            unpacker.take(failure_.code);
            unpacker.take(failure_.message);
        }
    }
}

void ErrorChannel::tell_failure(int code, const std::string& message, double grace)
{
    TextPacker packer;
    packer.put(code);
    packer.put(message);
    tell_all(failure_tag, packer.text(), grace);
}

void ErrorChannel::tell_farewell(double grace) { tell_all(farewell_tag, "bye", grace); }

void ErrorChannel::tell_all(int tag, const std::string& text, double grace)
{
    int rank = 0;
    int size = 1;
    MPI_Comm_rank(comm_, &rank);
    MPI_Comm_size(comm_, &size);
    std::vector<MPI_Request> requests;
    for (int to = 0; to < size; ++to) {
        if (to == rank) continue;
        requests.emplace_back();
        MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_BYTE, to, tag, comm_, &requests.back());
    }
    const double deadline = MPI_Wtime() + grace;
    int out = 0;
    while (!out && MPI_Wtime() < deadline)
        MPI_Testall(static_cast<int>(requests.size()), requests.data(), &out, MPI_STATUSES_IGNORE);
}

} // namespace coupler
