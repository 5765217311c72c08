// SPDX-License-Identifier: MIT
#include "coupler_lib/session/session.hpp"

#include "coupler_lib/base/version.hpp"
#include "coupler_lib/session/data_flow_check.hpp"
#include "coupler_lib/session/wait_balance.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <sstream>
#include <sys/resource.h>

namespace coupler {
namespace {

namespace fs = std::filesystem;

constexpr int summary_tag = 7301, used_config_tag = 7302, wait_tag = 7303, flow_tag = 7304;

/// Largest resident memory of this rank so far [MB].
double peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void write_text(const std::string& path, const std::string& content)
{
    std::ofstream file(path);
    file << content;
    base::require_input(file.good(), "cannot write the file '", path, "'; is the disk full?");
}

/// The tables of a TOML text below one name: [time] becomes [fluid.time], [[walls]] becomes [[fluid.walls]].
std::string below(const std::string& name, const std::string& tables)
{
    std::istringstream lines(tables);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t bracket = line.find_first_not_of('[');
        if (bracket == 1 || bracket == 2) line.insert(bracket, name + ".");
        result += line + "\n";
    }
    return result;
}

/// The root that gathers what all participants tell: the first rank of a program that has a Session. A solver from
/// outside, which links the coupling alone, has none and is left out.
int collector_of(const Participant& me)
{
    int rank = 0;
    while (me.introduction(rank).program.empty()) ++rank;
    return rank;
}

std::string receive_text(Participant& me, int from, int tag)
{
    MPI_Status status;
    const auto arrived = [&] {
        int flag = 0;
        MPI_Iprobe(from, tag, me.coupling_comm(), &flag, &status);
        return flag != 0;
    };
    me.wait_until(arrived, "its summary", [&] { return std::vector<int>{from}; });
    int length = 0;
    MPI_Get_count(&status, MPI_CHAR, &length);
    std::string text(static_cast<std::size_t>(length), ' ');
    MPI_Recv(text.data(), length, MPI_CHAR, from, tag, me.coupling_comm(), MPI_STATUS_IGNORE);
    return text;
}

/// The texts of all participants' roots, gathered on the collector (empty elsewhere), its own first.
std::vector<std::pair<std::string, std::string>> gather_texts(Participant& me, const std::string& mine, int tag)
{
    std::vector<std::pair<std::string, std::string>> texts;
    const int collector = collector_of(me);
    if (!me.comm().is_root()) return texts;
    if (me.world_rank() != collector) {
        std::vector<MPI_Request> request(1);
        MPI_Isend(mine.data(), static_cast<int>(mine.size()), MPI_CHAR, collector, tag, me.coupling_comm(),
                  request.data());
        me.wait_all(request, "its summary to be taken", {collector});
        return texts;
    }
    texts.emplace_back(me.role(), mine);
    for (const auto& partner : me.partners()) {
        const int root = me.ranks_of(partner).front();
        if (!me.introduction(root).program.empty()) texts.emplace_back(partner, receive_text(me, root, tag));
    }
    return texts;
}

} // namespace

Session::Session(Participant& participant, const RunFiles& files, bool check_only)
    : participant_(&participant), files_(files), check_only_(check_only), own_folder_(files.role)
{
    if (check_only_) {
        if (is_root() && !files_.describe) log_ = base::Log(files_.role, "");
        return;
    }
    if (is_root()) {
        std::error_code error;
        fs::create_directories(own_dir(), error);
        if (coupled()) fs::create_directories(files_.output_dir + "/coupling", error);
        base::require_input(!error, "cannot make the output folder '", own_dir(), "': ", error.message());
        log_ = base::Log(files_.role, own_dir() + "/" + files_.role + ".log");
    }
    comm().barrier();
    write_used_config();
}

