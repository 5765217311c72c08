// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/element_points.hpp"
#include "fem_solver/assembly/solid_body.hpp"
#include "fem_solver/element/enhanced_modes.hpp"
#include "fem_solver/material/point_law.hpp"

#include <limits>

namespace fem {

/// SolidBody for one element shape; everything of an element has a size known to the compiler.
template<class Shape> class ElementBody final : public SolidBody {
public:
    static constexpr int D = Shape::dimension;
    static constexpr int N = Shape::nodes;
    static constexpr bool can_enhance = Shape::linear && !is_simplex<Shape>;
    using Nodal = typename ElementPoints<Shape>::Nodal;
    using Modes = typename ElementPoints<Shape>::Modes; // one column per enhanced mode
    using Stiffness = typename ElementPoints<Shape>::Stiffness;
    using Coupling = Eigen::Matrix<double, D * D, D * N>; // of the enhanced modes with the nodes

    ElementBody(const Mesh& mesh, const MatrixPattern& pattern, const Material& material, const BodySettings& settings);

    Inversion add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) override;
    void add_stiffness(const Eigen::VectorXd& displacement, Matrix& matrix) override;
    void add_mass(Matrix& matrix) const override;
    double strain_energy(const Eigen::VectorXd& displacement) override;
    std::vector<double> stress(const Eigen::VectorXd& displacement) override;

private:
    using Point = typename ElementPoints<Shape>::Point;

    Tensor<D> deformation(const Point& point, const Nodal& u, int element) const;
    void prepare_modes();
    /// Has the element's modes, where it has any, carry no force. False when det F <= 0 on the way.
    bool settle(int element, const Nodal& u)
    {
        if constexpr (can_enhance)
            if (enhanced_) return relax_modes(element, u);
        return true;
    }
    bool relax_modes(int element, const Nodal& u);
    struct ModeSystem {
        Modes force = Modes::Zero();
        Tangent<D> stiffness = Tangent<D>::Zero();
        double scale = 0; // sum of the terms' sizes, for the stopping rule
        bool inverted = false;
    };
    ModeSystem mode_system(int element, const Nodal& u) const;

    const MatrixPattern* pattern_;
    std::unique_ptr<PointLaw<D>> law_;
    double density_;
    bool enhanced_;
    ElementPoints<Shape> points_;
    std::vector<Modes> modes_;
};

template<class Shape>
ElementBody<Shape>::ElementBody(const Mesh& mesh, const MatrixPattern& pattern, const Material& material,
                                const BodySettings& settings)
    : pattern_(&pattern),
      law_(make_point_law<D>(material)),
      density_(material.density),
      enhanced_(can_enhance && settings.formulation == Formulation::enhanced),
      points_(mesh, settings.full_integration ? Shape::full_gauss : Shape::gauss)
{
    if constexpr (can_enhance)
        if (enhanced_) prepare_modes();
}

template<class Shape> void ElementBody<Shape>::prepare_modes()
{
    const Eigen::Matrix<double, D, 1> centre = Eigen::Matrix<double, D, 1>::Zero();
    for (int e = 0; e < points_.elements(); ++e) {
        const Nodal x = points_.positions(e);
        const Modes jacobian_0 = points_.times_transposed(x, Shape::gradients(centre));
        for (int q = 0; q < points_.count(); ++q) {
            const auto& gauss = points_.rule()[q];
            const double det = points_.times_transposed(x, Shape::gradients(gauss.xi)).determinant();
            points_.of(e)[q].enhanced = enhanced_gradients<D>(gauss.xi, jacobian_0, jacobian_0.determinant() / det);
        }
    }
    modes_.assign(points_.elements(), Modes::Zero());
}

template<class Shape>
auto ElementBody<Shape>::deformation(const Point& point, const Nodal& u, int element) const -> Tensor<D>
{
    Tensor<D> f = Tensor<D>::Identity() + points_.times_transposed(u, point.gradient);
    if constexpr (can_enhance)
        if (enhanced_) f += modes_[element] * point.enhanced.transpose();
    return f;
}

