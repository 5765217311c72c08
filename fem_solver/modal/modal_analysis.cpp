// SPDX-License-Identifier: MIT
#include "fem_solver/modal/modal_analysis.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/solve/petsc_matrix.hpp"
#include "fem_solver/solve/petsc_session.hpp"

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fem {
namespace {

constexpr double tolerance = 1e-10;
/// The first shift, and what counts as a rigid motion's w^2, over trace K / trace M.
constexpr double relative_shift = 1e-8, relative_zero = 1e-12;

/// The tenth makes it a hundred times trace K / trace M, below which nothing lies.
constexpr int most_lowerings = 10;

/// K and M of the unknowns that are not held; held ones keep a diagonal in K and none in M, so that their w^2 is infinite.
struct Pencil {
    Matrix stiffness, mass;
    double scale = 0; ///< trace K / trace M [1/s^2]
};

Matrix loaded_tangent(const SolidForces& forces, const Motion& state, double load_factor)
{
    return forces.tangent(state, {0.0, 1.0, 0.0, load_factor, 0.0});
}

double trace(const DofMap& dofs, const Matrix& matrix)
{
    return dofs.team().sum(Eigen::VectorXd(matrix.diagonal()).head(dofs.own()).sum());
}

Pencil make_pencil(const SolidForces& forces, const Supports& supports, const Motion& state, double load_factor)
{
    const Matrix tangent = loaded_tangent(forces, state, load_factor);
    const Matrix transposed = tangent.transpose();
    Pencil pencil{0.5 * (tangent + transposed), forces.mass()};
    supports.clear(pencil.stiffness, tangent.diagonal().mean());
    supports.clear(pencil.mass, 0);
    pencil.scale = std::abs(trace(forces.map(), pencil.stiffness)) / trace(forces.map(), pencil.mass);
    return pencil;
}

/// SLEPc between its start and its end; PETSc runs before and after.
struct SlepcSession {
    SlepcSession() { require_petsc(SlepcInitialize(nullptr, nullptr, nullptr, nullptr), "start SLEPc"); }
    ~SlepcSession() { SlepcFinalize(); }
    SlepcSession(const SlepcSession&) = delete;
};

/// SLEPc's solver with what it stands on.
class EigenSolver {
public:
    EigenSolver(const Mesh& mesh, const DofMap& dofs, const Pencil& pencil, int count, double shift)
        : stiffness_(mesh, dofs, pencil.stiffness), mass_(mesh, dofs, pencil.stiffness)
    {
        stiffness_.set(pencil.stiffness);
        mass_.set(pencil.mass);
        require_petsc(EPSCreate(petsc_comm(dofs), &solver_), "make an eigensolver");
        require_petsc(EPSSetOperators(solver_, stiffness_.handle(), mass_.handle()), "take the matrices");
        EPSSetProblemType(solver_, EPS_GHEP);
        EPSSetDimensions(solver_, count, PETSC_DEFAULT, PETSC_DEFAULT);
        EPSSetTolerances(solver_, tolerance, 1000);
        EPSSetWhichEigenpairs(solver_, EPS_TARGET_MAGNITUDE);
        EPSSetTarget(solver_, shift);
        choose_inversion();
    }
    ~EigenSolver() { EPSDestroy(&solver_); }
    EigenSolver(const EigenSolver&) = delete;

    /// Sylvester: as many w^2 lie below the shift as K - shift M = L D L^T has negative pivots.
    int pairs_below_shift()
    {
        require_petsc(EPSSetUp(solver_), "factorise the stiffness");
        ST transformation = nullptr;
        KSP inverse = nullptr;
        PC preconditioner = nullptr;
        Mat factor = nullptr;
        PetscInt negative = 0;
        EPSGetST(solver_, &transformation);
        STGetKSP(transformation, &inverse);
        KSPGetPC(inverse, &preconditioner);
        require_petsc(PCFactorGetMatrix(preconditioner, &factor), "show the factors");
        require_petsc(MatGetInertia(factor, &negative, nullptr, nullptr), "count the pivots");
        return static_cast<int>(negative);
    }

    /// The number of pairs that converged: the nearest to the shift.
    int solve()
    {
        require_petsc(EPSSolve(solver_), "find the modes");
        PetscInt found = 0;
        EPSGetConverged(solver_, &found);
        return static_cast<int>(found);
    }

    /// w^2 and the shape of a pair, in ascending order of w^2.
    std::pair<double, Eigen::VectorXd> pair(int i) const
    {
        double value = 0;
        Vec vector = nullptr;
        require_petsc(MatCreateVecs(stiffness_.handle(), &vector, nullptr), "make a vector");
        EPSGetEigenpair(solver_, i, &value, nullptr, vector, nullptr);
        Eigen::VectorXd shape = stiffness_.get(vector);
        VecDestroy(&vector);
        return {value, shape};
    }

private:
    void choose_inversion()
    {
        ST transformation = nullptr;
        KSP inverse = nullptr;
        PC preconditioner = nullptr;
        EPSGetST(solver_, &transformation);
        STSetType(transformation, STSINVERT);
        STGetKSP(transformation, &inverse);
        KSPSetType(inverse, KSPPREONLY);
        KSPGetPC(inverse, &preconditioner);
        PCSetType(preconditioner, PCCHOLESKY);
        require_petsc(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS), "choose MUMPS");
        EPSSetOptionsPrefix(solver_, "modal_");
        PetscOptionsSetValue(nullptr, "-modal_st_mat_mumps_icntl_13", "1"); // all pivots seen, on several ranks too
    }

    PetscMatrix stiffness_, mass_;
    SlepcSession slepc_;
    EPS solver_ = nullptr;
};

/// A solver whose shift no w^2 lies below, so that the pairs nearest to it are the lowest.
std::unique_ptr<EigenSolver> make_solver_below_all(const Mesh& mesh, const DofMap& dofs, const Pencil& pencil,
                                                   int count)
{
    double shift = -relative_shift * pencil.scale;
    for (int lowered = 0; lowered <= most_lowerings; ++lowered, shift *= 10) {
        auto solver = std::make_unique<EigenSolver>(mesh, dofs, pencil, count, shift);
        if (solver->pairs_below_shift() == 0) return solver;
    }
    throw base::Error(base::ExitCode::numerical_failure,
                      "the stiffness has no lowest w^2: check the material's moduli and the loads");
}

/// w of w^2; an unstable w^2 < 0 gives a negative one, a rigid motion's zero within round-off a zero.
double signed_root(double square, double zero)
{
    if (square >= 0) return std::sqrt(square);
    return square < -zero ? -std::sqrt(-square) : 0;
}

Mode describe(const DofMap& dofs, const Pencil& pencil, double square, Eigen::VectorXd shape, int dimension)
{
    Mode mode;
    const double scale = std::sqrt(dofs.dot(shape, pencil.mass * shape));
    const DofMap::Largest largest = dofs.find_largest(shape);
    const double sign = dofs.team().sum(largest.entry >= 0 && shape[largest.entry] < 0 ? 1.0 : 0.0) > 0 ? -1 : 1;
    mode.shape = sign / scale * shape;
    mode.angular_frequency = signed_root(square, relative_zero * pencil.scale);
    const Eigen::VectorXd elastic = pencil.stiffness * mode.shape, inertia = pencil.mass * mode.shape;
    const Eigen::VectorXd sizes = pencil.stiffness.cwiseAbs() * mode.shape.cwiseAbs();
    mode.residual = dofs.largest(elastic - square * inertia) / dofs.largest(sizes);
    for (int k = 0; k < dimension; ++k) {
        Eigen::VectorXd along = Eigen::VectorXd::Zero(shape.size());
        for (Eigen::Index i = k; i < along.size(); i += dimension) along[i] = 1;
        mode.masses.push_back(std::pow(dofs.dot(along, inertia), 2));
    }
    return mode;
}

} // namespace

