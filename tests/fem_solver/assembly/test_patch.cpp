// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/material/split_law.hpp"
#include "tests/fem_solver/support/distorted_block.hpp"
#include "tests/fem_solver/support/record.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

constexpr double young = 12e6;

struct Choice {
    ElementType type;
    BodySettings settings;
};

class Patch : public testing::TestWithParam<Choice> {
protected:
    Mesh mesh_ = distorted_block(GetParam().type);
    MatrixPattern pattern_{mesh_};

    std::unique_ptr<SolidBody> body(const Law& law)
    {
        return make_solid_body(mesh_, pattern_, {law, 1100}, GetParam().settings);
    }

    Eigen::MatrixXd gradient(double size) const
    {
        Eigen::MatrixXd h(3, 3);
        h << 0.2, 0.1, -0.1, 0.05, -0.15, 0.1, 0.1, 0.05, 0.1;
        return size * h.topLeftCorner(mesh_.dimension, mesh_.dimension);
    }

    /// Largest force on an inner node.
    double inner_force(const Eigen::VectorXd& force) const
    {
        double largest = 0;
        for (int i = 0; i < mesh_.nodes(); ++i) {
            bool inner = true;
            for (int k = 0; k < mesh_.dimension; ++k)
                inner = inner && mesh_.node(i)[k] > 1e-9 && mesh_.node(i)[k] < 1 - 1e-9;
            if (inner) largest = std::max(largest, force.segment(i * mesh_.dimension, mesh_.dimension).norm());
        }
        return largest;
    }
};

TEST_P(Patch, ConstantStrainIsInEquilibriumOnADistortedMesh)
{
    const Lame lame = Lame::from_young(young, 0.4);
    double worst = 0;
    for (const Law& law : {Law(SmallElastic{lame}), Law(SaintVenantKirchhoff{lame}), Law(NeoHookean{lame}),
                           Law(mooney_rivlin(0.3 * lame.mu, 0.2 * lame.mu, lame.bulk()))}) {
        if (GetParam().settings.formulation == Formulation::mixed && !split(law)) continue;
        const auto solid = body(law);
        Eigen::VectorXd force = Eigen::VectorXd::Zero(std::ssize(mesh_.coordinates));
        EXPECT_FALSE(solid->add_internal_force(linear_field(mesh_, gradient(1)), force).happened());
        EXPECT_GT(force.cwiseAbs().maxCoeff(), 1e-3 * young);
        EXPECT_LT(inner_force(force), 1e-10 * young);
        worst = std::max(worst, inner_force(force) / young);
    }
    record("patch_" + std::string(name_of(GetParam().type)), worst);
}

TEST_P(Patch, StressOfConstantStrainIsTheLawsOwn)
{
    const NeoHookean law{Lame::from_young(young, 0.4)};
    const auto stress = body(law)->stress(linear_field(mesh_, gradient(1)));
    Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
    f.topLeftCorner(mesh_.dimension, mesh_.dimension) += gradient(1);
    const Eigen::Matrix3d expected = cauchy_stress<NeoHookean, 3>(law, f);
    double worst = 0;
    for (int e = 0; e < mesh_.elements(); ++e)
        for (int i = 0; i < 9; ++i) worst = std::max(worst, std::abs(stress[9 * e + i] - expected(i / 3, i % 3)));
    EXPECT_LT(worst, 1e-10 * young);
    record("patch_stress", worst / young);
}

TEST_P(Patch, RigidRotationBringsNoForce)
{
    Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.2, Eigen::Vector3d(0, 0, 1)).toRotationMatrix();
    if (mesh_.dimension == 3)
        rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 0.4, 0).normalized()).toRotationMatrix() * rotation;
    const Eigen::MatrixXd h = (rotation - Eigen::Matrix3d::Identity()).topLeftCorner(mesh_.dimension, mesh_.dimension);
    const auto solid = body(NeoHookean{Lame::from_young(young, 0.4)});
    Eigen::VectorXd force = Eigen::VectorXd::Zero(std::ssize(mesh_.coordinates));
    solid->add_internal_force(linear_field(mesh_, h), force);
    EXPECT_LT(force.cwiseAbs().maxCoeff(), 1e-10 * young);
}

TEST_P(Patch, MassIsThatOfTheBody)
{
    Matrix mass = pattern_.zero();
    body(NeoHookean{Lame::from_young(young, 0.4)})->add_mass(mass);
    Eigen::VectorXd one = Eigen::VectorXd::Zero(mass.rows());
    for (Eigen::Index i = 0; i < one.size(); i += mesh_.dimension) one[i] = 1;
    EXPECT_NEAR(one.dot(mass * one), 1100, 1e-9);
    EXPECT_NEAR(one.dot(mass * positions(mesh_)), 550, 1e-9); // first moment along x of the unit block
}

TEST_P(Patch, AnInsideOutElementIsNamed)
{
    Eigen::VectorXd u = linear_field(mesh_, Eigen::MatrixXd::Zero(mesh_.dimension, mesh_.dimension));
    const int node = mesh_.connectivity[0];
    for (int k = 0; k < mesh_.dimension; ++k) u[node * mesh_.dimension + k] = 0.8;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(u.size());
    EXPECT_EQ(body(NeoHookean{Lame::from_young(young, 0.4)})->add_internal_force(u, force).element, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Elements, Patch,
    testing::Values(Choice{ElementType::quad4, {false, Formulation::standard}}, Choice{ElementType::quad4, {}},
                    Choice{ElementType::quad4, {false, Formulation::mixed}}, Choice{ElementType::quad8, {}},
                    Choice{ElementType::quad8, {true, Formulation::standard}},
                    Choice{ElementType::quad9, {false, Formulation::standard}}, Choice{ElementType::quad9, {}},
                    Choice{ElementType::tri3, {}}, Choice{ElementType::tri6, {}},
                    Choice{ElementType::tri6, {false, Formulation::mixed}}, Choice{ElementType::hexa8, {}},
                    Choice{ElementType::hexa8, {false, Formulation::mixed}}, Choice{ElementType::hexa20, {}},
                    Choice{ElementType::hexa27, {false, Formulation::standard}}, Choice{ElementType::hexa27, {}},
                    Choice{ElementType::tet4, {}}, Choice{ElementType::tet10, {}},
                    Choice{ElementType::tet10, {false, Formulation::mixed}}));

} // namespace
