// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/element_points.hpp"
#include "fem_solver/assembly/solid_body.hpp"
#include "fem_solver/material/shape_law.hpp"
#include "fem_solver/material/split_law.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace fem {

/// SolidBody whose elements have a pressure field of their own, against locking near incompressibility
/// (J. C. Simo, R. L. Taylor, K. S. Pister, Comput. Methods Appl. Mech. Engrg 51 (1985) 177):
///
///     W = integral of psi(F) dV + K/2 integral of (Pi (J - 1))^2 dV
///     f_a = integral of (dpsi/dF + p J F^-T) grad N_a dV,     p = K Pi (J - 1)
///
/// Pi projects, element by element, onto constants (M = 1: mean dilatation) or onto 1, X, Y (, Z) (M = D + 1). The
/// pressure is eliminated in each element, so displacements remain the only unknowns and the tangent is symmetric.
template<class Shape, int M> class MixedBody final : public SolidBody {
    static constexpr int D = Shape::dimension;
    static constexpr int N = Shape::nodes;
    using Points = ElementPoints<Shape>;
    using Nodal = typename Points::Nodal;
    using Basis = Eigen::Matrix<double, M, 1>;
    using Gram = Eigen::Matrix<double, M, M>;

public:
    MixedBody(const Mesh& mesh, const MatrixPattern& pattern, const SplitLaw& law, const Material& material)
        : pattern_(&pattern),
          points_(mesh, Shape::full_gauss),
          shape_(make_point_law<D>(law.shape), material.softening, points_.all()),
          bulk_(law.bulk),
          density_(material.density)
    {
        for (int e = 0; e < points_.elements(); ++e) {
            const Nodal x = points_.positions(e);
            const Eigen::Matrix<double, D, 1> centre = x.rowwise().mean();
            const double size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
            Gram gram = Gram::Zero();
            for (int q = 0; q < points_.count(); ++q) {
                const Eigen::Matrix<double, D, 1> at = x.lazyProduct(Shape::values(points_.rule()[q].xi).transpose());
                Basis basis = Basis::Ones();
                if constexpr (M > 1) basis.template tail<D>() = (at - centre) / size;
                gram += points_.of(e)[q].volume * basis * basis.transpose();
                basis_.push_back(basis);
            }
            inverse_gram_.push_back(gram.inverse());
        }
    }

    Inversion add_internal_force(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) override
    {
        for (int e = 0; e < points_.elements(); ++e) {
            const Deformed& deformed = deform(e, points_.gather(displacement, e));
            if (!(deformed.least > 0)) return {e, deformed.least};
            const Basis pressure = bulk_ * dilatation(e, deformed);
            Nodal nodal = Nodal::Zero();
            for (int q = 0; q < points_.count(); ++q) {
                const auto& p = points_.of(e)[q];
                const Tensor<D>& f = deformed.f[q];
                const double j_pressure = deformed.j[q] * pressure.dot(basis_of(e)[q]);
                const Tensor<D> h = f.inverse().transpose();
                const Tensor<D> stress = p.volume * (shape_.stress(at(e, q), f) + j_pressure * h);
                nodal.noalias() += stress.lazyProduct(p.gradient);
            }
            points_.scatter(nodal, e, force);
        }
        return {};
    }

    void add_stiffness(const Eigen::VectorXd& displacement, Matrix& matrix) override
    {
        for (int e = 0; e < points_.elements(); ++e)
            pattern_->add(matrix, e, stiffness(e, points_.gather(displacement, e)));
    }

    void add_mass(Matrix& matrix) const override { points_.add_mass(density_, *pattern_, matrix); }

    double strain_energy(const Eigen::VectorXd& displacement) override
    {
        double energy = 0;
        for (int e = 0; e < points_.own_elements(); ++e) {
            const Deformed& deformed = deform(e, points_.gather(displacement, e));
            const Basis theta = dilatation(e, deformed);
            for (int q = 0; q < points_.count(); ++q) {
                const double t = theta.dot(basis_of(e)[q]);
                energy += points_.of(e)[q].volume * (shape_.energy(at(e, q), deformed.f[q]) + 0.5 * bulk_ * t * t);
            }
        }
        return energy;
    }

    std::vector<double> stress(const Eigen::VectorXd& displacement) override
    {
        std::vector<double> result;
        for (int e = 0; e < points_.own_elements(); ++e) {
            const Deformed& deformed = deform(e, points_.gather(displacement, e));
            const Basis pressure = bulk_ * dilatation(e, deformed);
            Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
            for (int q = 0; q < points_.count(); ++q) {
                mean += shape_.cauchy(at(e, q), deformed.f[q]) / points_.count();
                mean.diagonal().array() += pressure.dot(basis_of(e)[q]) / points_.count();
            }
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) result.push_back(mean(i, j));
        }
        return result;
    }

    void accept(const Eigen::VectorXd& displacement) override
    {
        if (!shape_.softens()) return;
        for (int e = 0; e < points_.elements(); ++e) {
            const Deformed& deformed = deform(e, points_.gather(displacement, e));
            for (int q = 0; q < points_.count(); ++q) shape_.accept(at(e, q), deformed.f[q]);
        }
    }

    double lost_energy() const override
    {
        double energy = 0;
        if (!shape_.softens()) return energy;
        for (int e = 0; e < points_.own_elements(); ++e)
            for (int q = 0; q < points_.count(); ++q) energy += points_.of(e)[q].volume * shape_.lost(at(e, q));
        return energy;
    }