void Session::write_used_config()
{
    if (!is_root()) return;
    const auto parts = gather_texts(*participant_, files_.used_own, used_config_tag);
    if (parts.empty()) return;
    std::string all = "# Every key of the run, defaults included; the names are those of --set.\n\n";
    if (files_.coupling) all += below("coupling", files_.used_coupling);
    for (const auto& [role, used] : parts) all += below(role, used);
    write_text(files_.output_dir + "/used_config.toml", all);
}

void Session::write_summary(base::JsonObject figures)
{
    const double memory = comm().max(peak_memory());
    const double waited = comm().sum(participant_->wait_seconds()) / comm().size();
    const WaitShare wait{role(), comm().size(), waited / std::max(wall_seconds(), 1e-9)};
    figures.set("ranks", comm().size())
        .set("wall_s", wall_seconds())
        .set("peak_memory_per_rank_MB", memory)
        .set("version", base::version())
        .set("commit", base::git_hash())
        .set("wait_share", wait.share)
        .set("timers", timers_.json());
    report_replay(figures);
    if (!is_root()) return;
    write_text(own_dir() + "/summary.json", figures.text() + "\n");
    const auto texts = gather_texts(*participant_, figures.text(1), summary_tag);
    const std::string advice = coupled() ? wait_balance(wait) : "";
    if (texts.empty()) return;
    std::string all = "{";
    for (const auto& [name, text] : texts) all += (all == "{" ? "\n  \"" : ",\n  \"") + name + "\": " + text;
    if (!advice.empty()) all += ",\n  \"wait_balance\": \"" + advice + "\"";
    write_text(files_.output_dir + "/summary.json", all + "\n}\n");
}

/// Whether what this side sent was what it had sent when recorded. Collective.
void Session::report_replay(base::JsonObject& figures) const
{
    if (!files_.replay) return;
    const ReplayVerdict& mine = *files_.replay;
    const auto never = std::numeric_limits<std::int64_t>::max();
    const std::int64_t first = -comm().max(mine.differs ? -mine.step : -never);
    const std::int64_t packets = comm().sum(mine.packets);
    figures.set("replayed_packets", packets).set("replay_differs", first != never);
    if (first != never) figures.set("replay_first_difference_step", first);
    if (first == never)
        log_.info(fmt::format("replay: all {} packets sent are those of the recording, to the bit", packets));
    else
        log_.warn(fmt::format("replay: what is sent differs from the recording from step {} on", first));
}

/// On world rank 0: who waited how long, with advice, logged and returned. Elsewhere: sends its own share.
std::string Session::wait_balance(const WaitShare& mine)
{
    std::vector<WaitShare> waits;
    for (const auto& [name, text] : gather_texts(*participant_, to_text(mine), wait_tag))
        waits.push_back(wait_share_from(name, text));
    const std::string advice = wait_advice(waits);
    if (!advice.empty()) log_.info("waits: " + advice);
    return advice;
}

void Session::check_flow(DataFlow mine)
{
    mine.role = role();
    if (files_.describe) {
        if (is_root()) std::fputs(to_text(mine).c_str(), stdout);
        return;
    }
    std::vector<DataFlow> sides;
    for (const auto& [name, text] : gather_texts(*participant_, to_text(mine), flow_tag))
        sides.push_back(data_flow_from(text));
    for (const auto& partner : files_.partners) {
        if (partner.flow)
            sides.push_back(*partner.flow);
        else
            log_.warn(partner.role + " is left out of the check: " + partner.note);
    }
    if (participant_->world_rank() != collector_of(*participant_)) return;
    const FlowReport report = check_data_flow(coupling(), sides);
    for (const auto& fact : report.facts) log_.info(fact);
    for (const auto& advice : report.advice) log_.warn(advice);
    std::string problems;
    for (const auto& problem : report.problems) problems += "\n  " + problem;
    base::require_input(problems.empty(), "the participants do not fit together:", problems);
    log_.info(sides.size() == coupling().participants.size() ? "the data flow is complete" : "this side is in order");
}

} // namespace coupler
