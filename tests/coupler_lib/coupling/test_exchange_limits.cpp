// SPDX-License-Identifier: MIT
// What the exchange refuses, counts and agrees on.
#include "coupled_world.hpp"

#include "coupler_lib/coupling/packet.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace coupled_test;

coupler::FacetBatch nothing() { return {}; }

std::string message_of(const std::function<void()>& action, base::ExitCode code)
{
    try {
        action();
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        return error.what();
    }
    return "";
}

/// A surface of 10 facets owned by solid rank 0 alone, or dealt to all.
coupler::WetSurface my_part(const coupler::Participant& solid)
{
    return dealt_surface(whole_surface(2, 3), solid.comm().rank(), solid.comm().size(), 5);
}

TEST(Alone, AFluidNeedsNoPartner)
{
    coupler::ParticipantSettings settings;
    settings.role = "fluid";
    coupler::Participant me(settings);
    EXPECT_FALSE(me.coupled());
    EXPECT_EQ(me.comm().size(), world_size());
    EXPECT_THROW(me.partner_ranks(), base::Error);
    EXPECT_THROW(coupler::FluidInterface(me, {}, 2), base::Error);
}

TEST(Roles, AreFoundByName)
{
    for (const int fluid_ranks : all_splits()) {
        coupler::Participant me(settings_for(fluid_ranks));
        EXPECT_TRUE(me.coupled());
        EXPECT_EQ(me.comm().size(), me.role() == "fluid" ? fluid_ranks : world_size() - fluid_ranks);
        EXPECT_EQ(me.partner_ranks().size() + static_cast<std::size_t>(me.comm().size()),
                  static_cast<std::size_t>(world_size()));
        EXPECT_EQ(me.introduction(0).role, "fluid");
        EXPECT_EQ(me.partners(), std::vector<std::string>{me.role() == "fluid" ? "solid" : "fluid"});
    }
}

TEST(Roles, AMissingOneEndsAllRanksWithOneVerdict)
{
    auto settings = settings_for(world_size()); // all are the fluid
    try {
        coupler::Participant me(settings);
        ADD_FAILURE() << "the run started without a solid";
    } catch (const coupler::AgreedError& error) {
        EXPECT_EQ(error.code(), base::ExitCode::partner_lost);
        EXPECT_TRUE(error.orderly());
        EXPECT_NE(std::string(error.what()).find("'solid' is missing"), std::string::npos) << error.what();
    }
}

TEST(Bytes, AFluidRankAwayFromTheSurfaceReceivesNoFacet)
{
    constexpr int steps = 4;
    const std::size_t empty = sizeof(coupler::SolidReport) + sizeof(coupler::PacketHeader);
    for (const int fluid_ranks : all_splits()) {
        coupler::Participant me(settings_for(fluid_ranks));
        if (me.role() == "fluid") {
            coupler::FluidInterface wet(me, {}, 2);
            coupler::SolidReport report;
            coupler::FacetBatch batch;
            const bool away = me.comm().rank() > 0;
            const auto box = away ? (me.comm().rank() % 2 ? slice(50, 60) : coupler::RegionBox{}) : slice(-9, 9);
            std::int64_t before = 0;
            for (int step = -1; step < steps; ++step) {
                wet.send({step, step < 0 ? 0.0 : 0.1 * step, step < 0 ? 0.0 : 0.1, step == steps - 1}, box, {}, batch,
                         {});
                batch = wet.receive(report);
                const auto bytes = wet.bytes_received() - before;
                before += bytes;
                std::int64_t expected = static_cast<std::int64_t>(empty * me.partner_ranks().size());
                if (away) {
                    EXPECT_TRUE(batch.facet_ids.empty() && batch.node_ids.empty());
                    EXPECT_EQ(bytes, expected);
                } else if (me.partner_ranks().size() == 1) {
                    if (step < 0) expected += 60 * (8 + 16) + 61 * 8; // ids and connectivity travel once
                    EXPECT_EQ(bytes, expected + 61 * 3 * 2 * 8) << "step " << step;
                }
            }
        } else {
            coupler::SolidInterface wet(me, {}, my_part(me));
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            for (bool last = false; !last;) {
                last = wet.receive(load, report).last;
                wet.send(motion_of(wet.surface(), 0), {});
            }
        }
        MPI_Barrier(MPI_COMM_WORLD);
    }
}

TEST(Refusals, MotionThatIsNotANumberStaysAtHome)
{
    for (const int fluid_ranks : all_splits()) {
        coupler::Participant me(settings_for(fluid_ranks));
        if (me.role() == "fluid") {
            coupler::FluidInterface wet(me, {}, 2);
            coupler::SolidReport report;
            wet.send({-1, 0, 0, true}, slice(-9, 9), {}, nothing(), {});
            wet.receive(report);
        } else {
            coupler::SolidInterface wet(me, {}, my_part(me));
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            wet.receive(load, report);
            auto motion = motion_of(wet.surface(), 0);
            motion.velocity[2] = std::numeric_limits<double>::infinity();
            const auto message = message_of([&] { wet.send(motion, {}); }, base::ExitCode::numerical_failure);
            EXPECT_NE(message.find("wet node " + std::to_string(wet.surface().node_ids[1])), std::string::npos)
                << message;
            EXPECT_NE(message.find("'solid' (rank " + std::to_string(world_rank())), std::string::npos) << message;
            wet.send(motion_of(wet.surface(), 0), {});
        }
        MPI_Barrier(MPI_COMM_WORLD);
    }
}