private:
    /// Number of an element's integration point among all.
    std::size_t at(int element, int q) const
    {
        return static_cast<std::size_t>(element) * points_.count() + static_cast<std::size_t>(q);
    }
    const Basis* basis_of(int element) const { return basis_.data() + at(element, 0); }
    /// Deformation gradients of one element at its integration points, their determinants and the least of these.
    struct Deformed {
        std::vector<Tensor<D>> f;
        std::vector<double> j;
        double least = 0;
    };
    /// Good until the next call.
    const Deformed& deform(int e, const Nodal& u)
    {
        const auto points = points_.of(e);
        deformed_.f.resize(points.size());
        deformed_.j.resize(points.size());
        deformed_.least = std::numeric_limits<double>::infinity();
        for (std::size_t q = 0; q < points.size(); ++q) {
            deformed_.f[q] = Tensor<D>::Identity() + points_.times_transposed(u, points[q].gradient);
            deformed_.j[q] = deformed_.f[q].determinant();
            if (std::isnan(deformed_.j[q]) || deformed_.j[q] < deformed_.least) deformed_.least = deformed_.j[q];
        }
        return deformed_;
    }
    /// Coefficients of Pi (J - 1).
    Basis dilatation(int e, const Deformed& deformed) const
    {
        Basis sum = Basis::Zero();
        for (int q = 0; q < points_.count(); ++q) sum += points_.of(e)[q].volume * (deformed.j[q] - 1) * basis_of(e)[q];
        return inverse_gram_[e] * sum;
    }

    /// With h = F^-T and B_m,a = integral of N_m J h grad N_a dV:
    ///
    ///     K = integral of grad N_a [ d2psi/dF2 + p J (h_ij h_kl - h_il h_kj) ] grad N_b dV + K B^T gram^-1 B
    typename Points::Stiffness stiffness(int e, const Nodal& u)
    {
        const Deformed& deformed = deform(e, u);
        const Basis pressure = bulk_ * dilatation(e, deformed);
        typename Points::Stiffness k = Points::Stiffness::Zero();
        Eigen::Matrix<double, M, D* N> b = Eigen::Matrix<double, M, D * N>::Zero();
        for (int q = 0; q < points_.count(); ++q) {
            const auto& p = points_.of(e)[q];
            const Tensor<D>& f = deformed.f[q];
            const Tensor<D> h = f.inverse().transpose();
            const double j = p.volume * deformed.j[q];
            const Tangent<D> a =
                p.volume * shape_.tangent(at(e, q), f) + j * pressure.dot(basis_of(e)[q]) * cofactor_slope(h);
            add_products<D>(a, p.gradient, p.gradient, k);
            const Nodal slope = (j * h).eval().lazyProduct(p.gradient); // dJ/du_a
            for (int i = 0; i < D * N; ++i) b.col(i) += basis_of(e)[q] * slope.data()[i];
        }
        const Eigen::Matrix<double, M, D* N> dilated = inverse_gram_[e].lazyProduct(b);
        k.noalias() += (bulk_ * b).eval().transpose().lazyProduct(dilated);
        return k;
    }
    /// d(J h_ij)/dF_kl / J = h_ij h_kl - h_il h_kj
    static Tangent<D> cofactor_slope(const Tensor<D>& h)
    {
        Tangent<D> a;
        for (int l = 0; l < D; ++l)
            for (int k = 0; k < D; ++k)
                for (int j = 0; j < D; ++j)
                    for (int i = 0; i < D; ++i) a(i + D * j, k + D * l) = h(i, j) * h(k, l) - h(i, l) * h(k, j);
        return a;
    }

    const MatrixPattern* pattern_;
    Points points_;
    ShapeLaw<D> shape_; // the law without its volume part
    double bulk_, density_;
    std::vector<Basis> basis_; // per point
    std::vector<Gram> inverse_gram_;
    Deformed deformed_;
};

} // namespace fem
