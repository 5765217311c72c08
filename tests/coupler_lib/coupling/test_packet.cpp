// SPDX-License-Identifier: MIT
// A packet arrives as it was sent, or not at all.
#include "coupler_lib/coupling/checksum.hpp"
#include "coupler_lib/coupling/load_packet.hpp"
#include "coupler_lib/coupling/packet.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <gtest/gtest.h>
#include <set>

namespace {

std::vector<char> example()
{
    coupler::PacketHeader header;
    header.step = 17;
    header.time = 0.25;
    header.dt = 1e-5;
    header.dimension = 2;
    coupler::PacketWriter writer;
    writer.begin();
    writer.put(3.5);
    writer.put(std::vector<int>{1, 2, 3});
    writer.finish(header);
    return {writer.bytes().begin(), writer.bytes().end()};
}

TEST(Packet, ArrivesAsItWasSent)
{
    const auto bytes = example();
    coupler::PacketReader reader(bytes);
    double number = 0;
    std::vector<int> list;
    reader.take(number);
    reader.take(list, 3);
    reader.finish();
    EXPECT_EQ(reader.header().step, 17);
    EXPECT_EQ(reader.header().time, 0.25);
    EXPECT_EQ(number, 3.5);
    EXPECT_EQ(list, (std::vector<int>{1, 2, 3}));
}

TEST(Packet, RefusesDamageInAnyByte)
{
    const auto whole = example();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        auto damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        EXPECT_THROW(coupler::PacketReader{damaged}, base::Error) << "byte " << at;
    }
}

TEST(Packet, RefusesAnotherLength)
{
    auto shorter = example();
    shorter.pop_back();
    EXPECT_THROW(coupler::PacketReader{shorter}, base::Error);
    auto longer = example();
    longer.push_back(0);
    EXPECT_THROW(coupler::PacketReader{longer}, base::Error);
    EXPECT_THROW(coupler::PacketReader{std::vector<char>(5)}, base::Error);
}

TEST(Packet, RefusesToBeReadBeyondItsEndOrLeftHalfRead)
{
    const auto bytes = example();
    coupler::PacketReader reader(bytes);
    std::vector<double> many;
    EXPECT_THROW(reader.take(many, 4), base::Error);
    EXPECT_THROW(reader.take(many, std::size_t{1} << 62), base::Error);
    EXPECT_THROW(reader.finish(), base::Error);
}

TEST(Checksum, TellsLengthsOrdersAndSingleBitsApart)
{
    std::vector<unsigned char> data(100, 0);
    std::set<std::uint64_t> seen;
    std::size_t count = 0;
    for (std::size_t length = 0; length <= data.size(); ++length, ++count)
        seen.insert(coupler::checksum(data.data(), length));
    for (std::size_t bit = 0; bit < 800; ++bit, ++count) {
        auto changed = data;
        changed[bit / 8] = static_cast<unsigned char>(1u << (bit % 8));
        seen.insert(coupler::checksum(changed.data(), changed.size()));
    }
    EXPECT_EQ(seen.size(), count);
    const std::vector<double> ab{1, 2, 0, 0, 0, 0, 0, 0}, ba{2, 1, 0, 0, 0, 0, 0, 0}, far{1, 0, 0, 0, 2, 0, 0, 0};
    EXPECT_NE(coupler::checksum(ab.data(), 64), coupler::checksum(ba.data(), 64));
    EXPECT_NE(coupler::checksum(ab.data(), 64), coupler::checksum(far.data(), 64));
}

/// One segment with its two nodes, given to one fluid rank.
struct OneFacet {
    OneFacet()
    {
        surface.node_ids = {7, 9};
        surface.reference = {0, 0, 1, 0};
        surface.facet_ids = {4};
        surface.facet_nodes = {{0, 1, -1, -1}};
        const coupler::SurfaceMotion motion{surface.reference, surface.reference, surface.reference};
        const coupler::RegionBox region{{-1, -1, -1}, {2, 2, 2}};
        route.choose(surface, {0}, motion, coupler::box_around(motion.position, 2), region);
    }
    coupler::WetSurface surface;
    coupler::FacetRoute route;
};

TEST(LoadSum, RefusesALoadForAnotherNumberOfNodesAndNamesBothCounts)
{
    const OneFacet given;
    coupler::PacketHeader header;
    header.flags = coupler::with_force | coupler::force_is_whole;
    header.facets = 2;
    header.nodes = 3;
    coupler::PacketWriter writer;
    writer.begin();
    writer.put(std::vector<double>(6, 1.0));
    writer.finish(header);
    const std::vector<char> bytes(writer.bytes().begin(), writer.bytes().end());
    coupler::PacketReader packet(bytes);
    coupler::LoadSum sum(given.surface);
    try {
        sum.add(packet, given.route, "'fluid' (rank 0)");
        ADD_FAILURE() << "taken";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        EXPECT_STREQ(error.what(), "'fluid' (rank 0) sent a load on 2 facets and 3 nodes, but was given 1 facets and 2 "
                                   "nodes: the two sides have lost step with each other");
    }
}

} // namespace
