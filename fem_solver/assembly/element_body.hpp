// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_body.hpp"
#include "fem_solver/element/enhanced_modes.hpp"
#include "fem_solver/element/gauss.hpp"
#include "fem_solver/material/point_law.hpp"

#include <Eigen/LU>

#include <limits>

namespace fem {

/// SolidBody for one element shape; everything of an element has a size known to the compiler.
template<class Shape> class ElementBody final : public SolidBody {
public:
    static constexpr int D = Shape::dimension;
    static constexpr int N = Shape::nodes;
    static constexpr bool can_enhance = Shape::linear;
    using Nodal = Eigen::Matrix<double, D, N>; // one column per node
    using Modes = Eigen::Matrix<double, D, D>; // one column per enhanced mode
    using Stiffness = Eigen::Matrix<double, D * N, D * N>;
    using Coupling = Eigen::Matrix<double, D * D, D * N>; // of the enhanced modes with the nodes

    ElementBody(const Mesh& mesh, const MatrixPattern& pattern, const Material& material, BodySettings settings);

    Inversion add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) override;
    void add_stiffness(const Eigen::VectorXd& displacement, Matrix& matrix) override;
    void add_mass(Matrix& matrix) const override;
    double strain_energy(const Eigen::VectorXd& displacement) override;
    std::vector<double> stress(const Eigen::VectorXd& displacement) override;

private:
    struct Point {
        Nodal gradient; // dN_a/dX [1/m]
        Modes enhanced; // G_i [1/m], zero without enhancement
        double volume;  // weight times Jacobian [m^3] (2D: m^2)
    };

    const int* nodes_of(int element) const { return connectivity_.data() + static_cast<std::size_t>(element) * N; }
    const Point* points_of(int element) const { return points_.data() + static_cast<std::size_t>(element) * count_; }
    Nodal gather(const Eigen::VectorXd& field, int element) const;
    Tensor<D> deformation(const Point& point, const Nodal& u, int element) const;
    /// Solves the element's modes for a displacement, so that they carry no force. False when det F <= 0 on the way.
    bool relax_modes(int element, const Nodal& u);
    struct ModeSystem {
        Modes force = Modes::Zero();
        Tangent<D> stiffness = Tangent<D>::Zero();
        double scale = 0; // sum of the terms' sizes, for the stopping rule
        bool inverted = false;
    };
    ModeSystem mode_system(int element, const Nodal& u) const;

    /// Adds rows^T (dP/dF) gradient, D x D for each pair of columns: of nodes or modes with nodes.
    template<class Rows, class Block>
    static void add_products(const Tangent<D>& tangent, const Rows& rows, const Nodal& gradient, Block& k);

    const MatrixPattern* pattern_;
    std::unique_ptr<PointLaw<D>> law_;
    double density_;
    bool enhanced_;
    int count_; // integration points per element
    std::vector<int> connectivity_;
    std::vector<double> coordinates_;
    std::vector<Point> points_;
    std::vector<Modes> modes_;
};

/// A : grad N_b for one node: column k holds d(vec P)/du_k, for F = I + U g^T with entries in column order.
template<int D, class Gradient>
Eigen::Matrix<double, D * D, D> stress_slope(const Tangent<D>& tangent, const Gradient& gradient)
{
    Eigen::Matrix<double, D * D, D> slope = tangent.template leftCols<D>() * gradient[0];
    for (int l = 1; l < D; ++l) slope += tangent.template middleCols<D>(D * l) * gradient[l];
    return slope;
}

/// grad N_a contracted with the stress index of a stress_slope: the D x D block that couples two nodes.
template<int D, class Gradient>
Tensor<D> contract(const Gradient& gradient, const Eigen::Matrix<double, D * D, D>& slope)
{
    Tensor<D> block = gradient[0] * slope.template topRows<D>();
    for (int j = 1; j < D; ++j) block += gradient[j] * slope.template middleRows<D>(D * j);
    return block;
}

