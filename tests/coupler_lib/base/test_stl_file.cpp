// SPDX-License-Identifier: MIT
#include "coupler_lib/base/stl_file.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace {

using base::Point;
using base::Simplex;

/// The cuboid from the origin to `size`, normals outwards.
std::vector<Simplex<3>> cuboid(const Point<3>& size)
{
    static constexpr std::array<std::array<int, 4>, 6> faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    const auto corner = [&](int v) {
        return Point<3>((v & 1) != 0 ? size.x() : 0, (v & 2) != 0 ? size.y() : 0, (v & 4) != 0 ? size.z() : 0);
    };
    std::vector<Simplex<3>> triangles;
    for (const auto& f : faces) {
        triangles.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
        triangles.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
    }
    return triangles;
}

class StlFile : public testing::Test {
protected:
    void SetUp() override
    {
        path = (std::filesystem::temp_directory_path() /
                (std::string("rivage_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".stl"))
                   .string();
    }
    void TearDown() override { std::filesystem::remove(path); }

    void write(const std::string& content) { std::ofstream(path, std::ios::binary) << content; }

    static std::string binary(const std::vector<Simplex<3>>& triangles)
    {
        std::string bytes = "solid, although binary";
        bytes.resize(80, ' ');
        const auto append = [&](const auto& number) {
            bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
        };
        append(static_cast<std::uint32_t>(triangles.size()));
        for (const auto& triangle : triangles) {
            bytes.append(12, '\0');
            for (const auto& corner : triangle)
                for (int d = 0; d < 3; ++d) append(static_cast<float>(corner[d]));
            bytes.append(2, '\0');
        }
        return bytes;
    }

    static std::string ascii(const std::vector<Simplex<3>>& triangles)
    {
        std::ostringstream text;
        text << "solid box\n";
        for (const auto& t : triangles) {
            text << " facet normal 0 0 0\n  outer loop\n";
            for (const auto& c : t) text << "   vertex " << c.x() << " " << c.y() << " " << c.z() << "\n";
            text << "  endloop\n endfacet\n";
        }
        text << "endsolid box\n";
        return text.str();
    }

    std::string error()
    {
        try {
            base::require_closed(base::read_stl(path), path);
        } catch (const base::Error& failure) {
            return failure.what();
        }
        return "";
    }

    std::string path;
};

TEST_F(StlFile, BinaryAndAsciiGiveTheSameClosedSurface)
{
    const auto box = cuboid({1, 2, 3});
    for (const auto& content : {binary(box), ascii(box)}) {
        write(content);
        const auto mesh = base::read_stl(path, 0.5);
        EXPECT_EQ(mesh.corners.size(), 8U);
        EXPECT_EQ(mesh.triangles.size(), 12U);
        EXPECT_DOUBLE_EQ(base::enclosed_volume(mesh), 6.0 / 8.0);
        EXPECT_EQ(error(), "");
    }
}

TEST_F(StlFile, HolesAndTurnedTrianglesAreNamed)
{
    auto box = cuboid({1, 2, 3});
    box.pop_back();
    write(ascii(box));
    EXPECT_NE(error().find("not closed: 3 edges"), std::string::npos) << error();
    box = cuboid({1, 2, 3});
    std::swap(box[4][0], box[4][1]);
    write(binary(box));
    EXPECT_NE(error().find("turn all normals outwards"), std::string::npos) << error();
}

TEST_F(StlFile, BrokenFilesAreRefused)
{
    EXPECT_NE(error().find("cannot read"), std::string::npos);
    auto cut = binary(cuboid({1, 1, 1}));
    cut.resize(cut.size() - 7);
    cut[0] = 'x';
    write(cut);
    EXPECT_NE(error().find("was it cut short?"), std::string::npos) << error();
    write("solid a\n outer loop\n vertex 0 0\n");
    EXPECT_NE(error().find(":3: not a corner"), std::string::npos) << error();
    write("solid a\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n endloop\n");
    EXPECT_NE(error().find("a loop of 2 corners"), std::string::npos) << error();
    write("solid empty\nendsolid empty\n");
    EXPECT_NE(error().find("no triangle"), std::string::npos) << error();
}

TEST(TriangleMesh, EveryLineGoesInAsOftenAsOut)
{
    const auto mesh = base::join(cuboid({1, 1, 1}));
    for (int i = -1; i <= 9; ++i) {
        for (int j = -1; j <= 9; ++j) { // on edges, diagonals and corners too
            int winding = 0, inside_passed = 0;
            for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
                const auto crossing = base::crossing_of_vertical(mesh.triangle(k), i / 8.0, j / 8.0);
                if (!crossing) continue;
                winding += crossing->winding;
                ++inside_passed;
                EXPECT_EQ(crossing->z, crossing->winding > 0 ? 0.0 : 1.0);
            }
            EXPECT_EQ(winding, 0) << i << " " << j;
            const bool inside = i >= 0 && i < 8 && j >= 0 && j < 8;
            EXPECT_EQ(inside_passed, inside ? 2 : 0) << i << " " << j;
        }
    }
}

} // namespace
