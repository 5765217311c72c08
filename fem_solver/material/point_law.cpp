// SPDX-License-Identifier: MIT
#include "fem_solver/material/point_law.hpp"

#include "fem_solver/material/plane_stress.hpp"

namespace fem {
namespace {

template<int D, class LawType> class OneLaw final : public PointLaw<D> {
public:
    explicit OneLaw(LawType law) : law_(std::move(law)) {}

    double energy(const Tensor<D>& f) const override { return law_.template energy<D>(f); }
    Tensor<D> stress(const Tensor<D>& f) const override { return law_.template stress<D>(f); }
    Tangent<D> tangent(const Tensor<D>& f) const override { return law_.template tangent<D>(f); }
    Eigen::Matrix3d cauchy(const Tensor<D>& f) const override { return cauchy_stress<LawType, D>(law_, f); }
    bool finite() const override { return LawType::finite; }
    double shear_modulus() const override { return law_.shear_modulus(); }

private:
    LawType law_;
};

} // namespace

template<int D> std::unique_ptr<PointLaw<D>> make_point_law(const Law& law)
{
    return std::visit(
        [](const auto& known) -> std::unique_ptr<PointLaw<D>> {
            return std::make_unique<OneLaw<D, std::decay_t<decltype(known)>>>(known);
        },
        law);
}

template<> std::unique_ptr<PointLaw<2>> make_point_law<2>(const Material& material)
{
    if (material.sheet == Sheet::plane_stress) return make_plane_stress(make_point_law<3>(material.law));
    return make_point_law<2>(material.law);
}
template<> std::unique_ptr<PointLaw<3>> make_point_law<3>(const Material& material)
{
    return make_point_law<3>(material.law);
}

template std::unique_ptr<PointLaw<2>> make_point_law<2>(const Law&);
template std::unique_ptr<PointLaw<3>> make_point_law<3>(const Law&);

} // namespace fem
