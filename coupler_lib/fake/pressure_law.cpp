// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/pressure_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coupler {

double pressure_at(const PressureConfig& law, double y, double t)
{
    if (law.kind == "ramp") return law.value * std::min(t / law.duration, 1.0);
    if (law.kind == "sine") return law.value * std::sin(2 * std::numbers::pi * law.frequency * t);
    if (law.kind == "hydrostatic") return law.density * law.gravity * std::max(law.level - y, 0.0);
    return law.value;
}

} // namespace coupler
