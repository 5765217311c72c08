// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/sparse_matrix.hpp"
#include "fem_solver/material/material.hpp"

#include <memory>

namespace fem {

/// Where a deformation turned an element inside out; `element` is -1 when none is here.
struct Inversion {
    int element = -1;
    double determinant = 1; ///< det F there
    bool elsewhere = false; ///< on another rank

    bool happened() const { return element >= 0 || elsewhere; }
};

/// How elements are kept from locking.
enum class Formulation {
    automatic, ///< enhanced for Quad4 and Hexa8, mixed for Quad9 and Hexa27 with a law that allows it, else standard
    standard,  ///< displacements alone
    enhanced,  ///< Quad4, Hexa8: modes that cure locking in bending and in volume, see enhanced_gradients
    mixed      ///< with a pressure field, against locking near incompressibility, see MixedBody
};

/// Choices of the element formulation.
struct BodySettings {
    bool full_integration = false; ///< Quad8/Hexa20: 3 points per direction instead of 2
    Formulation formulation = Formulation::automatic;
};

/// The deformable body: all elements with their material, total Lagrangian.
///
/// Displacements and forces are vectors over all nodes, entry `node * dimension + component`.
class SolidBody {
public:
    virtual ~SolidBody() = default;

    /// Internal force f_a = integral of P grad N_a dV [N] (2D: N/m), added to `force`.
    /// With finite kinematics it stops at the first point with det F <= 0 and says where.
    virtual Inversion add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) = 0;
    /// Stiffness K_ab = integral of grad N_a (dP/dF) grad N_b dV, added to `matrix`.
    virtual void add_stiffness(const Eigen::VectorXd& displacement, Matrix& matrix) = 0;
    /// Consistent mass M_ab = integral of rho N_a N_b dV [kg] (2D: kg/m), added to `matrix`.
    virtual void add_mass(Matrix& matrix) const = 0;
    /// Strain energy of this rank's own elements, integral of w(F) dV [J] (2D: J/m): what can be had back of it.
    virtual double strain_energy(const Eigen::VectorXd& displacement) = 0;
    /// What the material of these elements has taken for good [J] (2D: J/m).
    virtual double lost_energy() const { return 0; }
    /// Remembers a displacement that has come about, where the material has a memory.
    virtual void accept(const Eigen::VectorXd&) {}
    /// Cauchy stress, mean over each element's integration points [Pa]: 9 numbers per own element, row by row.
    virtual std::vector<double> stress(const Eigen::VectorXd& displacement) = 0;
};

/// \param pattern outlives the body.
std::unique_ptr<SolidBody> make_solid_body(const Mesh& mesh, const MatrixPattern& pattern, const Material& material,
                                           const BodySettings& settings);

} // namespace fem
