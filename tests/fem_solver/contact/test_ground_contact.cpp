// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/contact/ground_contact.hpp"
#include "fem_solver/time/solid_step.hpp"
#include "fem_solver/time/static_solution.hpp"
#include "tests/fem_solver/support/distorted_block.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace fem;

constexpr double young = 12e6;

/// A block over a ground, with what it needs to be computed.
struct Block {
    Mesh mesh;
    SolidForces forces;
    Supports supports{mesh};
    GroundContact* contact = nullptr;

    Block(Mesh given, const Law& law, const BodySettings& settings = {})
        : mesh(std::move(given)), forces(mesh, {law, 1100}, settings)
    {}

    void touch(std::unique_ptr<base::Ground> ground, double friction, bool augmented,
               const std::string& group = "bottom")
    {
        ContactSettings settings;
        settings.group = group;
        settings.augmented = augmented;
        settings.constants.normal_penalty = 10 * surface_stiffness(contact_points(mesh, mesh.faces(group)),
                                                                   forces.initial_stiffness().diagonal(), mesh);
        settings.constants.tangential_penalty = settings.constants.normal_penalty;
        settings.constants.friction = friction;
        settings.tolerance = 1e-9;
        auto made = std::make_unique<GroundContact>(mesh, forces.pattern(), std::move(ground), settings,
                                                    contact_points(mesh, mesh.faces(group)));
        contact = made.get();
        forces.set_contact(std::move(made));
    }
};

class ContactPatch : public testing::TestWithParam<ElementType> {};

/// A distorted block under uniform pressure stands on a plane: the contact gives the same pressure everywhere.
TEST_P(ContactPatch, TransmitsAUniformPressure)
{
    const double pressure = 1e4;
    const int d = dimension_of(GetParam());
    Block block(fem_test::distorted_block(GetParam()), SmallElastic{Lame::from_young(young, 0.3)});
    block.supports.fix("left", {"x"});
    if (d == 3) block.supports.fix("back", {"z"});
    const Eigen::Vector3d up = Eigen::Vector3d::Unit(1);
    block.touch(base::make_plane({0, 0, 0}, up), 0, true);
    block.forces.add_load(make_follower_pressure(block.mesh, block.forces.pattern(), block.mesh.faces("top"),
                                                 [&](const double*) { return pressure; }));
    Motion motion = Motion::at_rest(block.forces.dofs());
    StaticSolution(block.mesh, block.forces, block.supports, {1e-13, 40, 0.1}).solve(motion, 1, [](double) {});
    const ContactResultants sum = block.contact->resultants(motion, 1);
    EXPECT_NEAR(sum.normal[1] / sum.area, pressure, 1e-10 * pressure);
    std::vector<double> at_nodes(static_cast<std::size_t>(block.mesh.nodes()), 0.0), slip = at_nodes;
    block.contact->add_fields(motion, 1, at_nodes, slip);
    for (const ContactPoint& point : contact_points(block.mesh, block.mesh.faces("bottom")))
        for (const int node : point.nodes)
            EXPECT_NEAR(at_nodes[static_cast<std::size_t>(node)] * sum.area, sum.normal[1], 1e-10 * pressure);
}

INSTANTIATE_TEST_SUITE_P(EveryType, ContactPatch,
                         testing::Values(ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                         ElementType::quad9, ElementType::tet4, ElementType::tet10, ElementType::hexa8,
                                         ElementType::hexa20, ElementType::hexa27),
                         [](const auto& info) { return name_of(info.param); });

/// The assembled tangent is the difference quotient of the forces, on hills, with friction, sticking and slipping points.
TEST(GroundContact, TangentIsTheDifferenceQuotient)
{
    Block block(make_block({ElementType::hexa8, {0, 0, 0}, {1, 1, 0.3}, {3, 3, 1}}),
                SmallElastic{Lame::from_young(young, 0.3)});
    block.touch(base::make_height_ground(base::make_height_formula({"0.05*sin(3*x)*cos(2*y)"}, 3, 1e-4), 3), 0.3, false,
                "back");
    Motion motion = Motion::at_rest(block.forces.dofs());
    for (Eigen::Index i = 0; i < motion.displacement.size(); ++i)
        motion.displacement[i] = (i % 3 == 2 ? -0.05 : 0.03) + 0.01 * std::sin(5.0 * static_cast<double>(i));
    Matrix tangent = block.forces.pattern().zero();
    block.contact->add_tangent(motion, 0, tangent);
    const auto force = [&] {
        Eigen::VectorXd normal = Eigen::VectorXd::Zero(block.forces.dofs()), friction = normal;
        block.contact->add_force(motion, 0, normal, friction);
        return Eigen::VectorXd(normal + friction);
    };
    const double h = 1e-7, scale = Eigen::MatrixXd(tangent).cwiseAbs().maxCoeff();
    ASSERT_GT(scale, 0);
    for (int k = 0; k < block.forces.dofs(); ++k) {
        const double there = motion.displacement[k];
        motion.displacement[k] = there + h;
        const Eigen::VectorXd up = force();
        motion.displacement[k] = there - h;
        const Eigen::VectorXd quotient = (force() - up) / (2 * h); // -d force/du
        motion.displacement[k] = there;
        EXPECT_LT((Eigen::VectorXd(tangent.col(k)) - quotient).cwiseAbs().maxCoeff(), 1e-5 * scale) << k;
    }
}

