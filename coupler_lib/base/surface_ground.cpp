// SPDX-License-Identifier: MIT
#include "coupler_lib/base/csv_table.hpp"
#include "coupler_lib/base/ground.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <unsupported/Eigen/BVH>

#include <limits>
#include <map>
#include <numeric>

namespace base {
namespace {

using Box3 = Eigen::AlignedBox<double, 3>;
using Tree = Eigen::KdBVH<double, 3, int>;

/// The triangle nearest to a point, in the form that Eigen's bounding volume hierarchy asks for.
struct NearestTriangle {
    using Scalar = double;
    const TriangleMesh* mesh;
    Eigen::Vector3d x;
    int triangle = -1;
    ClosestPoint<3> closest = {};

    double minimumOnVolume(const Box3& box) const { return box.squaredExteriorDistance(x); }
    double minimumOnObject(int k)
    {
        const auto found = closest_point(mesh->triangle(static_cast<std::size_t>(k)), x);
        if (found.squared_distance < closest.squared_distance) {
            closest = found;
            triangle = k;
        }
        return found.squared_distance;
    }
};

/// Normals of faces, edges and corners (J. A. Baerentzen, H. Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243-253):
/// a corner's is the sum of its faces' normals, weighted by their angles there; they tell inside from outside wherever
/// the nearest point lies.
class PseudoNormals {
public:
    PseudoNormals(const TriangleMesh& mesh, const std::string& what)
        : corner_(mesh.corners.size(), Eigen::Vector3d::Zero()), corner_on_rim_(mesh.corners.size(), 0)
    {
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k) add(mesh, k);
        for (const auto& [ends, edge] : edges_) {
            require_input(edge.faces <= 2, what, ": ", edge.faces, " triangles share the edge from (",
                          mesh.corners[static_cast<std::size_t>(ends.first)].transpose(), ") m");
            if (edge.faces == 2) continue;
            corner_on_rim_[static_cast<std::size_t>(ends.first)] = 1;
            corner_on_rim_[static_cast<std::size_t>(ends.second)] = 1;
        }
    }

    struct Normal {
        Eigen::Vector3d vector = Eigen::Vector3d::Zero(); ///< of any length
        bool rim = false;                                 ///< the surface ends here
    };
    Normal edge(int a, int b) const
    {
        const Edge& found = edges_.at(std::minmax(a, b));
        return {found.normal, found.faces == 1};
    }
    Normal corner(int a) const
    {
        return {corner_[static_cast<std::size_t>(a)], corner_on_rim_[static_cast<std::size_t>(a)] != 0};
    }

private:
    struct Edge {
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        int faces = 0;
    };

    void add(const TriangleMesh& mesh, std::size_t k)
    {
        const auto& corners = mesh.triangles[k];
        const Simplex<3> x = mesh.triangle(k);
        const Eigen::Vector3d normal = area_vector(x).normalized();
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            Edge& edge = edges_[std::minmax(corners[a], corners[b])];
            edge.normal += normal;
            ++edge.faces;
            const double cosine = (x[b] - x[a]).normalized().dot((x[c] - x[a]).normalized());
            corner_[static_cast<std::size_t>(corners[a])] += std::acos(std::clamp(cosine, -1.0, 1.0)) * normal;
        }
    }

    std::map<std::pair<int, int>, Edge> edges_;
    std::vector<Eigen::Vector3d> corner_;
    std::vector<char> corner_on_rim_;
};

class SurfaceGround final : public Ground {
public:
    SurfaceGround(TriangleMesh mesh, const std::string& what) : mesh_(std::move(mesh)), normals_(mesh_, what)
    {
        std::vector<int> triangles(mesh_.triangles.size());
        std::iota(triangles.begin(), triangles.end(), 0);
        std::vector<Box3> boxes(triangles.size());
        for (std::size_t k = 0; k < boxes.size(); ++k)
            for (const auto& corner : mesh_.triangle(k)) boxes[k].extend(corner);
        tree_.init(triangles.begin(), triangles.end(), boxes.begin(), boxes.end());
    }

