// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/impedance_load.hpp"
#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/assembly/surface_traction.hpp"
#include "fem_solver/mesh/linear_facets.hpp"
#include "tests/fem_solver/support/distorted_block.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

/// Smooth, large motion without a pattern.
Motion wavy_motion(const Mesh& mesh)
{
    Motion motion = Motion::at_rest(std::ssize(mesh.coordinates));
    const int d = mesh.dimension;
    for (int i = 0; i < mesh.nodes(); ++i)
        for (int k = 0; k < d; ++k) {
            const double *x = mesh.node(i), next = x[(k + 1) % d];
            motion.displacement[i * d + k] = 0.1 * std::sin(2.5 * next + x[k] + k);
            motion.velocity[i * d + k] = std::cos(2 * next - x[k] + k);
        }
    return motion;
}

/// Compares the tangent's action on a direction with the difference quotient of the unbalanced force, dv = slope du.
void expect_tangent_matches(const Mesh& mesh, const SolidForces& forces, double tolerance)
{
    const Motion motion = wavy_motion(mesh);
    const double slope = 37, h = 1e-6;
    Eigen::VectorXd direction(motion.displacement.size());
    for (Eigen::Index i = 0; i < direction.size(); ++i) direction[i] = std::sin(1.0 + 2.3 * static_cast<double>(i));
    const auto unbalanced = [&](double step) {
        Motion moved = motion;
        moved.displacement += step * direction;
        moved.velocity += step * slope * direction;
        Forces result = Forces::zero(forces.dofs());
        EXPECT_FALSE(forces.evaluate(moved, 0.8, result).happened());
        return result.unbalanced();
    };
    const Eigen::VectorXd quotient = (unbalanced(h) - unbalanced(-h)) / (2 * h);
    const Eigen::VectorXd product = forces.tangent(motion, {0, 1, slope, 0.8}) * direction;
    EXPECT_LT((quotient - product).norm(), tolerance * product.norm());
    EXPECT_GT(product.norm(), 0);
}

class Tangents : public testing::TestWithParam<std::pair<ElementType, Formulation>> {
protected:
    BodySettings settings_{false, GetParam().second};
    Mesh mesh_ = distorted_block(GetParam().first);
    SolidForces stiff_{mesh_, {NeoHookean{Lame::from_young(100, 0.4)}, 1}, settings_};
    SolidForces soft_{mesh_, {NeoHookean{Lame::from_young(1e-9, 0.4)}, 1}, settings_}; // only the loads matter
};

TEST_P(Tangents, OfTheBody) { expect_tangent_matches(mesh_, stiff_, 1e-8); }

TEST_P(Tangents, OfFollowerPressure)
{
    soft_.add_load(
        make_follower_pressure(mesh_, soft_.pattern(), mesh_.faces("left"), [](const double* x) { return 2 + x[1]; }));
    expect_tangent_matches(mesh_, soft_, 1e-8);
}

TEST_P(Tangents, OfFollowerTraction)
{
    const std::vector<double> traction{0.7, -1.3, 0.4};
    soft_.add_load(make_follower_traction(mesh_, soft_.pattern(), mesh_.faces("top"),
                                          {traction.begin(), traction.begin() + mesh_.dimension}));
    expect_tangent_matches(mesh_, soft_, 1e-8);
}

/// Carried along by a rigid turn, the traction turns with the body.
TEST_P(Tangents, FollowerTractionTurnsWithTheBody)
{
    const int d = mesh_.dimension;
    const std::vector<double> traction{0.7, -1.3, 0.4};
    const auto load =
        make_follower_traction(mesh_, soft_.pattern(), mesh_.faces("right"), {traction.begin(), traction.begin() + d});
    Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(d, d);
    turn.topLeftCorner(2, 2) << std::cos(0.8), -std::sin(0.8), std::sin(0.8), std::cos(0.8);
    Motion motion = Motion::at_rest(soft_.dofs());
    motion.displacement = linear_field(mesh_, turn - Eigen::MatrixXd::Identity(d, d));
    Eigen::VectorXd force = Eigen::VectorXd::Zero(soft_.dofs());
    load->add_force(motion, 1, force);
    const Eigen::VectorXd sum = force.reshaped(d, mesh_.nodes()).rowwise().sum();
    EXPECT_LT((sum - turn * Eigen::Map<const Eigen::VectorXd>(traction.data(), d)).norm(), 1e-13);
}