/// A block pushed over hills in small steps: at every step friction is mu times the pressure's force where all points slip.
TEST(GroundContact, SlidesOverHillsWithCoulombsForce)
{
    const double mu = 0.3;
    Block block(make_block({ElementType::hexa8, {0, 0, 0}, {0.02, 0.02, 0.01}, {4, 4, 2}}),
                NeoHookean{Lame::from_young(5e6, 0.45)});
    block.touch(base::make_height_ground(base::make_height_formula({"0.0003*sin(800*x)*cos(700*y)"}, 3, 1e-6), 3), mu,
                true, "back");
    block.supports.prescribe("front", "x", [](const double*) -> base::TimeFunction {
        return [](double t) -> base::TimeValue { return {0.01 * t, 0.01, 0}; };
    });
    block.supports.fix("front", {"y"});
    block.supports.prescribe("front", "z", [](const double*) -> base::TimeFunction {
        return [](double t) -> base::TimeValue { return {-0.0006 * std::min(1.0, 10 * t), 0, 0}; };
    });
    Motion motion = Motion::at_rest(block.forces.dofs());
    StaticSolution solution(block.mesh, block.forces, block.supports, {1e-9, 60, 0.1});
    double last = 0;
    solution.solve(motion, 60, [&](double factor) {
        const ContactResultants sum = block.contact->resultants(motion, factor);
        if (factor > 0.6) {
            EXPECT_GT(sum.normal[2], 0);
            EXPECT_LT(sum.friction[0], 0);
            EXPECT_NEAR(sum.friction.norm() / (mu * sum.normal.norm()), 1, 0.05);
        }
        last = factor;
    });
    EXPECT_EQ(last, 1);
}

/// A bar hits a wall (nu = 0): p = rho c v for 2 L/c, then it flies back; the ledger closes.
TEST(GroundContact, BarHitsAWall)
{
    Block bar(make_block({ElementType::quad4, {0, 0}, {0.01, 0.1}, {1, 50}}), SmallElastic{Lame::from_young(young, 0)});
    bar.touch(base::make_plane({0, 0, 0}, {0, 1, 0}), 0, false);
    Motion motion = Motion::at_rest(bar.forces.dofs());
    for (Eigen::Index i = 1; i < motion.velocity.size(); i += 2) motion.velocity[i] = -1;
    StepSettings settings;
    settings.newton = {1e-12, 40, 0.1};
    SolidStep step(bar.mesh, bar.forces, bar.supports, Hht(-0.1), settings);
    step.start(motion);
    const double dt = 1e-5;
    double impulse = 0, off = 0;
    for (int k = 1; k <= 300; ++k) {
        step.advance(motion, dt);
        const double force = bar.contact->resultants(motion, k * dt).normal[1];
        impulse += dt * force;
        if (force > 0) off = k * dt;
    }
    EXPECT_NEAR(impulse, 2 * 1100 * 0.01 * 0.1, 0.02 * 2.2);
    EXPECT_NEAR(off, 1.914854e-3, 0.02 * 1.914854e-3);
    EXPECT_LT(std::abs(step.energies().balance_error), 1e-12);
    EXPECT_NEAR(step.energies().total(), 0.55, 0.02 * 0.55);
}

/// Friction and its work on a moving ground: a resting block is carried along, sticking.
TEST(GroundContact, MovingGroundCarriesABlock)
{
    Block block(make_block({ElementType::quad4, {0, 0}, {0.1, 0.02}, {4, 1}}), SmallElastic{Lame::from_young(1e8, 0)});
    ContactSettings settings;
    settings.group = "bottom";
    settings.constants = {1e12, 1e12, 0.5};
    settings.augmented = false;
    settings.ground_motion = [](double t) { return Eigen::Vector3d(0.5 * t * t, 0, 0); }; // 1 m/s^2 < mu g
    auto contact =
        std::make_unique<GroundContact>(block.mesh, block.forces.pattern(), base::make_plane({0, 0, 0}, {0, 1, 0}),
                                        settings, contact_points(block.mesh, block.mesh.faces("bottom")));
    block.forces.set_contact(std::move(contact));
    block.forces.set_gravity({0, -9.81});
    Motion motion = Motion::at_rest(block.forces.dofs());
    StepSettings step_settings;
    step_settings.newton = {1e-10, 40, 0.1};
    SolidStep step(block.mesh, block.forces, block.supports, Hht(-0.3), step_settings);
    step.start(motion);
    for (int k = 0; k < 200; ++k) step.advance(motion, 1e-3);
    EXPECT_NEAR(motion.displacement[0], 0.5 * 0.04, 2e-5);
    EXPECT_NEAR(step.energies().friction, -step.energies().kinetic, 0.02 * step.energies().kinetic);
}

} // namespace
