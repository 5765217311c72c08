// SPDX-License-Identifier: MIT
#include "sph_solver/time/runge_kutta.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace sph {

RungeKutta::RungeKutta(const std::string& name)
{
    if (name == "rk2") stages_ = {{0.0, 0.0, 0.5}, {0.5, 1.0, 0.0}};
    if (name == "hybrid3") stages_ = {{0.0, 0.0, 0.15}, {0.15, 0.0, 0.5, Slopes::kept}, {0.5, 1.0, 0.0, Slopes::kept}};
    if (name == "rk3") stages_ = {{0.0, 0.25, 1.0 / 3.0}, {1.0 / 3.0, 0.0, 2.0 / 3.0}, {2.0 / 3.0, 0.75, 0.0}};
    if (name == "rk4")
        stages_ = {{0.0, 1.0 / 6.0, 0.5}, {0.5, 1.0 / 3.0, 0.5}, {0.5, 1.0 / 3.0, 1.0}, {1.0, 1.0 / 6.0, 0.0}};
    base::require_input(!stages_.empty(), "numerics.integrator = \"", name,
                        "\" is not known; use rk2, rk3, rk4 or hybrid3");
}

} // namespace sph
