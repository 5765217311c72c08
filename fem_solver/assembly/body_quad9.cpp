// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/make_body.hpp"

namespace fem {

template std::unique_ptr<SolidBody> make_element_body<Quad9>(const Mesh&, const MatrixPattern&, const Material&,
                                                             const BodySettings&);

} // namespace fem
