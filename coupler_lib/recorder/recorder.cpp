// SPDX-License-Identifier: MIT
#include "coupler_lib/recorder/recorder.hpp"

#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/coupling/surface.hpp"
#include "coupler_lib/recorder/traffic_file.hpp"

#include <algorithm>

namespace coupler {
namespace {

/// Passes everything on, and writes it down.
class RecordingCourier final : public Courier {
public:
    RecordingCourier(Participant& participant, const CourierRoute& route, const std::string& path,
                     const TrafficInfo& info)
        : live_(participant, route), file_(path, info)
    {}

    void send(std::size_t peer, std::span<const char> packet) override
    {
        live_.send(peer, packet);
        file_.put(Direction::sent, peer, packet);
    }
    void await_taken(std::size_t peer) override { live_.await_taken(peer); }
    double receive_all(const char* what, std::vector<std::vector<char>>& packets) override
    {
        const double waited = live_.receive_all(what, packets);
        for (std::size_t peer = 0; peer < packets.size(); ++peer) file_.put(Direction::received, peer, packets[peer]);
        return waited;
    }

private:
    MpiCourier live_;
    TrafficWriter file_;
};

/// Bytes of a packet that must be the same in each run of the same case: all but checksum and report, which tells waits.
std::span<const char> compared(std::span<const char> packet, Field field)
{
    const std::size_t report = field == Field::load ? sizeof(FluidReport) : sizeof(SolidReport);
    return packet.subspan(std::min(packet.size(), sizeof(PacketHeader) + report));
}

bool same_packet(const std::vector<char>& then, std::span<const char> now)
{
    const PacketHeader a = PacketReader(then).header();
    const PacketHeader b = PacketReader(std::vector<char>(now.begin(), now.end())).header();
    if (a.step != b.step || a.time != b.time || a.dt != b.dt || a.flags != b.flags) return false;
    return std::ranges::equal(compared(then, a.field), compared(now, b.field));
}

/// Takes from a recording what came, and compares what goes.
class ReplayingCourier final : public Courier {
public:
    ReplayingCourier(Participant& participant, const std::string& path, std::shared_ptr<ReplayVerdict> verdict)
        : file_(path), path_(path), verdict_(std::move(verdict))
    {
        const TrafficInfo& then = file_.info();
        base::require_input(then.ranks == participant.comm().size(), "'", path, "' was recorded by ", then.ranks,
                            " ranks of '", then.role, "': replay it with -n ", then.ranks, ", not ",
                            participant.comm().size());
    }

    void send(std::size_t peer, std::span<const char> packet) override
    {
        if (!file_.next(Direction::sent, peer, then_)) return;
        ++verdict_->packets;
        if (verdict_->differs || same_packet(then_, packet)) return;
        verdict_->differs = true;
        verdict_->step = PacketReader(then_).header().step;
    }
    void await_taken(std::size_t) override {}
    double receive_all(const char* what, std::vector<std::vector<char>>& packets) override
    {
        for (std::size_t peer = 0; peer < packets.size(); ++peer)
            base::require(file_.next(Direction::received, peer, packets[peer]), base::ExitCode::partner_lost,
                          "the recording '", path_, "' ends after ", received_, " packets, at t = ", time_,
                          " s; there is no more of ", what, ". It was cut short with its run: replay to that time ",
                          "only (--set coupling.time.end=...), or record anew");
        ++received_;
        if (!packets.empty()) time_ = PacketReader(packets.front()).header().time;
        return 0;
    }

private:
    TrafficReader file_;
    std::string path_;
    std::shared_ptr<ReplayVerdict> verdict_;
    std::vector<char> then_;
    std::int64_t received_ = 0;
    double time_ = 0;
};

} // namespace

CourierMaker recording_couriers(const std::string& path, const TrafficInfo& info)
{
    return [=](Participant& participant, const CourierRoute& route) -> std::unique_ptr<Courier> {
        TrafficInfo mine = info;
        mine.rank = participant.comm().rank();
        mine.ranks = participant.comm().size();
        mine.partner = participant.introduction(route.peers.front()).role;
        mine.partner_ranks = static_cast<int>(route.peers.size());
        return std::make_unique<RecordingCourier>(participant, route,
                                                  traffic_path(path, mine.role, mine.partner, mine.rank), mine);
    };
}

CourierMaker replaying_couriers(const std::string& path, std::shared_ptr<ReplayVerdict> verdict)
{
    return [=](Participant& participant, const CourierRoute& route) -> std::unique_ptr<Courier> {
        const std::string& partner = participant.introduction(route.peers.front()).role;
        return std::make_unique<ReplayingCourier>(
            participant, traffic_path(path, participant.role(), partner, participant.comm().rank()), verdict);
    };
}

} // namespace coupler