    GroundPoint at(const Eigen::Vector3d& x) const override
    {
        if (!x.allFinite()) return {.gap = std::numeric_limits<double>::quiet_NaN()}; // nothing is nearest
        NearestTriangle nearest{&mesh_, x};
        Eigen::BVMinimize(tree_, nearest);
        const auto& corners = mesh_.triangles[static_cast<std::size_t>(nearest.triangle)];
        const Simplex<3> triangle = mesh_.triangle(static_cast<std::size_t>(nearest.triangle));
        const Eigen::Vector3d area = area_vector(triangle), normal = area.normalized();
        const Eigen::Vector3d way = x - nearest.closest.point;
        std::vector<std::size_t> on; // the corners that carry the nearest point
        for (std::size_t c = 0; c < 3; ++c)
            if (nearest.closest.weight[c] > flat) on.push_back(c);
        if (on.size() == 3 || (way - normal * normal.dot(way)).norm() <= flat * std::sqrt(area.norm()))
            return {normal.dot(x - triangle[0]), normal, normal, Eigen::Matrix3d::Zero()};
        if (on.size() == 1) return rounded(way, normals_.corner(corners[on[0]]), Eigen::Vector3d::Zero());
        return rounded(way, normals_.edge(corners[on[0]], corners[on[1]]),
                       (triangle[on[1]] - triangle[on[0]]).normalized());
    }

private:
    /// What is flat, over the size of a triangle.
    static constexpr double flat = 1e-9;

    /// Around an edge along `t`, or a corner (t = 0), at distance d: gap = +-d, n = +-way/d, dn/dx = +-(P - t t^T)/d.
    static GroundPoint rounded(const Eigen::Vector3d& way, const PseudoNormals::Normal& pseudo,
                               const Eigen::Vector3d& t)
    {
        const double d = way.norm();
        const double sign = pseudo.rim || pseudo.vector.dot(way) >= 0 ? 1 : -1;
        GroundPoint ground;
        ground.gap = sign * d;
        ground.normal = ground.gap_slope = sign / d * way;
        ground.normal_slope =
            sign / d * (Eigen::Matrix3d::Identity() - ground.normal * ground.normal.transpose() - t * t.transpose());
        return ground;
    }

    TriangleMesh mesh_;
    PseudoNormals normals_;
    Tree tree_;
};

} // namespace

std::unique_ptr<Ground> make_surface_ground(TriangleMesh mesh, const std::string& what)
{
    require_input(!mesh.triangles.empty(), what, ": no triangle has an area");
    return std::make_unique<SurfaceGround>(std::move(mesh), what);
}

std::unique_ptr<Ground> make_polyline_ground(const std::string& path)
{
    const CsvTable table = read_csv(path);
    const auto &x = table.column("x"), &y = table.column("y");
    require_input(x.size() >= 2, path, ": a line needs two points at least, it has ", x.size());
    const auto [low, high] = std::ranges::minmax(x);
    double depth = high - low; // across the plane, far beyond where anything touches
    for (const double height : y) depth = std::max(depth, std::abs(height - y[0]));
    std::vector<Simplex<3>> strip;
    for (std::size_t k = 1; k < x.size(); ++k) {
        require_input(x[k] != x[k - 1] || y[k] != y[k - 1], path, ": the points ", k, " and ", k + 1,
                      " are the same, (", x[k], ", ", y[k], ") m");
        const auto corner = [&](std::size_t i, double z) { return Eigen::Vector3d(x[i], y[i], z); };
        strip.push_back({corner(k - 1, depth), corner(k, depth), corner(k, -depth)});
        strip.push_back({corner(k - 1, depth), corner(k, -depth), corner(k - 1, -depth)});
    }
    return make_surface_ground(join(strip), path);
}

} // namespace base
