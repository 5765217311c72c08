// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/elastic.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

namespace fem {

/// Derivatives of an isochoric energy by the principal logarithmic strains e_c: first [Pa] and second [Pa].
struct LogSlopes {
    Eigen::Vector3d first;
    Eigen::Matrix3d second;
};

/// A law whose energy is a function of the principal stretches l_a, split in shape and volume:
///
///     w = psi(e) + K/2 (J - 1)^2,    e_a = ln l_a - (ln J)/3,   J = l_1 l_2 l_3     [J/m^3]
///     t_a = dpsi/de_a - mean + K (J - 1) J          Kirchhoff stress along a [Pa]
///     P = sum_a t_a / l_a  n_a N_a^T,               F = sum_a l_a n_a N_a^T
///
/// `Isochoric` is the energy psi: a small struct with energy(e), slopes(e) and shear_modulus(), written for any e; the
/// part that changes the volume is taken off here. Plane strain has l_3 = 1.
template<class Isochoric> struct PrincipalLaw {
    static constexpr bool finite = true;
    Isochoric shape;
    double bulk = 0; ///< K [Pa]

    double shear_modulus() const { return shape.shear_modulus(); }

    template<int D> double energy(const Tensor<D>& f) const
    {
        const Frame<D> frame(f);
        return shape.energy(frame.isochoric()) + 0.5 * bulk * (frame.j - 1) * (frame.j - 1);
    }
    template<int D> Tensor<D> stress(const Tensor<D>& f) const
    {
        const Frame<D> frame(f);
        const Eigen::Vector3d t = kirchhoff(shape.slopes(frame.isochoric()).first, frame.j);
        const Eigen::Vector3d p = t.cwiseQuotient(frame.stretch);
        return frame.current * p.head<D>().asDiagonal() * frame.reference.transpose();
    }
    /// In the principal frame, with p_a = t_a / l_a, dF and dP are coupled only as
    ///
    ///     dP_aa = sum_b (dp_a/dl_b) dF_bb,     dp_a/dl_b = (dt_a/d ln l_b - delta_ab t_a) / (l_a l_b)
    ///     dP_ab = (m + q)/2 dF_ab + (m - q)/2 dF_ba,   m = (p_a - p_b)/(l_a - l_b),  q = (p_a + p_b)/(l_a + l_b)
    template<int D> Tangent<D> tangent(const Tensor<D>& f) const
    {
        const Frame<D> frame(f);
        const LogSlopes slopes = shape.slopes(frame.isochoric());
        const Eigen::Vector3d t = kirchhoff(slopes.first, frame.j), &l = frame.stretch;
        Eigen::Matrix3d h = without_volume(slopes.second);
        h.array() += bulk * (2 * frame.j - 1) * frame.j;
        h.diagonal() -= t;
        const Eigen::Matrix3d dp = h.cwiseQuotient(l * l.transpose());
        const Eigen::Vector3d p = t.cwiseQuotient(l);
        Tangent<D> a = Tangent<D>::Zero();
        for (int j = 0; j < D; ++j)
            for (int i = 0; i < D; ++i) {
                a(i + D * i, j + D * j) = dp(i, j);
                if (i == j) continue;
                const double m = difference(p, l, dp, i, j), q = (p[i] + p[j]) / (l[i] + l[j]);
                a(i + D * j, i + D * j) = 0.5 * (m + q);
                a(i + D * j, j + D * i) = 0.5 * (m - q);
            }
        return frame.rotate(a);
    }

private:
    /// Principal stretches and directions of F; the directions are columns.
    template<int D> struct Frame {
        Eigen::Vector3d stretch = Eigen::Vector3d::Ones();
        Tensor<D> reference, current;
        double j;

        explicit Frame(const Tensor<D>& f) : j(f.determinant())
        {
            const Eigen::SelfAdjointEigenSolver<Tensor<D>> solver(f.transpose() * f);
            reference = solver.eigenvectors();
            stretch.template head<D>() = solver.eigenvalues().cwiseSqrt();
            current = f * reference * stretch.template head<D>().cwiseInverse().asDiagonal();
        }
        Eigen::Vector3d isochoric() const { return stretch.array().log() - std::log(j) / 3; }
        /// From the principal frame to the axes: a = R a' R^T with R_(ij)(ab) = current_ia reference_jb.
        Tangent<D> rotate(const Tangent<D>& a) const
        {
            Tangent<D> r;
            for (int b = 0; b < D; ++b)
                for (int c = 0; c < D; ++c)
                    for (int k = 0; k < D; ++k)
                        r.template block<D, 1>(D * k, c + D * b) = reference(k, b) * current.col(c);
            return r * a * r.transpose();
        }
    };

    Eigen::Vector3d kirchhoff(const Eigen::Vector3d& first, double j) const
    {
        return (first.array() - first.mean() + bulk * (j - 1) * j).matrix();
    }
    static Eigen::Matrix3d without_volume(const Eigen::Matrix3d& second)
    {
        const Eigen::Matrix3d project = Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Constant(1.0 / 3);
        return project * second * project;
    }
    /// (p_i - p_j)/(l_i - l_j), where the two nearly agree by its limit; the error is about 1e-10 then.
    static double difference(const Eigen::Vector3d& p, const Eigen::Vector3d& l, const Eigen::Matrix3d& dp, int i,
                             int j)
    {
        const double gap = l[i] - l[j];
        if (std::abs(gap) > 1e-5 * (l[i] + l[j])) return (p[i] - p[j]) / gap;
        return 0.5 * (dp(i, i) - dp(i, j) + dp(j, j) - dp(j, i));
    }
};

} // namespace fem
