// SPDX-License-Identifier: MIT
#include "sph_solver/interface/mapping_report.hpp"
#include "tests/sph_solver/interface/wet_plate.hpp"

namespace sph {
namespace {

using namespace sample;

template<class T> class InterfaceLoadsTest : public testing::Test {};
template<int D> struct Dimension {
    static constexpr int value = D;
};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(InterfaceLoadsTest, Dimensions);

/// sum over corners of f_c . u_c, for u given at the nodes.
template<int D>
double corner_work(const coupler::FacetLoads& loads, const coupler::FacetBatch& batch, const std::vector<double>& u)
{
    double work = 0;
    for (std::size_t f = 0; f < batch.facet_nodes.size(); ++f)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t a = 0; a < D && batch.facet_nodes[f][c] >= 0; ++a)
                work += loads.corner_force[(f * 4 + c) * D + a].value() *
                        u[static_cast<std::size_t>(batch.facet_nodes[f][c]) * D + a];
    return work;
}

TYPED_TEST(InterfaceLoadsTest, VirtualWorkIsThatOfTheFluid)
{
    constexpr int D = TypeParam::value;
    WetPlate<D> cast(7);
    Noise noise(5);
    for (double& v : cast.batch.motion.velocity) v = noise();
    cast.evaluate();
    InterfaceLoads<D> loads(cast.walls.settings(), false);
    loads.begin(cast.walls, cast.batch.facet_ids.size());
    loads.add(cast.particles, cast.walls, cast.forces.on_wall, 0.25);
    loads.add(cast.particles, cast.walls, cast.forces.on_wall, 0.75);

    double power = 0, scale = 0;
    for (std::size_t p = 0; p < cast.forces.on_wall.size(); ++p) {
        power += cast.forces.on_wall[p].dot(cast.walls.contacts().planes[p].velocity);
        scale += cast.forces.on_wall[p].norm();
    }
    EXPECT_NEAR(corner_work<D>(loads.loads(), cast.batch, cast.batch.motion.velocity), power, 1e-12 * scale);

    WallPower account;
    add_wall_power(account, 1.0, cast.forces, cast.walls, cast.particles);
    EXPECT_NEAR(account.by_interface.value(), -power, 1e-12 * scale);
    EXPECT_EQ(account.by_walls.value(), 0);
}

/// Particles at half spacings over the plate; the same on every rank, each facet counted once.
TYPED_TEST(InterfaceLoadsTest, MappingIsReported)
{
    constexpr int D = TypeParam::value;
    WetPlate<D> cast(7);
    cast.evaluate();
    const auto world = base::Communicator::world();
    const MappingReport report = examine_mapping(cast.walls, cast.batch, {}, 1.0, world);
    EXPECT_EQ(report.facets, std::ssize(cast.batch.facet_ids));
    EXPECT_EQ(report.touched, report.facets); // under water all over
    EXPECT_NEAR(report.area, std::pow(10, D - 1), 1e-12);
    EXPECT_NEAR(report.nearest, 0.5, 1e-12);
    EXPECT_NEAR(report.layer, 0.5, 1e-12);
    EXPECT_LT(report.constant_error, 1e-14);
    EXPECT_GT(report.centre_distance, 0.01); // along the plate's edge
    EXPECT_LT(report.centre_distance, 0.5);
    EXPECT_NE(describe(report, "wet", D, 1.0).find(" facets, "), std::string::npos);
}

TYPED_TEST(InterfaceLoadsTest, ForceAndMomentAreThoseOfTheFluidOnItsFootprints)
{
    constexpr int D = TypeParam::value;
    WetPlate<D> cast(7);
    cast.evaluate();
    InterfaceLoads<D> loads(cast.walls.settings(), false);
    loads.begin(cast.walls, cast.batch.facet_ids.size());
    loads.add(cast.particles, cast.walls, cast.forces.on_wall, 1.0);
    const auto total = resultant(loads.loads(), cast.walls, cast.batch, {});
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
    for (std::size_t p = 0; p < cast.forces.on_wall.size(); ++p) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero(), f = Eigen::Vector3d::Zero();
        const auto& plane = cast.walls.contacts().planes[p];
        for (int part = plane.footprint_begin; part < plane.footprint_end; ++part) {
            const auto& [facet, share] = cast.walls.contacts().footprints[static_cast<std::size_t>(part)];
            for (std::size_t c = 0; c < D; ++c) x.head(D) += share[c] * cast.walls.facets().corners(facet)[c];
        }
        f.head(D) = cast.forces.on_wall[p];
        EXPECT_LT((x.head(D) - plane.point).norm(), cast.walls.settings().spacing); // the footprint lies around x_w
        force += f;
        moment += Eigen::Vector3d(x.y() * f.z() - x.z() * f.y(), x.z() * f.x() - x.x() * f.z(),
                                  x.x() * f.y() - x.y() * f.x());
    }
    for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_NEAR(total[a].value(), force[static_cast<int>(a)], 1e-12 * force.norm());
        EXPECT_NEAR(total[3 + a].value(), moment[static_cast<int>(a)], 1e-11 * force.norm() * 10);
    }
    EXPECT_LT(total[D - 1].value(), 0); // the water presses downwards
}

TYPED_TEST(InterfaceLoadsTest, AveragedPressureIsTheHydrostaticOneAtTheWall)
{
    constexpr int D = TypeParam::value;
    for (const int facets : {3, 10, 25}) { // larger than a patch, one dx, smaller than dx
        if (D == 3 && facets == 25) continue;
        WetPlate<D> cast(facets);
        cast.evaluate();
        InterfaceLoads<D> loads(cast.walls.settings(), true);
        const std::size_t count = cast.batch.facet_ids.size();
        loads.begin(cast.walls, count);
        loads.add(cast.particles, cast.walls, cast.forces.on_wall, 0.5);
        loads.add(cast.particles, cast.walls, cast.forces.on_wall, 0.5);
        const auto& result = loads.loads();
        for (std::size_t f = 0; f < count; ++f) {
            ASSERT_GT(result.weight[f].value(), 0);
            const double pressure = result.weighted_pressure[f].value() / result.weight[f].value();
            EXPECT_NEAR(pressure, 1000 * gravity * cast.depth, 0.002 * 1000 * gravity * cast.depth);
            const double coverage = result.weight[f].value() / result.full_weight[f];
            EXPECT_GT(coverage, 0.5) << f << " of " << facets;
            EXPECT_LT(coverage, 1.5) << f << " of " << facets;
        }
    }
}

TYPED_TEST(InterfaceLoadsTest, AcceleratedPlateFeelsTheAcceleratedHead)
{
    constexpr int D = TypeParam::value;
    WetPlate<D> cast(5);
    for (std::size_t n = 0; n < cast.batch.node_ids.size(); ++n) cast.batch.motion.acceleration[n * D + D - 1] = 20;
    cast.evaluate();
    InterfaceLoads<D> loads(cast.walls.settings(), true);
    loads.begin(cast.walls, cast.batch.facet_ids.size());
    loads.add(cast.particles, cast.walls, cast.forces.on_wall, 1.0);
    // particles at height 0.5 only: p* = p + rho (g + a) 0.5
    const double pressure = loads.loads().weighted_pressure[0].value() / loads.loads().weight[0].value();
    EXPECT_NEAR(pressure, 1000 * (gravity * 10 + 20 * 0.5), 300);
}

} // namespace
} // namespace sph
