// SPDX-License-Identifier: MIT
#include "coupler_lib/base/config.hpp"
#include "coupler_lib/base/ground.hpp"

namespace base {
namespace {

/// ground.toml.
struct GroundFile {
    Formula height{};
    double derivative_step = 1e-5;
};

Table<GroundFile> ground_file_table()
{
    return Table<GroundFile>("the height of a rigid ground, for all who stand on it")
        .key("height", &GroundFile::height, {.unit = "m", .doc = "formula of x (and y in 3D) [m]", .required = true})
        .key("derivative_step", &GroundFile::derivative_step,
             {.unit = "m", .doc = "of its differences; short against its waves", .positive = true});
}

} // namespace

std::unique_ptr<HeightField> make_height_file(const std::string& path, int dimension)
{
    if (!path.ends_with(".toml")) return make_height_table(path, dimension);
    ConfigReader reader(ConfigDocument::load(path));
    const auto ground = reader.table("", ground_file_table());
    reader.finish();
    return make_height_formula(ground.height, dimension, ground.derivative_step);
}

} // namespace base
