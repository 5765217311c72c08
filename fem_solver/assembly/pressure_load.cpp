// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/pressure_load.hpp"

#include "fem_solver/assembly/face_integrals.hpp"

namespace fem {
namespace {

template<class FaceShape> class FollowerPressure final : public Load {
    using Integrals = FaceIntegrals<FaceShape>;

public:
    FollowerPressure(const Mesh& mesh, const MatrixPattern& pattern, const std::vector<MeshFace>& faces,
                     const PressureField& pressure)
        : mesh_(&mesh), pattern_(&pattern), rule_(face_points<FaceShape>())
    {
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(std::ssize(mesh.coordinates));
        for (const MeshFace& face : faces) {
            const auto nodes = mesh.face_nodes(face);
            faces_.push_back({});
            std::copy(nodes.begin(), nodes.end(), faces_.back().begin());
            const auto x = Integrals::current(mesh, nodes.data(), still);
            for (const auto& point : rule_) {
                const Eigen::Matrix<double, Integrals::D, 1> position =
                    x.lazyProduct(FaceShape::values(point.xi).transpose());
                pressure_.push_back(pressure(position.data()));
            }
        }
    }

    void add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const override
    {
        const double* p = pressure_.data();
        for (const auto& nodes : faces_) {
            const auto x = Integrals::current(*mesh_, nodes.data(), motion.displacement);
            for (const auto& point : rule_) Integrals::add_force(nodes.data(), x, point, scale * *p++, force);
        }
    }

    void add_tangent(const Motion& motion, double scale, double, Matrix& matrix) const override
    {
        const double* p = pressure_.data();
        for (const auto& nodes : faces_) {
            const auto x = Integrals::current(*mesh_, nodes.data(), motion.displacement);
            for (const auto& point : rule_)
                Integrals::add_tangent(*pattern_, nodes.data(), x, point, scale * *p++, matrix);
        }
    }

private:
    const Mesh* mesh_;
    const MatrixPattern* pattern_;
    std::vector<GaussPoint<FaceShape::dimension>> rule_;
    std::vector<std::array<int, FaceShape::nodes>> faces_;
    std::vector<double> pressure_; // per face and point [Pa]
};

/// Calls `action(nodes, x, point)` at the integration points of a linear facet; a triangle is a quadrilateral whose
/// last two nodes coincide, which has exactly the triangle's linear functions.
template<class FaceShape, class Action>
void visit_facet(const Mesh& mesh, const std::array<int, 4>& facet, const Eigen::VectorXd& displacement,
                 Action&& action)
{
    static const auto rule = face_points<FaceShape>();
    std::array<int, 4> nodes = facet;
    if (FaceShape::nodes == 4 && nodes[3] < 0) nodes[3] = nodes[2];
    const auto x = FaceIntegrals<FaceShape>::current(mesh, nodes.data(), displacement);
    for (const auto& point : rule) action(nodes.data(), x, point);
}

template<class FaceShape>
void add_traction(const Mesh& mesh, const std::vector<MeshFace>& faces, const std::vector<double>& traction,
                  Eigen::VectorXd& force)
{
    constexpr int D = FaceIntegrals<FaceShape>::D;
    const Eigen::Map<const Eigen::Matrix<double, D, 1>> t(traction.data());
    for (const MeshFace& face : faces) {
        const auto nodes = mesh.face_nodes(face);
        const auto x = FaceIntegrals<FaceShape>::current(mesh, nodes.data(), Eigen::VectorXd::Zero(force.size()));
        for (const auto& point : face_points<FaceShape>()) {
            const auto tangents = FaceIntegrals<FaceShape>::tangents(x, point);
            const double area = point.weight * face_normal(tangents).norm();
            const auto n = FaceShape::values(point.xi);
            for (int a = 0; a < FaceShape::nodes; ++a)
                force.template segment<D>(static_cast<Eigen::Index>(nodes[a]) * D) += area * n[a] * t;
        }
    }
}

} // namespace

std::unique_ptr<Load> make_follower_pressure(const Mesh& mesh, const MatrixPattern& pattern,
                                             const std::vector<MeshFace>& faces, const PressureField& pressure)
{
    return with_shape(mesh.type, [&](auto shape) -> std::unique_ptr<Load> {
        return std::make_unique<FollowerPressure<typename decltype(shape)::Face>>(mesh, pattern, faces, pressure);
    });
}

Eigen::VectorXd dead_pressure_force(const Mesh& mesh, const MatrixPattern& pattern, const std::vector<MeshFace>& faces,
                                    const PressureField& pressure)
{
    Eigen::VectorXd force = Eigen::VectorXd::Zero(std::ssize(mesh.coordinates));
    make_follower_pressure(mesh, pattern, faces, pressure)->add_force(Motion::at_rest(force.size()), 1, force);
    return force;
}

Eigen::VectorXd traction_force(const Mesh& mesh, const std::vector<MeshFace>& faces,
                               const std::vector<double>& traction)
{
    Eigen::VectorXd force = Eigen::VectorXd::Zero(std::ssize(mesh.coordinates));
    with_shape(mesh.type,
               [&](auto shape) { add_traction<typename decltype(shape)::Face>(mesh, faces, traction, force); });
    return force;
}

FacetPressure::FacetPressure(const Mesh& mesh, const MatrixPattern& pattern, std::vector<std::array<int, 4>> facets)
    : mesh_(&mesh), pattern_(&pattern), facets_(std::move(facets)), pressure_(facets_.size(), 0.0)
{}

void FacetPressure::add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const
{
    const auto add = [&]<class FaceShape>(FaceShape, std::size_t f) {
        visit_facet<FaceShape>(*mesh_, facets_[f], motion.displacement,
                               [&](const int* nodes, const auto& x, const auto& point) {
                                   FaceIntegrals<FaceShape>::add_force(nodes, x, point, scale * pressure_[f], force);
                               });
    };
    for (std::size_t f = 0; f < facets_.size(); ++f) mesh_->dimension == 2 ? add(Line2{}, f) : add(Quad4{}, f);
}

void FacetPressure::add_tangent(const Motion& motion, double scale, double, Matrix& matrix) const
{
    const auto add = [&]<class FaceShape>(FaceShape, std::size_t f) {
        visit_facet<FaceShape>(
            *mesh_, facets_[f], motion.displacement, [&](const int* nodes, const auto& x, const auto& point) {
                FaceIntegrals<FaceShape>::add_tangent(*pattern_, nodes, x, point, scale * pressure_[f], matrix);
            });
    };
    for (std::size_t f = 0; f < facets_.size(); ++f) mesh_->dimension == 2 ? add(Line2{}, f) : add(Quad4{}, f);
}

} // namespace fem