template<class Shape>
ElementBody<Shape>::ElementBody(const Mesh& mesh, const MatrixPattern& pattern, const Material& material,
                                BodySettings settings)
    : pattern_(&pattern),
      law_(make_point_law<D>(material.law)),
      density_(material.density),
      enhanced_(can_enhance && settings.enhanced),
      connectivity_(mesh.connectivity),
      coordinates_(mesh.coordinates)
{
    const auto rule = gauss_points<D>(settings.full_integration ? Shape::full_gauss : Shape::gauss);
    count_ = static_cast<int>(rule.size());
    const Eigen::Map<const Eigen::VectorXd> positions(coordinates_.data(), std::ssize(coordinates_));
    const Eigen::Matrix<double, D, 1> centre = Eigen::Matrix<double, D, 1>::Zero();
    for (int e = 0; e < mesh.elements(); ++e) {
        const Nodal x = gather(positions, e);
        const Modes jacobian_0 = x * Shape::gradients(centre).transpose();
        for (const auto& gauss : rule) {
            const Nodal reference = Shape::gradients(gauss.xi);
            const Modes jacobian = x * reference.transpose();
            const double det = jacobian.determinant();
            Point point{jacobian.inverse().transpose() * reference, Modes::Zero(), gauss.weight * det};
            if (enhanced_) point.enhanced = enhanced_gradients<D>(gauss.xi, jacobian_0, jacobian_0.determinant() / det);
            points_.push_back(point);
        }
    }
    if (enhanced_) modes_.assign(mesh.elements(), Modes::Zero());
}

template<class Shape>
auto ElementBody<Shape>::gather(const Eigen::VectorXd& field, int element) const -> Nodal
{
    Nodal u;
    const int* nodes = nodes_of(element);
    for (int a = 0; a < N; ++a) u.col(a) = field.template segment<D>(static_cast<Eigen::Index>(nodes[a]) * D);
    return u;
}

template<class Shape>
auto ElementBody<Shape>::deformation(const Point& point, const Nodal& u, int element) const -> Tensor<D>
{
    Tensor<D> f = Tensor<D>::Identity();
    f.noalias() += u.lazyProduct(point.gradient.transpose());
    if constexpr (can_enhance)
        if (enhanced_) f += modes_[element] * point.enhanced.transpose();
    return f;
}

