// SPDX-License-Identifier: MIT
#include "coupler_lib/base/ground.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace base {
namespace {

class Plane final : public Ground {
public:
    Plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) : point_(point), normal_(normal) {}

    GroundPoint at(const Eigen::Vector3d& x) const override
    {
        return {normal_.dot(x - point_), normal_, normal_, Eigen::Matrix3d::Zero()};
    }

private:
    Eigen::Vector3d point_, normal_;
};

class HeightGround final : public Ground {
public:
    HeightGround(std::unique_ptr<HeightField> height, int dimension) : height_(std::move(height)), dimension_(dimension)
    {}

    GroundPoint at(const Eigen::Vector3d& x) const override
    {
        const bool flat = dimension_ == 2;
        const int up = dimension_ - 1;
        const Height h = height_->at(x[0], flat ? 0 : x[1]);
        Eigen::Vector3d m = Eigen::Vector3d::Zero();
        Eigen::Matrix3d dm = Eigen::Matrix3d::Zero(); // dm/dx
        m[up] = 1;
        m[0] = -h.slope[0];
        dm(0, 0) = -h.curvature[0];
        if (!flat) {
            m[1] = -h.slope[1];
            dm(0, 1) = dm(1, 0) = -h.curvature[1];
            dm(1, 1) = -h.curvature[2];
        }
        GroundPoint ground;
        const double s = m.norm();
        ground.normal = m / s;
        ground.gap = (x[up] - h.value) / s;
        ground.normal_slope = (dm - ground.normal * (ground.normal.transpose() * dm)) / s;
        ground.gap_slope = ground.normal - ground.gap / s * (dm.transpose() * ground.normal);
        return ground;
    }

private:
    std::unique_ptr<HeightField> height_;
    int dimension_;
};

class HeightFormula final : public HeightField {
public:
    HeightFormula(const Formula& formula, int dimension, double step)
        : expression_(formula, dimension == 2 ? std::vector<std::string>{"x"} : std::vector<std::string>{"x", "y"}),
          flat_(dimension == 2),
          step_(step)
    {}

    Height at(double x, double y) const override
    {
        const auto along_x = [&](double s) { return value(x + s, y); };
        const auto along_y = [&](double s) { return value(x, y + s); };
        Height h;
        h.value = value(x, y);
        h.slope[0] = slope(along_x);
        h.curvature[0] = curvature(along_x, h.value);
        if (flat_) return h;
        h.slope[1] = slope(along_y);
        h.curvature[1] = slope([&](double s) { return slope([&](double r) { return value(x + r, y + s); }); });
        h.curvature[2] = curvature(along_y, h.value);
        return h;
    }

private:
    double value(double x, double y) const { return flat_ ? expression_({x}) : expression_({x, y}); }
    template<class F> double slope(const F& f) const
    {
        return (8 * (f(step_) - f(-step_)) - (f(2 * step_) - f(-2 * step_))) / (12 * step_);
    }
    template<class F> double curvature(const F& f, double middle) const
    {
        return (16 * (f(step_) + f(-step_)) - (f(2 * step_) + f(-2 * step_)) - 30 * middle) / (12 * step_ * step_);
    }

    Expression expression_;
    bool flat_;
    double step_;
};

} // namespace

std::unique_ptr<Ground> make_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
{
    require_input(normal.norm() > 0, "a plane's normal has no length");
    return std::make_unique<Plane>(point, normal.normalized());
}

std::unique_ptr<Ground> make_height_ground(std::unique_ptr<HeightField> height, int dimension)
{
    return std::make_unique<HeightGround>(std::move(height), dimension);
}

std::unique_ptr<HeightField> make_height_formula(const Formula& formula, int dimension, double step)
{
    return std::make_unique<HeightFormula>(formula, dimension, step);
}

} // namespace base
