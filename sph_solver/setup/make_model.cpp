// SPDX-License-Identifier: MIT
#include "sph_solver/setup/make_model.hpp"

namespace sph {
namespace {

Limiter make_limiter(const std::string& name)
{
    if (name == "none") return Unlimited{};
    if (name == "van_leer") return VanLeer{};
    if (name == "first_order") return FirstOrder{};
    return VanAlbada{};
}

Riemann make_riemann(const std::string& name)
{
    if (name == "two_rarefaction") return TwoRarefactionRiemann{};
    if (name == "acoustic") return AcousticRiemann{};
    return ExactRiemann{};
}

FaceMotion make_face_motion(const NumericsConfig& numerics)
{
    if (numerics.face_motion == "fluid") return FluidMotion{};
    if (numerics.face_motion == "shifted") return ShiftedMotion{numerics.shift_strength};
    return MeanMotion{};
}

PairArea make_pair_area(const std::string& name)
{
    if (name == "renormalised") return RenormalisedArea{};
    return RawArea{};
}

} // namespace

template<int D> FluidModel<D> make_model(const FluidConfig& config)
{
    return {CubicSpline<D>(config.resolution.smoothing_length()),
            Tait{config.liquid.density, config.liquid.sound_speed},
            make_limiter(config.numerics.limiter),
            Eigen::Map<const Vec<D>>(config.domain.gravity.data()),
            make_riemann(config.numerics.riemann),
            make_face_motion(config.numerics),
            make_pair_area(config.numerics.pair_area)};
}

template FluidModel<2> make_model(const FluidConfig&);
template FluidModel<3> make_model(const FluidConfig&);

} // namespace sph
