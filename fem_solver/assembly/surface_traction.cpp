// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/surface_traction.hpp"

#include "fem_solver/assembly/face_integrals.hpp"

#include <Eigen/LU>

namespace fem {
namespace {

template<class FaceShape> class FollowerTraction final : public Load {
    using Integrals = FaceIntegrals<FaceShape>;
    static constexpr int D = Integrals::D;
    static constexpr int N = Integrals::N;
    using Tangents = typename Integrals::Tangents;

    struct At {
        Eigen::Matrix<double, D - 1, 1> along; // c_k w |dA_0/dxi|
        double pressure;                       // - c_n [Pa]
    };

public:
    FollowerTraction(const Mesh& mesh, const MatrixPattern& pattern, const std::vector<MeshFace>& faces,
                     const std::vector<double>& traction)
        : mesh_(&mesh), pattern_(&pattern), rule_(face_points<FaceShape>())
    {
        const Eigen::Map<const Eigen::Matrix<double, D, 1>> t(traction.data());
        for (const MeshFace& face : faces) {
            const auto nodes = mesh.face_nodes(face);
            faces_.push_back({});
            std::copy(nodes.begin(), nodes.end(), faces_.back().begin());
            const auto x = Integrals::current(mesh, nodes.data(), Eigen::VectorXd::Zero(std::ssize(mesh.coordinates)));
            for (const auto& point : rule_) {
                const Tangents g = Integrals::tangents(x, point);
                const Eigen::Matrix<double, D, 1> normal = face_normal(g);
                const double area = normal.norm(), outward = t.dot(normal) / area;
                const Eigen::Matrix<double, D, 1> flat = t - outward * normal / area;
                const Eigen::Matrix<double, D - 1, D - 1> metric = g.transpose() * g;
                const Eigen::Matrix<double, D - 1, 1> part = g.transpose() * flat;
                at_.push_back({point.weight * area * metric.inverse() * part, -outward});
            }
        }
    }

    void add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const override
    {
        const At* at = at_.data();
        for (const auto& nodes : faces_) {
            const auto x = Integrals::current(*mesh_, nodes.data(), motion.displacement);
            for (const auto& point : rule_) {
                Integrals::add_force(nodes.data(), x, point, scale * at->pressure, force);
                const auto n = FaceShape::values(point.xi);
                const Eigen::Matrix<double, D, 1> f = scale * Integrals::tangents(x, point) * at++->along;
                for (int a = 0; a < N; ++a)
                    force.template segment<D>(static_cast<Eigen::Index>(nodes[a]) * D) += n[a] * f;
            }
        }
    }

    void add_tangent(const Motion& motion, double scale, double, Matrix& matrix) const override
    {
        const At* at = at_.data();
        for (const auto& nodes : faces_) {
            const auto x = Integrals::current(*mesh_, nodes.data(), motion.displacement);
            for (const auto& point : rule_) {
                Integrals::add_tangent(*pattern_, nodes.data(), x, point, scale * at->pressure, matrix);
                const auto n = FaceShape::values(point.xi);
                const Eigen::Matrix<double, 1, N> slope =
                    scale * at++->along.transpose() * FaceShape::gradients(point.xi);
                for (int b = 0; b < N; ++b)
                    for (int a = 0; a < N; ++a)
                        pattern_->add_block(matrix, nodes[a], nodes[b],
                                            -n[a] * slope[b] * Eigen::Matrix<double, D, D>::Identity());
            }
        }
    }

private:
    const Mesh* mesh_;
    const MatrixPattern* pattern_;
    std::vector<GaussPoint<FaceShape::dimension>> rule_;
    std::vector<std::array<int, N>> faces_;
    std::vector<At> at_; // per face and point
};

} // namespace

std::unique_ptr<Load> make_follower_traction(const Mesh& mesh, const MatrixPattern& pattern,
                                             const std::vector<MeshFace>& faces, const std::vector<double>& traction)
{
    return with_shape(mesh.type, [&](auto shape) -> std::unique_ptr<Load> {
        return std::make_unique<FollowerTraction<typename decltype(shape)::Face>>(mesh, pattern, faces, traction);
    });
}

void Springs::add_force(const Motion& motion, double, Eigen::VectorXd& force) const
{
    force -= stiffness_ * motion.displacement;
}

void Springs::add_tangent(const Motion&, double, double, Matrix& matrix) const
{
    matrix.coeffs() += stiffness_.coeffs();
}

Matrix spring_stiffness(const Mesh& mesh, const MatrixPattern& pattern, const std::vector<MeshFace>& faces,
                        const std::vector<double>& stiffness)
{
    Matrix matrix = pattern.zero();
    with_shape(mesh.type, [&](auto shape) {
        using FaceShape = typename decltype(shape)::Face;
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(std::ssize(mesh.coordinates));
        for (const MeshFace& face : faces) {
            const auto nodes = mesh.face_nodes(face);
            const auto x = FaceIntegrals<FaceShape>::current(mesh, nodes.data(), still);
            for (const auto& point : face_points<FaceShape>()) {
                const auto n = FaceShape::values(point.xi);
                const double area = point.weight * face_normal(FaceIntegrals<FaceShape>::tangents(x, point)).norm();
                for (int b = 0; b < FaceShape::nodes; ++b)
                    for (int a = 0; a < FaceShape::nodes; ++a)
                        for (int k = 0; k < mesh.dimension; ++k)
                            pattern.add_entry(matrix, nodes[a] * mesh.dimension + k, nodes[b] * mesh.dimension + k,
                                              stiffness[k] * area * n[a] * n[b]);
            }
        }
    });
    return matrix;
}

} // namespace fem