template<class Shape> auto ElementBody<Shape>::mode_system(int element, const Nodal& u) const -> ModeSystem
{
    ModeSystem system;
    for (const Point& p : points_.of(element)) {
        const Tensor<D> f = deformation(p, u, element);
        if (law_->finite() && !(f.determinant() > 0)) {
            system.inverted = true;
            return system;
        }
        const Tensor<D> stress = law_->stress(f);
        const Tangent<D> tangent = p.volume * law_->tangent(f);
        system.force += p.volume * stress * p.enhanced;
        for (int j = 0; j < D; ++j) {
            const Eigen::Matrix<double, D * D, D> slope = stress_slope<D>(tangent, p.enhanced.col(j));
            for (int i = 0; i < D; ++i)
                system.stiffness.template block<D, D>(D * i, D * j) += contract<D>(p.enhanced.col(i), slope);
        }
        system.scale += p.volume * (stress.norm() + 1e-3 * law_->shear_modulus()) * p.enhanced.norm();
    }
    return system;
}

template<class Shape> bool ElementBody<Shape>::relax_modes(int element, const Nodal& u)
{
    constexpr int max_iterations = 30;
    constexpr double tolerance = 1e-13;
    const Modes before = modes_[element];
    double last = std::numeric_limits<double>::max();
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
        const ModeSystem system = mode_system(element, u);
        const double size = system.force.norm();
        const bool stalled = iteration > 3 && size >= last;
        if (system.inverted || (stalled && size > 1e-9 * system.scale)) break;
        if (size <= tolerance * system.scale || stalled) return true;
        const Eigen::Map<const Eigen::Matrix<double, D * D, 1>> force(system.force.data());
        Eigen::Map<Eigen::Matrix<double, D * D, 1>>(modes_[element].data()) -=
            system.stiffness.partialPivLu().solve(force);
        last = size;
    }
    modes_[element] = before;
    return false;
}

template<class Shape>
Inversion ElementBody<Shape>::add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force)
{
    for (int e = 0; e < points_.elements(); ++e) {
        const Nodal u = points_.gather(displacement, e);
        if (!settle(e, u)) return {e, 0};
        Nodal nodal = Nodal::Zero();
        for (const Point& p : points_.of(e)) {
            const Tensor<D> f = deformation(p, u, e);
            if (const double det = f.determinant(); law_->finite() && !(det > 0)) return {e, det};
            const Tensor<D> stress = p.volume * law_->stress(f);
            nodal.noalias() += stress.lazyProduct(p.gradient);
        }
        points_.scatter(nodal, e, force);
    }
    return {};
}

template<class Shape> void ElementBody<Shape>::add_stiffness(const Eigen::VectorXd& displacement, Matrix& matrix)
{
    for (int e = 0; e < points_.elements(); ++e) {
        const Nodal u = points_.gather(displacement, e);
        settle(e, u);
        Stiffness k = Stiffness::Zero();
        Coupling coupling = Coupling::Zero();
        for (const Point& p : points_.of(e)) {
            const Tangent<D> tangent = p.volume * law_->tangent(deformation(p, u, e));
            add_products<D>(tangent, p.gradient, p.gradient, k);
            if constexpr (can_enhance)
                if (enhanced_) add_products<D>(tangent, p.enhanced, p.gradient, coupling);
        }
        if constexpr (can_enhance)
            if (enhanced_) k -= coupling.transpose() * mode_system(e, u).stiffness.partialPivLu().solve(coupling);
        pattern_->add(matrix, e, k);
    }
}

template<class Shape> void ElementBody<Shape>::add_mass(Matrix& matrix) const
{
    points_.add_mass(density_, *pattern_, matrix);
}

template<class Shape> double ElementBody<Shape>::strain_energy(const Eigen::VectorXd& displacement)
{
    double energy = 0;
    for (int e = 0; e < points_.own_elements(); ++e) {
        const Nodal u = points_.gather(displacement, e);
        settle(e, u);
        for (const Point& p : points_.of(e)) energy += p.volume * law_->energy(deformation(p, u, e));
    }
    return energy;
}

template<class Shape> std::vector<double> ElementBody<Shape>::stress(const Eigen::VectorXd& displacement)
{
    std::vector<double> result;
    for (int e = 0; e < points_.own_elements(); ++e) {
        const Nodal u = points_.gather(displacement, e);
        settle(e, u);
        Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
        for (const Point& p : points_.of(e)) mean += law_->cauchy(deformation(p, u, e)) / points_.count();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) result.push_back(mean(i, j));
    }
    return result;
}

} // namespace fem
