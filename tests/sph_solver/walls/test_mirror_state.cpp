// SPDX-License-Identifier: MIT
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

constexpr double sound_speed = 30;

template<int D> struct Cast {
    WallSettings<D> settings = unit_settings<D>();
    MirrorPlane<D> first, second;
    PrimitiveState<D> state;

    Cast()
    {
        settings.gravity = Vec<D>::Constant(-3);
        settings.gravity[D - 1] = -9;
        first.normal = Vec<D>::Constant(0.2);
        first.normal[0] = 1;
        first.normal.normalize();
        first.velocity = Vec<D>::LinSpaced(0.3, -0.5);
        first.acceleration = Vec<D>::LinSpaced(4, 7);
        first.push = 0.2;
        second.normal = Vec<D>::Unit(D - 1);
        second.velocity = Vec<D>::Constant(0.1);
        state.density = 1000;
        state.velocity = Vec<D>::LinSpaced(1, 2);
        state.density_gradient = Vec<D>::LinSpaced(-2, 5);
        for (int a = 0; a < D; ++a) state.velocity_gradient.row(a) = Vec<D>::LinSpaced(0.1 + a, 2.0 - a).transpose();
    }

    Image<D> image_at(const Vec<D>& x) const
    {
        Image<D> image;
        image.order = 1;
        image.path[0] = &first;
        image.height[0] = (x - first.point).dot(first.normal);
        return image;
    }
    static Vec<D> place(const Image<D>& image, const Vec<D>& x)
    {
        return x - 2 * image.height[0] * image.path[0]->normal;
    }
};

template<class T> class MirrorState : public testing::Test {};
template<int D> struct Dimension {
    static constexpr int value = D;
};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(MirrorState, Dimensions);

TYPED_TEST(MirrorState, HydrostaticPressureContinuesExactly)
{
    constexpr int D = TypeParam::value;
    Cast<D> cast;
    const Vec<D> x = Vec<D>::Constant(0.8);
    const auto image = cast.image_at(x);
    PrimitiveState<D> state = cast.state;
    mirror_state(state, image, sound_speed, cast.settings);
    const Vec<D> pull = cast.settings.gravity - cast.first.acceleration;
    const double expected = cast.state.density * pull.dot(Cast<D>::place(image, x) - x); // p' - p
    EXPECT_NEAR((state.density - cast.state.density) * sound_speed * sound_speed, expected, 1e-8);
}

TYPED_TEST(MirrorState, WallFeelsNoFlowThroughIt)
{
    constexpr int D = TypeParam::value;
    Cast<D> cast;
    PrimitiveState<D> state = cast.state;
    mirror_state(state, cast.image_at(Vec<D>::Constant(0.4)), sound_speed, cast.settings);
    const Vec<D> mean = 0.5 * (state.velocity + cast.state.velocity);
    const Vec<D> wall = cast.first.velocity + cast.first.push * cast.first.normal;
    EXPECT_NEAR((mean - wall).dot(cast.first.normal), 0, 1e-14); // the wall's speed along n
    const Vec<D> change = state.velocity - cast.state.velocity;
    EXPECT_NEAR((change - change.dot(cast.first.normal) * cast.first.normal).norm(), 0, 1e-14); // slip
    cast.first.no_slip = true;
    state = cast.state;
    mirror_state(state, cast.image_at(Vec<D>::Constant(0.4)), sound_speed, cast.settings);
    EXPECT_NEAR((0.5 * (state.velocity + cast.state.velocity) - wall).norm(), 0, 1e-14);
}

/// A field with the source's values and gradients around x, mirrored point by point.
template<int D> PrimitiveState<D> mirrored_at(const Cast<D>& cast, const Vec<D>& x, const Vec<D>& offset)
{
    PrimitiveState<D> state = cast.state;
    state.velocity += state.velocity_gradient * offset;
    mirror_state(state, cast.image_at(x + offset), sound_speed, cast.settings);
    // the source's density varies too, but only its size enters the correction, which is linear around rho of the state
    state.density += cast.state.density_gradient.dot(offset);
    return state;
}

TYPED_TEST(MirrorState, GradientsAreThoseOfTheMirroredField)
{
    constexpr int D = TypeParam::value;
    Cast<D> cast;
    for (const bool no_slip : {false, true}) {
        cast.first.no_slip = no_slip;
        const Vec<D> x = Vec<D>::Constant(0.6);
        PrimitiveState<D> state = cast.state;
        mirror_state(state, cast.image_at(x), sound_speed, cast.settings);
        for (int d = 0; d < D; ++d) {
            const double step = 1e-4;
            const Vec<D> ahead = step * Vec<D>::Unit(d);
            const Vec<D> source =
                ahead - 2 * ahead.dot(cast.first.normal) * cast.first.normal; // image moves by `ahead`
            const auto plus = mirrored_at<D>(cast, x, source), minus = mirrored_at<D>(cast, x, -source);
            EXPECT_NEAR((plus.density - minus.density) / (2 * step), state.density_gradient[d], 1e-6);
            const Vec<D> slope = (plus.velocity - minus.velocity) / (2 * step);
            EXPECT_NEAR((slope - state.velocity_gradient.col(d)).norm(), 0, 1e-8);
        }
    }
}

} // namespace
} // namespace sph
