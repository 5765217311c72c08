// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/packet.hpp"

#include "coupler_lib/coupling/checksum.hpp"
#include "coupler_lib/foundation/check.hpp"

namespace coupler {
namespace {

constexpr std::uint32_t packet_magic = 0x31565652; // "RVV1"

/// The checksum with the header's own `check` taken as zero; leaves the buffer as it was.
std::uint64_t check_of(std::span<char> packet)
{
    const std::uint64_t nothing = 0;
    std::uint64_t kept = 0;
    char* place = packet.data() + offsetof(PacketHeader, check);
    std::memcpy(&kept, place, sizeof(kept));
    std::memcpy(place, &nothing, sizeof(nothing));
    const std::uint64_t sum = checksum(packet.data(), packet.size());
    std::memcpy(place, &kept, sizeof(kept));
    return sum;
}

} // namespace

std::string describe(const PacketHeader& header)
{
    const std::string what = header.step < 0 ? "greeting" : "step " + std::to_string(header.step);
    return base::text(header.field == Field::load ? "load" : "motion", " of ", what, " (packet ", header.sequence,
                      ", t = ", header.time, " s, dt = ", header.dt, " s, ", header.dimension, "D)");
}

void PacketWriter::finish(PacketHeader header)
{
    header.magic = packet_magic;
    header.bytes = static_cast<std::int64_t>(used_ - sizeof(PacketHeader));
    header.check = 0;
    std::memcpy(buffer_.data(), &header, sizeof(header));
    header.check = check_of({buffer_.data(), used_});
    std::memcpy(buffer_.data(), &header, sizeof(header));
}

PacketReader::PacketReader(const std::vector<char>& buffer) : buffer_(buffer)
{
    base::require_input(buffer.size() >= sizeof(header_), "a packet of ", buffer.size(),
                        " bytes is shorter than a header");
    std::memcpy(&header_, buffer.data(), sizeof(header_));
    base::require_input(header_.magic == packet_magic,
                        "a packet does not begin with Rivage's mark: is the other program of ", "another version?");
    const auto body = static_cast<std::int64_t>(buffer.size() - sizeof(header_));
    if (header_.bytes != body) refuse(base::text("announces ", header_.bytes, " bytes and brings ", body));
    if (check_of(const_cast<std::vector<char>&>(buffer)) != header_.check)
        refuse("is damaged: its checksum does not fit its content");
}

void PacketReader::refuse(const std::string& why) const
{
    throw base::Error(base::ExitCode::bad_input, "the " + describe(header_) + " " + why);
}

void PacketReader::need(std::size_t count, std::size_t bytes_each) const
{
    const std::size_t left = buffer_.size() - at_;
    if (count > left / bytes_each)
        refuse(base::text("is too short: ", count, " items of ", bytes_each, " bytes expected, ", left, " bytes left"));
}

void PacketReader::finish() const
{
    if (at_ != buffer_.size()) refuse(base::text("is too long: ", buffer_.size() - at_, " bytes left over"));
}

} // namespace coupler