TEST_P(Tangents, OfSprings)
{
    soft_.add_load(std::make_unique<Springs>(
        spring_stiffness(mesh_, soft_.pattern(), mesh_.faces("top"), std::vector<double>(mesh_.dimension, 3.0))));
    expect_tangent_matches(mesh_, soft_, 1e-8);
}

TEST_P(Tangents, OfPressureOnFacets)
{
    const auto facets = linear_facets(mesh_, mesh_.faces("all"));
    auto load = std::make_unique<FacetPressure>(mesh_, soft_.pattern(), facets);
    std::vector<double> pressure;
    for (std::size_t f = 0; f < facets.size(); ++f) pressure.push_back(1 + 0.1 * static_cast<double>(f % 11));
    load->set(pressure);
    soft_.set_interface_load(std::move(load));
    expect_tangent_matches(mesh_, soft_, 1e-8);
}

TEST_P(Tangents, OfTheImpedance)
{
    const auto facets = linear_facets(mesh_, mesh_.faces("right"));
    auto load = std::make_unique<ImpedanceLoad>(mesh_, soft_.pattern(), facets);
    load->set(3, std::vector<char>(facets.size(), 1), wavy_motion(mesh_).displacement,
              Eigen::VectorXd::Zero(soft_.dofs()));
    soft_.set_correction(std::move(load));
    expect_tangent_matches(mesh_, soft_, 1e-8);
}

TEST_P(Tangents, OfDamping)
{
    soft_.set_damping({0.5, 2});
    expect_tangent_matches(mesh_, soft_, 1e-8);
}

/// A constant pressure on the whole closed surface pushes nowhere, however the body is deformed.
TEST_P(Tangents, ConstantPressureAllRoundHasNoResultant)
{
    const auto facets = linear_facets(mesh_, mesh_.faces("all"));
    FacetPressure load(mesh_, soft_.pattern(), facets);
    load.set(std::vector<double>(facets.size(), 5.0));
    Eigen::VectorXd force = Eigen::VectorXd::Zero(soft_.dofs());
    load.add_force(wavy_motion(mesh_), 1, force);
    for (int k = 0; k < mesh_.dimension; ++k) {
        double sum = 0;
        for (int i = 0; i < mesh_.nodes(); ++i) sum += force[i * mesh_.dimension + k];
        EXPECT_NEAR(sum, 0, 1e-12);
    }
    EXPECT_GT(force.cwiseAbs().maxCoeff(), 0.1);
}

/// A flat face that moves along its normal feels - rho c v per area; along itself nothing.
TEST_P(Tangents, ImpedanceActsAlongTheNormalOnly)
{
    const auto facets = linear_facets(mesh_, mesh_.faces("right"));
    ImpedanceLoad load(mesh_, soft_.pattern(), facets);
    load.set(3, std::vector<char>(facets.size(), 1), Eigen::VectorXd::Zero(soft_.dofs()),
             Eigen::VectorXd::Zero(soft_.dofs()));
    Motion motion = Motion::at_rest(soft_.dofs());
    motion.velocity.setConstant(2);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(soft_.dofs()), sum = Eigen::VectorXd::Zero(mesh_.dimension);
    load.add_force(motion, 1, force);
    for (int i = 0; i < mesh_.nodes(); ++i) sum += force.segment(i * mesh_.dimension, mesh_.dimension);
    EXPECT_NEAR(sum[0], -6, 1e-12);
    EXPECT_NEAR(sum.tail(mesh_.dimension - 1).norm(), 0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Elements, Tangents,
                         testing::Values(std::pair(ElementType::quad4, Formulation::enhanced),
                                         std::pair(ElementType::quad4, Formulation::mixed),
                                         std::pair(ElementType::quad8, Formulation::standard),
                                         std::pair(ElementType::quad9, Formulation::mixed),
                                         std::pair(ElementType::tri6, Formulation::standard),
                                         std::pair(ElementType::hexa8, Formulation::enhanced),
                                         std::pair(ElementType::hexa20, Formulation::standard),
                                         std::pair(ElementType::hexa27, Formulation::mixed),
                                         std::pair(ElementType::tet4, Formulation::standard),
                                         std::pair(ElementType::tet10, Formulation::mixed)));

} // namespace