template<class Shape>
auto ElementBody<Shape>::mode_system(int element, const Nodal& u) const -> ModeSystem
{
    ModeSystem system;
    for (const Point* p = points_of(element); p != points_of(element) + count_; ++p) {
        const Tensor<D> f = deformation(*p, u, element);
        if (law_->finite() && !(f.determinant() > 0)) {
            system.inverted = true;
            return system;
        }
        const Tensor<D> stress = law_->stress(f);
        const Tangent<D> tangent = p->volume * law_->tangent(f);
        system.force += p->volume * stress * p->enhanced;
        for (int j = 0; j < D; ++j) {
            const Eigen::Matrix<double, D * D, D> slope = stress_slope<D>(tangent, p->enhanced.col(j));
            for (int i = 0; i < D; ++i)
                system.stiffness.template block<D, D>(D * i, D * j) += contract<D>(p->enhanced.col(i), slope);
        }
        system.scale += p->volume * (stress.norm() + 1e-3 * law_->shear_modulus()) * p->enhanced.norm();
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
    const int elements = static_cast<int>(connectivity_.size()) / N;
    for (int e = 0; e < elements; ++e) {
        const Nodal u = gather(displacement, e);
        if (enhanced_ && !relax_modes(e, u)) return {e, 0};
        Nodal nodal = Nodal::Zero();
        for (const Point* p = points_of(e); p != points_of(e) + count_; ++p) {
            const Tensor<D> f = deformation(*p, u, e);
            if (const double det = f.determinant(); law_->finite() && !(det > 0)) return {e, det};
            const Tensor<D> stress = p->volume * law_->stress(f);
            nodal.noalias() += stress.lazyProduct(p->gradient);
        }
        const int* nodes = nodes_of(e);
        for (int a = 0; a < N; ++a) force.template segment<D>(static_cast<Eigen::Index>(nodes[a]) * D) += nodal.col(a);
    }
    return {};
}

template<class Shape>
template<class Rows, class Block>
void ElementBody<Shape>::add_products(const Tangent<D>& tangent, const Rows& rows, const Nodal& gradient, Block& k)
{
    for (int b = 0; b < N; ++b) {
        const Eigen::Matrix<double, D * D, D> slope = stress_slope<D>(tangent, gradient.col(b));
        for (int a = 0; a < rows.cols(); ++a) k.template block<D, D>(D * a, D * b) += contract<D>(rows.col(a), slope);
    }
}

template<class Shape>
void ElementBody<Shape>::add_stiffness(const Eigen::VectorXd& displacement, Matrix& matrix)
{
    const int elements = static_cast<int>(connectivity_.size()) / N;
    for (int e = 0; e < elements; ++e) {
        const Nodal u = gather(displacement, e);
        if (enhanced_) relax_modes(e, u);
        Stiffness k = Stiffness::Zero();
        Coupling coupling = Coupling::Zero();
        for (const Point* p = points_of(e); p != points_of(e) + count_; ++p) {
            const Tangent<D> tangent = p->volume * law_->tangent(deformation(*p, u, e));
            add_products(tangent, p->gradient, p->gradient, k);
            if constexpr (can_enhance)
                if (enhanced_) add_products(tangent, p->enhanced, p->gradient, coupling);
        }
        if constexpr (can_enhance)
            if (enhanced_) k -= coupling.transpose() * mode_system(e, u).stiffness.partialPivLu().solve(coupling);
        pattern_->add(matrix, e, k);
    }
}

template<class Shape> void ElementBody<Shape>::add_mass(Matrix& matrix) const
{
    const int elements = static_cast<int>(connectivity_.size()) / N;
    const Eigen::Map<const Eigen::VectorXd> positions(coordinates_.data(), std::ssize(coordinates_));
    const auto rule = gauss_points<D>(Shape::mass_gauss);
    for (int e = 0; e < elements; ++e) {
        const Nodal x = gather(positions, e);
        Stiffness m = Stiffness::Zero();
        for (const auto& gauss : rule) {
            const auto n = Shape::values(gauss.xi);
            const Modes jacobian = x * Shape::gradients(gauss.xi).transpose();
            const double mass = density_ * gauss.weight * jacobian.determinant();
            for (int b = 0; b < N; ++b)
                for (int a = 0; a < N; ++a)
                    for (int k = 0; k < D; ++k) m(a * D + k, b * D + k) += mass * n[a] * n[b];
        }
        pattern_->add(matrix, e, m);
    }
}

template<class Shape>
double ElementBody<Shape>::strain_energy(const Eigen::VectorXd& displacement)
{
    const int elements = static_cast<int>(connectivity_.size()) / N;
    double energy = 0;
    for (int e = 0; e < elements; ++e) {
        const Nodal u = gather(displacement, e);
        if (enhanced_) relax_modes(e, u);
        for (const Point* p = points_of(e); p != points_of(e) + count_; ++p)
            energy += p->volume * law_->energy(deformation(*p, u, e));
    }
    return energy;
}

template<class Shape>
std::vector<double> ElementBody<Shape>::stress(const Eigen::VectorXd& displacement)
{
    const int elements = static_cast<int>(connectivity_.size()) / N;
    std::vector<double> result;
    for (int e = 0; e < elements; ++e) {
        const Nodal u = gather(displacement, e);
        if (enhanced_) relax_modes(e, u);
        Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
        for (const Point* p = points_of(e); p != points_of(e) + count_; ++p)
            mean += law_->cauchy(deformation(*p, u, e)) / count_;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) result.push_back(mean(i, j));
    }
    return result;
}

/// The body of a shape. Each shape has its own source file.
template<class Shape>
std::unique_ptr<SolidBody> make_element_body(const Mesh& mesh, const MatrixPattern& pattern, const Material& material,
                                             const BodySettings& settings)
{
    return std::make_unique<ElementBody<Shape>>(mesh, pattern, material, settings);
}

} // namespace fem
