// SPDX-License-Identifier: MIT
#include "coupler_lib/base/xdmf.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sstream>

namespace {

std::vector<double> read_dataset(const std::string& file, const std::string& path)
{
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(id, path.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(dataset);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(dataset);
    H5Fclose(id);
    return values;
}

/// Rank r holds r points; the ranks' rows follow one another, also when the first rank has none.
TEST(Xdmf, GathersTheRowsOfAllRanks)
{
    const auto world = base::Communicator::world();
    const auto path =
        (std::filesystem::temp_directory_path() / ("rivage_xdmf_" + std::to_string(world.size()))).string();
    std::vector<double> points, pressure, expected;
    for (int k = 0; k < world.rank(); ++k) {
        points.insert(points.end(), {1.0 * k, 2.0 * world.rank(), 0.0});
        pressure.push_back(100 * world.rank() + k);
    }
    for (int rank = 0; rank < world.size(); ++rank)
        for (int k = 0; k < rank; ++k) expected.push_back(100 * rank + k);
    {
        base::XdmfWriter writer(path, world);
        const std::vector<base::XdmfField> fields{{"pressure", "Pa", "pressure", 1, [&] { return pressure; }, "Node"}};
        writer.write(0.0, {}, points, fields);
        writer.write(0.5, {}, points, fields);
    }
    world.barrier();
    if (world.is_root()) {
        EXPECT_EQ(read_dataset(path + ".h5", "/step_000001/pressure"), expected);
        EXPECT_EQ(read_dataset(path + ".h5", "/step_000000/points").size(), 3 * expected.size());
        std::ifstream index(path + ".xdmf");
        std::stringstream text;
        text << index.rdbuf();
        EXPECT_NE(text.str().find("<Time Value=\"0.5\"/>"), std::string::npos);
        EXPECT_NE(text.str().find(":/step_000001/pressure<"), std::string::npos);
        std::filesystem::remove(path + ".h5");
        std::filesystem::remove(path + ".xdmf");
    }
}

} // namespace