double asymmetry(const SolidForces& forces, const Motion& state)
{
    const DofMap& dofs = forces.map();
    const Matrix tangent = loaded_tangent(forces, state, 1);
    const Matrix transposed = tangent.transpose();
    const Matrix difference = (tangent - transposed).cwiseAbs();
    double worst = 0, largest = 0;
    for (int j = 0; j < tangent.outerSize() && j < dofs.own(); ++j)
        for (Matrix::InnerIterator entry(difference, j); entry; ++entry)
            if (entry.row() < dofs.own()) worst = std::max(worst, entry.value());
    for (int j = 0; j < tangent.outerSize() && j < dofs.own(); ++j)
        for (Matrix::InnerIterator entry(tangent, j); entry; ++entry)
            if (entry.row() < dofs.own()) largest = std::max(largest, std::abs(entry.value()));
    return dofs.team().max(worst) / dofs.team().max(largest);
}

std::vector<Mode> find_modes(const Mesh& mesh, const SolidForces& forces, const Supports& supports, const Motion& state,
                             double load_factor, int count)
{
    const DofMap& dofs = forces.map();
    double free = 0;
    for (int i = 0; i < dofs.own(); ++i) free += supports.fixed(i) ? 0 : 1;
    free = dofs.team().sum(free);
    base::require_input(count < free, "[analysis] modes = ", count, ": the body has ", free,
                        " unknowns that are not held; ask for fewer modes");
    const Pencil pencil = make_pencil(forces, supports, state, load_factor);
    const auto solver = make_solver_below_all(mesh, dofs, pencil, count);
    const int found = solver->solve();
    base::require(found >= count, base::ExitCode::numerical_failure, "only ", found, " of ", count,
                  " modes converged: ask for fewer, or check the material's density and moduli");
    std::vector<Mode> modes;
    for (int i = 0; i < count; ++i) {
        const auto [square, shape] = solver->pair(i);
        modes.push_back(describe(dofs, pencil, square, shape, mesh.dimension));
    }
    std::ranges::sort(modes, {}, &Mode::angular_frequency);
    return modes;
}

} // namespace fem
