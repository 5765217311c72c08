// SPDX-License-Identifier: MIT
#include "coupler_lib/base/stl_file.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

namespace base {
namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

std::string content_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    require_input(file.good(), "cannot read the STL file '", path, "'; is the path right?");
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

template<class T> T number_at(const std::string& bytes, std::size_t offset)
{
    static_assert(std::endian::native == std::endian::little, "STL is little endian");
    T number;
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

/// 80 bytes of comment, the number of triangles, then for each the normal, three corners (float32) and two bytes.
bool is_binary(const std::string& bytes)
{
    return bytes.size() >= header_bytes &&
           bytes.size() == header_bytes + triangle_bytes * std::size_t{number_at<std::uint32_t>(bytes, 80)};
}

std::vector<Simplex<3>> read_binary(const std::string& bytes)
{
    std::vector<Simplex<3>> triangles((bytes.size() - header_bytes) / triangle_bytes);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const std::size_t corners = header_bytes + triangle_bytes * k + 12;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t d = 0; d < 3; ++d)
                triangles[k][c][static_cast<int>(d)] =
                    static_cast<double>(number_at<float>(bytes, corners + 4 * (3 * c + d)));
    }
    return triangles;
}

/// "vertex x y z" is all that counts; "outer loop" and "endloop" must enclose three of them.
std::vector<Simplex<3>> read_ascii(const std::string& content, const std::string& path)
{
    std::vector<Simplex<3>> triangles;
    std::istringstream lines(content);
    std::size_t corner = 0, number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "outer") {
            triangles.emplace_back();
            corner = 0;
        } else if (word == "vertex") {
            double x = 0, y = 0, z = 0;
            words >> x >> y >> z;
            require_input(!words.fail() && !triangles.empty() && corner < 3, path, ":", number,
                          ": not a corner of a triangle (three lines \"vertex x y z\" after \"outer loop\"): ", line);
            triangles.back()[corner++] = {x, y, z};
        } else if (word == "endloop") {
            require_input(corner == 3, path, ":", number, ": a loop of ", corner, " corners; only triangles are read");
        }
    }
    require_input(triangles.empty() || corner == 3, path, ": the file ends within a triangle");
    return triangles;
}

} // namespace

TriangleMesh read_stl(const std::string& path, double metres_per_unit)
{
    const std::string content = content_of(path);
    const bool binary = is_binary(content);
    require_input(
        binary || content.rfind("solid", 0) == 0, "'", path, "' (", content.size(),
        " bytes) is not an STL file: neither text that begins with \"solid\", nor binary with 84 bytes and 50 "
        "for each triangle that it announces; was it cut short?");
    auto triangles = binary ? read_binary(content) : read_ascii(content, path);
    require_input(!triangles.empty(), "the STL file '", path, "' holds no triangle");
    for (auto& triangle : triangles) {
        for (auto& corner : triangle) {
            require_input(corner.allFinite(), "the STL file '", path, "' holds a corner that is not a number");
            corner *= metres_per_unit;
        }
    }
    return join(triangles);
}

} // namespace base
