// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/setup/formulation.hpp"
#include "fem_solver/setup/solid_model.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace {

using namespace fem;

const std::string valid = R"([model]
dimension = 2
[mesh]
low = [0.0, 0.0]
high = [1.0, 2.0]
cells = [2, 4]
element = "quad4"
[material.rubber]
law = "neo_hookean"
E = 1e6
nu = 0.3
density = 1000
[[supports]]
group = "bottom"
fix = ["x", "y"]
[[loads]]
kind = "traction"
group = "top"
traction = [3.0, 0.0]
)";

SolidConfig read(const std::string& text)
{
    base::ConfigReader reader(base::ConfigDocument::parse(text, "solid.toml"));
    return read_solid_config(reader);
}

std::string replaced(const std::string& from, const std::string& to)
{
    std::string text = valid;
    return text.replace(text.find(from), from.size(), to);
}

void expect_error(const std::string& text, const std::string& part)
{
    try {
        SolidModel model(read(text));
        ADD_FAILURE() << "no error; wanted: " << part;
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(SolidConfig, BecomesAModel)
{
    const SolidConfig config = read(valid);
    EXPECT_EQ(config.material_name, "rubber");
    EXPECT_EQ(config.time.alpha, -0.05);
    const SolidModel model(config);
    EXPECT_EQ(model.mesh().nodes(), 15);
    Forces forces = Forces::zero(model.forces().dofs());
    model.forces().evaluate(Motion::at_rest(model.forces().dofs()), 1, forces);
    EXPECT_NEAR(forces.loads.sum(), 3.0, 1e-14);
    EXPECT_TRUE(model.supports().fixed(0));
    EXPECT_FALSE(model.supports().fixed(29));
}

TEST(SolidConfig, DrivesAndPressuresAreFormulas)
{
    const SolidModel model(read(valid + R"([[drives]]
group = "top"
centre = [0.5, 2.0]
x = "0.1*t"
angle = "pi/2*t"
[[loads]]
kind = "pressure"
group = "left"
pressure = "2 + 3*y"
)"));
    Motion motion = Motion::at_rest(model.forces().dofs());
    model.supports().set_motion(1, motion);
    const int corner = 2 * model.mesh().nearest_node({1, 2}); // turned by a right angle: from (0.5, 0) to (0, 0.5)
    EXPECT_NEAR(motion.displacement[corner], 0.1 - 0.5, 1e-12);
    EXPECT_NEAR(motion.displacement[corner + 1], 0.5, 1e-12);
    Forces forces = Forces::zero(model.forces().dofs());
    model.forces().evaluate(Motion::at_rest(model.forces().dofs()), 1, forces);
    EXPECT_NEAR(forces.each_load[1].sum(), 2 * 2 + 3 * 2, 1e-12);
}

TEST(SolidConfig, HoldsPlanesOfSymmetry)
{
    const std::string symmetry = replaced("fix = [\"x\", \"y\"]", "symmetry = true");
    const SolidModel model(read(symmetry)); // bottom, across y
    for (const int node : model.mesh().group_nodes("bottom")) {
        EXPECT_FALSE(model.supports().fixed(2 * node));
        EXPECT_TRUE(model.supports().fixed(2 * node + 1));
    }
    std::string around = symmetry;
    expect_error(around.replace(around.find("\"bottom\""), 8, "\"all\""), "extends along all of them, over 1 m");
    expect_error(replaced("fix = [\"x\", \"y\"]", "symmetry = false"), "symmetry = true");
}

TEST(SolidConfig, WarnsOfLocking)
{
    const auto warning = [](ElementType type, const std::string& mesh, double nu) {
        SolidConfig config = read(replaced("element = \"quad4\"", "element = \"quad4\"\n" + mesh));
        config.material.poisson = nu;
        return locking_warning(type, config);
    };
    EXPECT_EQ(warning(ElementType::quad4, "", 0.3), "");
    EXPECT_EQ(warning(ElementType::quad8, "", 0.4), "");
    EXPECT_EQ(warning(ElementType::tri6, "", 0.4), "");
    EXPECT_EQ(warning(ElementType::quad9, "formulation = \"mixed\"", 0.4999), "");
    EXPECT_NE(warning(ElementType::quad4, "formulation = \"standard\"", 0.3).find("\"automatic\""), std::string::npos);
    EXPECT_NE(warning(ElementType::quad8, "integration = \"full\"", 0.3).find("\"reduced\""), std::string::npos);
    EXPECT_NE(warning(ElementType::tet4, "", 0.3).find("ten nodes"), std::string::npos);
    EXPECT_NE(warning(ElementType::quad9, "formulation = \"standard\"", 0.4999).find("\"mixed\""), std::string::npos);
    EXPECT_NE(warning(ElementType::quad8, "", 0.499).find("quad9"), std::string::npos);
    EXPECT_NE(warning(ElementType::tet10, "", 0.4999).find("nu = 0.4999"), std::string::npos);
}

TEST(SolidConfig, DescribesItself)
{
    base::ConfigReader reader = base::ConfigReader::describe();
    read_solid_config(reader);
    EXPECT_NE(reader.help().find("stiffness"), std::string::npos);
}

TEST(SolidConfig, NamesWhatIsWrong)
{
    expect_error(replaced("nu = 0.3", "nu = 0.5"), "nu");
    expect_error(valid + "[[drives]]\ngroup = \"top\"\ncentre = [1.0]\n", "drives.0.centre has 1 numbers");
    expect_error(valid + "[[drives]]\ngroup = \"top\"\ncentre = [1.0, 0.0]\naxis = [0.0, 0.0, 1.0]\n", "turns about z");
    expect_error(valid + "[[drives]]\ngroup = \"lid\"\ncentre = [1.0, 0.0]\n", "lid");
    expect_error(replaced("E = 1e6", "E = -1e6"), "E");
    expect_error(replaced("cells = [2, 4]", "cells = [2.5, 4]"), "no number of cells");
    expect_error(replaced("high = [1.0, 2.0]", "high = [1.0, -2.0]"), "is not below high");
    expect_error(replaced("element = \"quad4\"", "element = \"hexa8\""), "does not belong");
    expect_error(replaced("group = \"bottom\"", "group = \"botom\""), "no group 'botom'");
    expect_error(replaced("nu = 0.3", "nu = 0.3\nkinematic = \"small\""), "kinematic");
    expect_error(replaced("law = \"neo_hookean\"", "law = \"neo_hookean\"\nkinematics = \"small\""),
                 "small kinematics");
    expect_error(replaced("traction = [3.0, 0.0]", "traction = [3.0]"), "needs 2");
    expect_error(replaced("[material.rubber]", "[material.other]\nE = 1\nnu = 0\ndensity = 1\n[material.rubber]"),
                 "one table [material.NAME]");
}

std::string with_law(const std::string& keys) { return replaced("law = \"neo_hookean\"\nE = 1e6\nnu = 0.3", keys); }

TEST(SolidConfig, KnowsTheLawsOfRubber)
{
    const auto law = [](const std::string& keys) { return make_material(read(with_law(keys)).material).law; };
    const auto mr = std::get<Ogden>(law("law = \"mooney_rivlin\"\nc10 = 1.6e6\nc01 = 0.4e6\nnu = 0.4"));
    EXPECT_NEAR(mr.shear_modulus(), 4e6, 1e-6);
    EXPECT_NEAR(mr.bulk, 2 * 4e6 * 1.4 / 0.6, 1e-6);
    EXPECT_EQ(
        std::get<Ogden>(law("law = \"ogden\"\nmu = [3e6, 1e6]\nalpha = [1.3, -2.0]\nnu = 0.4")).shape.terms.size(), 2u);
    const std::string path = testing::TempDir() + "rivage_curve.csv";
    std::ofstream(path) << "# made up\nstrain[-],stress[Pa]\n0.1,1.0e6\n0.5,3.0e6\n";
    const auto marlow = std::get<Marlow>(law("law = \"marlow\"\ncurve = \"" + path + "\"\nnu = 0.49"));
    EXPECT_EQ(marlow.shape.curve->last_strain(), 0.5);
}

TEST(SolidConfig, MovesSupportsAndLoadsOverTime)
{
    const SolidModel model(read(valid + R"toml(factor = "sin(2*t)"
name = "pull"
[[loads]]
kind = "spring"
group = "right"
stiffness = [5.0, 0.0]
[[loads]]
kind = "nodal_force"
group = "left"
force = [0.0, 1.0]
[[supports]]
group = "top"
uy = "0.1*t^2*(y - 1)"
)toml"));
    EXPECT_EQ(model.forces().load_names(), (std::vector<std::string>{"pull", "load2", "load3"}));
    Motion motion = Motion::at_rest(model.forces().dofs());
    model.supports().set_motion(2.0, motion);
    EXPECT_NEAR(motion.displacement.sum(), 3 * 0.4, 1e-12);
    EXPECT_NEAR(motion.velocity.sum(), 3 * 0.4, 1e-9);
    EXPECT_NEAR(motion.acceleration.sum(), 3 * 0.2, 1e-6);
    Forces forces = Forces::zero(model.forces().dofs());
    motion.displacement.setConstant(0.1);
    model.forces().evaluate(motion, 1, forces, 0.5);
    EXPECT_NEAR(forces.each_load[0].sum(), 3 * std::sin(1.0), 1e-12);
    EXPECT_NEAR(forces.each_load[1].sum(), -5 * 2 * 0.1, 1e-12);
    EXPECT_NEAR(forces.each_load[2].sum(), 5, 1e-12); // five nodes on the left
}

/// A pulled strip whose foot may narrow: exact in plane stress, sigma = E eps for small strain, and thinner by nu eps.
TEST(SolidConfig, PlaneStressFreesTheFaces)
{
    std::string text = replaced("dimension = 2", "dimension = 2\nassumption = \"plane_stress\"");
    text.replace(text.find("law = \"neo_hookean\""), 19, "law = \"elastic\"\nkinematics = \"small\"");
    const SolidModel model(read(text));
    Eigen::VectorXd u(model.forces().dofs());
    for (int i = 0; i < model.mesh().nodes(); ++i) {
        u[2 * i] = -0.3e-3 * model.mesh().node(i)[0];
        u[2 * i + 1] = 1e-3 * model.mesh().node(i)[1];
    }
    const auto stress = model.forces().body().stress(u);
    EXPECT_NEAR(stress[0], 0, 1e-6);
    EXPECT_NEAR(stress[4], 1e6 * 1e-3, 1e-6);
    EXPECT_NEAR(stress[8], 0, 1e-6);
    std::string mixed = text;
    mixed.replace(mixed.find("element = \"quad4\""), 17, "element = \"quad9\"\nformulation = \"mixed\"");
    expect_error(mixed, "needs plane strain or 3D");
}

TEST(SolidConfig, NamesWhatALoadOrSupportLacks)
{
    expect_error(valid + "[[supports]]\ngroup = \"top\"\n", "needs fix");
    expect_error(valid + "[[supports]]\ngroup = \"top\"\nfix = [\"x\"]\nux = \"t\"\n", "give one of them");
    expect_error(valid + "[[supports]]\ngroup = \"top\"\nuz = \"t\"\n", "dimension 2");
    expect_error(valid + "[[supports]]\ngroup = \"top\"\nux = \"2*q\"\n", "q");
    expect_error(valid + "[[loads]]\nkind = \"spring\"\ngroup = \"top\"\n", "needs 2");
    expect_error(valid + "[[loads]]\nkind = \"nodal_force\"\nforce = [1.0, 0.0]\n", "group or a position");
}

TEST(SolidConfig, NamesWhatALawLacks)
{
    expect_error(with_law("law = \"neo_hookean\"\nnu = 0.3"), "E [Pa] above zero");
    expect_error(with_law("law = \"mooney_rivlin\"\nnu = 0.3"), "c10 and c01");
    expect_error(with_law("law = \"ogden\"\nmu = [1e6]\nnu = 0.3"), "as many of both");
    expect_error(with_law("law = \"ogden\"\nmu = [1e6]\nalpha = [0.0]\nnu = 0.3"), "not zero");
    expect_error(with_law("law = \"marlow\"\nnu = 0.3"), "curve = ");
    expect_error(with_law("law = \"marlow\"\ncurve = \"missing.csv\"\nnu = 0.3"), "missing.csv");
    expect_error(with_law("law = \"neo_hookean\"\nE = 1e6\nnu = 0.3\nstability_range = [1.5, 2.0]"), "stability_range");
    expect_error(with_law("law = \"neo_hookean\"\nE = 1e6\nnu = 0.3\nsoftening_r = 0.5\nsoftening_m = 1e3"),
                 "softening_r = 0.5");
    expect_error(with_law("law = \"neo_hookean\"\nE = 1e6\nnu = 0.3\nsoftening_r = 2.0"), "softening_m");
}

} // namespace