TEST(Refusals, APacketOfAnotherStepNamesBothViews)
{
    for (const int fluid_ranks : all_splits()) {
        coupler::Participant me(settings_for(fluid_ranks));
        if (me.role() == "fluid") {
            coupler::FluidInterface wet(me, {}, 2);
            coupler::SolidReport report;
            wet.send({-1, 0, 0}, slice(-9, 9), {}, nothing(), {});
            wet.receive(report);
            wet.send({3, 0, 0.5}, slice(-9, 9), {}, nothing(), {}); // load 3 instead of load 0
        } else {
            coupler::SolidInterface wet(me, {}, my_part(me));
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            wet.receive(load, report);
            wet.send(motion_of(wet.surface(), 0), {});
            const auto message = message_of([&] { wet.receive(load, report); }, base::ExitCode::bad_input);
            EXPECT_NE(message.find("expects the load of step 0"), std::string::npos) << message;
            EXPECT_NE(message.find("sent the load of step 3"), std::string::npos) << message;
        }
        MPI_Barrier(MPI_COMM_WORLD);
    }
}

TEST(Refusals, AnotherDimensionIsNoticedAtTheGreeting)
{
    for (const int fluid_ranks : all_splits()) {
        coupler::Participant me(settings_for(fluid_ranks));
        if (me.role() == "fluid") {
            coupler::FluidInterface wet(me, {}, 3);
            wet.send({-1, 0, 0}, slice(-9, 9), {}, {3, {}, {}, {}, {}}, {});
        } else {
            coupler::SolidInterface wet(me, {}, my_part(me));
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            const auto message = message_of([&] { wet.receive(load, report); }, base::ExitCode::bad_input);
            EXPECT_NE(message.find("3D"), std::string::npos) << message;
        }
        MPI_Barrier(MPI_COMM_WORLD);
    }
}

TEST(Stopping, IsAgreedOnByAllRanksAtTheSameStep)
{
    constexpr int ask_at = 2;
    for (const int fluid_ranks : all_splits()) {
        for (const int asker : {0, fluid_ranks - 1, world_size() - 1}) {
            coupler::Participant me(settings_for(fluid_ranks));
            std::int64_t left_at = -1;
            if (me.role() == "fluid") {
                coupler::FluidInterface wet(me, {}, 2);
                coupler::SolidReport report;
                bool stop = false;
                for (int step = -1; step < 10 && !stop; ++step) {
                    if (step == ask_at && world_rank() == asker) me.request_stop();
                    stop = wet.stop_agreed();
                    wet.send({step, 0.0, 0.0, stop, stop}, slice(-9, 9), {}, nothing(), {});
                    wet.receive(report);
                    left_at = step;
                }
            } else {
                coupler::SolidInterface wet(me, {}, my_part(me));
                coupler::SurfaceLoad load;
                coupler::FluidReport report;
                coupler::Window window;
                while (!window.last) {
                    window = wet.receive(load, report);
                    if (window.step == ask_at && world_rank() == asker) me.request_stop();
                    wet.send(motion_of(wet.surface(), 0), {});
                }
                EXPECT_TRUE(window.stop_requested);
                left_at = window.step;
            }
            EXPECT_EQ(left_at, ask_at + 1);
            MPI_Barrier(MPI_COMM_WORLD);
        }
    }
}

TEST(Waiting, APartnerThatHasLeftIsNoticedAtOnce)
{
    for (const int fluid_ranks : all_splits()) {
        coupler::Participant me(settings_for(fluid_ranks));
        if (me.role() == "fluid") {
            coupler::FluidInterface wet(me, {}, 2);
            coupler::SolidReport report;
            wet.send({-1, 0, 0}, slice(-9, 9), {}, nothing(), {});
            const double begin = MPI_Wtime();
            const auto message = message_of([&] { wet.receive(report); }, base::ExitCode::partner_lost);
            EXPECT_LT(MPI_Wtime() - begin, 5.0);
            EXPECT_NE(message.find("has ended its run early"), std::string::npos) << message;
        } else {
            coupler::SolidInterface wet(me, {}, my_part(me));
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            wet.receive(load, report);
            me.finish();
        }
        MPI_Barrier(MPI_COMM_WORLD);
    }
}

TEST(Waiting, ASilentPartnerIsNamedAfterTheDeadline)
{
    for (const int fluid_ranks : all_splits()) {
        auto settings = settings_for(fluid_ranks);
        settings.silence_timeout = 0.3;
        coupler::Participant me(settings);
        if (me.role() == "fluid") {
            coupler::FluidInterface wet(me, {}, 2);
            coupler::SolidReport report;
            const double begin = MPI_Wtime();
            const auto message = message_of([&] { wet.receive(report); }, base::ExitCode::partner_lost);
            EXPECT_GT(MPI_Wtime() - begin, 0.25);
            EXPECT_NE(message.find("from 'solid' (rank " + std::to_string(fluid_ranks)), std::string::npos) << message;
            EXPECT_NE(message.find("is silent"), std::string::npos) << message;
        }
        MPI_Barrier(MPI_COMM_WORLD);
    }
}

} // namespace
