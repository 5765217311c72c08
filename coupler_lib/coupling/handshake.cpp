// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/handshake.hpp"

#include "coupler_lib/coupling/text_packet.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <ctime>
#include <optional>
#include <unistd.h>

namespace coupler {
namespace {

constexpr int introduction_tag = 7101;
constexpr int verdict_tag = 7102;
constexpr double extra_wait = 3.0; // [s] for the way back

void nap()
{
    const timespec pause{0, 200000};
    nanosleep(&pause, nullptr);
}

/// The next message with this tag, if one comes before `deadline` [MPI_Wtime].
std::optional<std::string> next_message(MPI_Comm world, int tag, double deadline, int& source)
{
    int arrived = 0;
    MPI_Message message{};
    MPI_Status status{};
    for (;;) {
        MPI_Improbe(MPI_ANY_SOURCE, tag, world, &arrived, &message, &status);
        if (arrived) break;
        if (MPI_Wtime() > deadline) return std::nullopt;
        nap();
    }
    int bytes = 0;
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    std::string text(static_cast<std::size_t>(bytes), '\0');
    MPI_Mrecv(text.data(), bytes, MPI_BYTE, &message, MPI_STATUS_IGNORE);
    source = status.MPI_SOURCE;
    return text;
}

void send_text(MPI_Comm world, const std::string& text, int to, int tag)
{
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_BYTE, to, tag, world);
}

std::string pack(const HandshakeResult& result)
{
    TextPacker packer;
    packer.put(result.verdict.code);
    packer.put(result.verdict.message);
    packer.put(result.complete ? 1 : 0);
    std::vector<std::string> all;
    for (const auto& introduction : result.introductions) all.push_back(pack(introduction));
    packer.put(all);
    return packer.text();
}

HandshakeResult unpack_result(const std::string& text)
{
    TextUnpacker unpacker(text);
    HandshakeResult result;
    int complete = 0;
    std::vector<std::string> all;
    unpacker.take(result.verdict.code);
    unpacker.take(result.verdict.message);
    unpacker.take(complete);
    unpacker.take(all);
    result.complete = complete != 0;
    for (const auto& one : all) result.introductions.push_back(unpack_introduction(one));
    return result;
}

std::string list_of_silent(const std::vector<bool>& answered)
{
    std::string list;
    for (std::size_t rank = 0; rank < answered.size(); ++rank)
        if (!answered[rank]) list += (list.empty() ? "" : ", ") + std::to_string(rank);
    return list;
}

/// World rank 0: collects, judges, answers.
HandshakeResult lead(const Introduction& mine, MPI_Comm world, double timeout)
{
    int size = 0;
    MPI_Comm_size(world, &size);
    const auto ranks = static_cast<std::size_t>(size);
    HandshakeResult result;
    result.introductions.resize(ranks);
    result.introductions[0] = mine;
    std::vector<bool> answered(ranks, false);
    answered[0] = true;
    const double deadline = MPI_Wtime() + timeout;
    for (std::size_t count = 1; count < ranks && result.complete; ++count) {
        int source = 0;
        const auto text = next_message(world, introduction_tag, deadline, source);
        result.complete = text.has_value();
        if (!text) break;
        result.introductions[static_cast<std::size_t>(source)] = unpack_introduction(*text);
        answered[static_cast<std::size_t>(source)] = true;
    }
    if (result.complete)
        result.verdict = judge(result.introductions);
    else
        result.verdict = {static_cast<int>(base::ExitCode::partner_lost),
                          base::text("world rank ", list_of_silent(answered),
                                     " called MPI_Init but did not introduce itself within ", timeout,
                                     " s: either it is no program of Rivage, or it hangs while reading its files. ",
                                     "Check the segments of the mpirun command", mine.launch.empty() ? "" : ":\n    ",
                                     launch_line(mine.launch))};
    const std::string answer = pack(result);
    for (std::size_t rank = 1; rank < ranks; ++rank)
        if (answered[rank]) send_text(world, answer, static_cast<int>(rank), verdict_tag);
    return result;
}

HandshakeResult follow(const Introduction& mine, MPI_Comm world, double timeout)
{
    send_text(world, pack(mine), 0, introduction_tag);
    int source = 0;
    const auto answer = next_message(world, verdict_tag, MPI_Wtime() + timeout + extra_wait, source);
    if (answer) return unpack_result(*answer);
    HandshakeResult result;
    result.complete = false;
    result.verdict = {static_cast<int>(base::ExitCode::partner_lost),
                      base::text("world rank 0 called MPI_Init but did not answer the handshake within ",
                                 timeout + extra_wait,
                                 " s: either it is no program of Rivage, or it hangs while reading its files")};
    return result;
}

} // namespace

HandshakeResult shake_hands(Introduction mine, MPI_Comm world, double timeout)
{
    char name[MPI_MAX_PROCESSOR_NAME] = "";
    int length = 0;
    MPI_Get_processor_name(name, &length);
    mine.host = std::string(name, static_cast<std::size_t>(length));
    mine.pid = static_cast<int>(getpid());
    int* appnum = nullptr;
    int found = 0;
    MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_APPNUM, &appnum, &found);
    mine.appnum = found ? *appnum : 0;
    int rank = 0;
    MPI_Comm_rank(world, &rank);
    return rank == 0 ? lead(mine, world, timeout) : follow(mine, world, timeout);
}

} // namespace coupler
