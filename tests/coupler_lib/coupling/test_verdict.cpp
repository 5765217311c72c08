// SPDX-License-Identifier: MIT
// Who may start a run: every way to get it wrong, and what is said about it.
#include "coupler_lib/coupling/introduction.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <gtest/gtest.h>

namespace {

using coupler::Introduction;
using coupler::judge;

Introduction member(const std::string& role, int appnum)
{
    Introduction one;
    one.role = role;
    one.expected_roles = {"fluid", "solid"};
    one.config_file = "coupling.toml";
    one.config_hash = "0123";
    one.version = "abc";
    one.launch = {{"fluid", "sph_solver coupling.toml"}, {"solid", "fem_solver coupling.toml"}};
    one.appnum = appnum;
    return one;
}

bool says(const coupler::Verdict& verdict, const std::string& piece)
{
    return verdict.message.find(piece) != std::string::npos;
}

TEST(Verdict, LetsACompleteSetStart)
{
    EXPECT_EQ(judge({member("fluid", 0), member("fluid", 0), member("solid", 1)}).code, 0);
}

TEST(Verdict, NeedsNoLaunchSegments) { EXPECT_EQ(judge({member("fluid", 0), member("solid", 0)}).code, 0); }

TEST(Verdict, LetsAFluidRunAlone)
{
    auto alone = member("fluid", 0);
    alone.expected_roles = {"fluid"};
    EXPECT_EQ(judge({alone, alone}).code, 0);
}

TEST(Verdict, NamesAMissingRoleAndTheRightCommand)
{
    const auto verdict = judge({member("fluid", 0), member("fluid", 0)});
    EXPECT_EQ(verdict.code, 4);
    EXPECT_TRUE(says(verdict, "'solid' is missing")) << verdict.message;
    EXPECT_TRUE(says(verdict, "'fluid' (ranks 0, 1)")) << verdict.message;
    EXPECT_TRUE(says(verdict, "mpirun -n 2 sph_solver")) << verdict.message;
}

TEST(Verdict, NamesADoubledRole)
{
    const auto verdict = judge({member("fluid", 0), member("fluid", 1), member("solid", 2)});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_TRUE(says(verdict, "'fluid' is doubled")) << verdict.message;
}

TEST(Verdict, NamesTwoProgramsInOneRoleWhereSegmentsCannotBeToldApart)
{
    auto one = member("fluid", 0), other = member("fluid", 0);
    one.program = "sph_solver";
    other.program = "fake_fluid";
    const auto verdict = judge({one, other, member("solid", 0)});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_TRUE(says(verdict, "'fluid' is doubled")) << verdict.message;
}

TEST(Verdict, NamesRanksOfARoleThatReadDifferentFiles)
{
    auto one = member("solid", 1), other = member("solid", 1);
    one.own_file = "a/solid.toml", one.own_hash = "1";
    other.own_file = "b/solid.toml", other.own_hash = "2";
    const auto verdict = judge({member("fluid", 0), one, other});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_TRUE(says(verdict, "a/solid.toml") && says(verdict, "b/solid.toml") && says(verdict, "rank 2"))
        << verdict.message;
}

TEST(Verdict, NamesDifferentLibraries)
{
    auto one = member("fluid", 0), other = member("solid", 1);
    one.libraries = "Open MPI v4";
    other.libraries = "Open MPI v5";
    const auto verdict = judge({one, other});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_TRUE(says(verdict, "different libraries") && says(verdict, "Open MPI v5")) << verdict.message;
}

TEST(Verdict, TakesASolverFromOutsideAtItsWord)
{
    Introduction own;
    own.role = "solid";
    own.expected_roles = {"fluid", "solid"};
    EXPECT_EQ(judge({member("fluid", 0), own}).code, 0);
    EXPECT_EQ(judge({own, member("fluid", 0)}).code, 0);
}

TEST(Verdict, SuggestsTheNearestRole)
{
    auto mistyped = member("soild", 1);
    const auto verdict = judge({member("fluid", 0), mistyped});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_TRUE(says(verdict, "'soild'")) << verdict.message;
    EXPECT_TRUE(says(verdict, "'solid'")) << verdict.message;
}

TEST(Verdict, NamesBothSharedFilesWhenTheyDiffer)
{
    auto other = member("solid", 1);
    other.config_hash = "4567";
    other.config_file = "old/coupling.toml";
    const auto verdict = judge({member("fluid", 0), other});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_TRUE(says(verdict, "old/coupling.toml")) << verdict.message;
    EXPECT_TRUE(says(verdict, "0123")) << verdict.message;
}

TEST(Verdict, NamesBothVersionsWhenTheyDiffer)
{
    auto other = member("solid", 1);
    other.version = "def";
    const auto verdict = judge({member("fluid", 0), other});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_TRUE(says(verdict, "abc") && says(verdict, "def")) << verdict.message;
}

TEST(Verdict, PassesOnAnErrorOnceWithItsCode)
{
    auto fluid = member("fluid", 0), solid = member("solid", 1);
    fluid.failure = solid.failure = "coupling.toml:3: unknown key 'ned'";
    fluid.failure_code = solid.failure_code = 2;
    const auto verdict = judge({fluid, solid});
    EXPECT_EQ(verdict.code, 2);
    EXPECT_EQ(verdict.message, fluid.failure);
}

TEST(Verdict, AdvisesTheRanksThatAreThere)
{
    const auto verdict = judge({member("fluid", 0), member("fluid", 0), member("fluid", 0)});
    EXPECT_TRUE(says(verdict, "mpirun -n 3 sph_solver coupling.toml : -n 1 fem_solver coupling.toml"))
        << verdict.message;
}

TEST(Introduction, SurvivesTheMessage)
{
    auto sent = member("fluid", 3);
    sent.host = "gauss";
    sent.program = "sph_solver";
    sent.own_hash = "89ab";
    sent.libraries = "Open MPI v4";
    sent.pid = 4711;
    sent.failure = "no such file";
    sent.failure_code = 2;
    const auto got = coupler::unpack_introduction(coupler::pack(sent));
    EXPECT_EQ(got.role, sent.role);
    EXPECT_EQ(got.expected_roles, sent.expected_roles);
    EXPECT_EQ(launch_line(got.launch), launch_line(sent.launch));
    EXPECT_EQ(got.host, "gauss");
    EXPECT_EQ(got.pid, 4711);
    EXPECT_EQ(got.appnum, 3);
    EXPECT_EQ(got.failure, sent.failure);
    EXPECT_EQ(got.failure_code, 2);
    EXPECT_EQ(got.program, sent.program);
    EXPECT_EQ(got.own_hash, sent.own_hash);
    EXPECT_EQ(got.libraries, sent.libraries);
}

TEST(Introduction, RefusesATextThatIsCutShort)
{
    const std::string whole = coupler::pack(member("fluid", 0));
    for (std::size_t length : {std::size_t{0}, std::size_t{3}, whole.size() / 2, whole.size() - 1})
        EXPECT_THROW(coupler::unpack_introduction(whole.substr(0, length)), base::Error) << length;
}

} // namespace
