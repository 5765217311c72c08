// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/solid_body.hpp"

namespace fem {

template<class Shape>
std::unique_ptr<SolidBody> make_element_body(const Mesh& mesh, const MatrixPattern& pattern, const Material& material,
                                             const BodySettings& settings); // body_quad4.cpp and so on

std::unique_ptr<SolidBody> make_solid_body(const Mesh& mesh, const MatrixPattern& pattern, const Material& material,
                                           const BodySettings& settings)
{
    check_jacobians(mesh);
    return with_shape(
        mesh.type, [&](auto shape) { return make_element_body<decltype(shape)>(mesh, pattern, material, settings); });
}

} // namespace fem
