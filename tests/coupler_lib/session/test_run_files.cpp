// SPDX-License-Identifier: MIT
#include "coupler_lib/session/session.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

struct Own {
    double spacing = 0;
};

coupler::ProgramInfo program_of(const std::string& role)
{
    return {"sph_solver", role, "", [](base::ConfigReader& reader) {
                reader.table("resolution",
                             base::Table<Own>("size").key("spacing", &Own::spacing,
                                                          {.doc = "dx", .positive = true, .required = true}));
                reader.finish();
            }};
}

class RunFilesTest : public testing::Test {
protected:
    RunFilesTest() : folder_(fs::temp_directory_path() / "rivage_run_files")
    {
        fs::create_directories(folder_);
        write("coupling.toml",
              "[participants.fluid]\nprogram = 'sph_solver'\nfile = 'fluid.toml'\n"
              "[participants.solid]\nprogram = 'fem_solver'\nfile = 'solid.toml'\n[time]\nend = 0.4\n");
        write("fluid.toml", "[resolution]\nspacing = 0.001\n");
    }
    ~RunFilesTest() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

    coupler::RunFiles read(const std::string& name, std::vector<std::pair<std::string, std::string>> overrides = {},
                           const std::string& role = "") const
    {
        coupler::CommandLine command;
        command.file = (folder_ / name).string();
        command.overrides = std::move(overrides);
        command.role = role;
        return coupler::read_run_files(program_of("fluid"), command);
    }

    std::string error_of(const std::string& name, std::vector<std::pair<std::string, std::string>> overrides = {},
                         const std::string& role = "") const
    {
        try {
            read(name, std::move(overrides), role);
        } catch (const base::Error& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_;
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(RunFilesTest, ACoupledRunReadsTheSharedFileAndItsOwn)
{
    const auto files = read("coupling.toml", {{"coupling.time.end", "0.1"}, {"solid.newton.tolerance", "1e-8"}});
    ASSERT_TRUE(files.coupling.has_value());
    EXPECT_EQ(files.coupling->time.end, 0.1);
    EXPECT_EQ(files.output_dir, "runs/rivage_run_files");
    EXPECT_TRUE(contains(files.used_own, "spacing = 0.001"));
}

TEST_F(RunFilesTest, AProgramAloneReadsItsOwnFileOnly)
{
    const auto files = read("fluid.toml", {{"fluid.resolution.spacing", "0.002"}});
    EXPECT_FALSE(files.coupling.has_value());
    EXPECT_TRUE(contains(files.used_own, "spacing = 0.002"));
}

TEST_F(RunFilesTest, TheHashCoversContentAndOverrides)
{
    const auto first = read("coupling.toml");
    EXPECT_EQ(first.config_hash, read("coupling.toml").config_hash);
    EXPECT_NE(first.config_hash, read("coupling.toml", {{"coupling.time.end", "0.2"}}).config_hash);
    EXPECT_NE(first.config_hash, read("coupling.toml", {{"solid.gravity.on", "0.2"}}).config_hash);
}

TEST_F(RunFilesTest, ErrorsNameWhatIsWrong)
{
    EXPECT_TRUE(contains(error_of("coupling.toml", {}, "flud"), "did you mean 'fluid'"));
    EXPECT_TRUE(contains(error_of("coupling.toml", {{"flui.resolution.spacing", "1"}}), "did you mean 'fluid'"));
    EXPECT_TRUE(contains(error_of("coupling.toml", {{"fluid.resolution.spacing", "-1"}}), "must be positive"));
    EXPECT_TRUE(contains(error_of("nothing.toml"), "nothing.toml"));
    write("coupling.toml", "[participants.fluid]\nprogram = 'sph_solver'\nfile = "
                           "'gone.toml'\n[participants.solid]\nprogram = 'x'\nfile = 'y'\n[time]\nend = 1\n");
    EXPECT_TRUE(contains(error_of("coupling.toml"), "gone.toml"));
    write("coupling.toml", "[participants.fluid]\nprogram = 'sph_solver'\nfile = 'fluid.toml'\n[time]\nend = 1\n");
    EXPECT_TRUE(contains(error_of("coupling.toml"), "two participants are wanted"));
}

TEST_F(RunFilesTest, AParticipantMayBeAPythonProgram)
{
    write("coupling.toml",
          "[participants.fluid]\nprogram = 'rivage.fake_fluid'\narguments = ['constant', '--pressure', '1']\n"
          "[participants.solid]\nprogram = 'gate.py'\n[time]\nend = 0.4\n");
    EXPECT_TRUE(contains(error_of("coupling.toml", {}, "solid"), "[participants.solid] names no file"));
    const std::string shared = (folder_ / "coupling.toml").string();
    const auto config = coupler::read_shared_file(shared, "fluid", {}).config;
    EXPECT_EQ(config.participants[0].second.command("fluid", shared),
              "/usr/bin/python3 -m rivage.fake_fluid " + shared + " constant --pressure 1 --as fluid");
    EXPECT_EQ(config.participants[1].second.command("solid", shared),
              "/usr/bin/python3 " + (folder_ / "gate.py").string() + " " + shared + " --as solid");
}

TEST_F(RunFilesTest, SeveralSolidsHaveAnInterfaceEach)
{
    const std::string four = "[participants.fluid]\nprogram = 'a'\nfile = 'fluid.toml'\n"
                             "[participants.left]\nprogram = 'b'\nfile = 'y'\n"
                             "[participants.right]\nprogram = 'b'\nfile = 'y'\n[time]\nend = 1\n";
    const auto with = [&](const std::string& interfaces) { write("coupling.toml", four + interfaces); };
    with("[[interface]]\nsolid = 'left'\n[[interface]]\nsolid = 'right'\nload = 'averaged'\n");
    const auto config = *read("coupling.toml").coupling;
    EXPECT_EQ(config.interfaces_of("fluid").size(), 2u);
    EXPECT_EQ(config.interface_of("right").load_kind(), coupler::LoadKind::averaged);
    EXPECT_EQ(config.interface_of("right").settings("right").partner, "fluid");
    EXPECT_EQ(config.interface_of("right").settings("fluid").partner, "right");
    EXPECT_THROW(config.interface_of("fluid"), base::Error);
    EXPECT_EQ(read("coupling.toml", {{"coupling.interface.0.load", "averaged"}}).coupling->interface_of("left").load,
              "averaged");

    with("[[interface]]\nsolid = 'left'\n");
    EXPECT_TRUE(contains(error_of("coupling.toml"), "'right' has no interface"));
    with("[[interface]]\nsolid = 'left'\n[[interface]]\nsolid = 'left'\n");
    EXPECT_TRUE(contains(error_of("coupling.toml"), "'left' has two interfaces"));
    with("[[interface]]\nsolid = 'left'\n[[interface]]\nsolid = 'rigth'\n");
    EXPECT_TRUE(contains(error_of("coupling.toml"), "did you mean 'right'"));
    with("[[interface]]\nsolid = 'left'\n[[interface]]\nfluid = 'left'\nsolid = 'right'\n");
    EXPECT_TRUE(contains(error_of("coupling.toml"), "different fluids"));
}

} // namespace
