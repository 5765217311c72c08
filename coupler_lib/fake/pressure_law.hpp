// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace coupler {

/// The prescribed pressure of the fake fluid.
struct PressureConfig {
    std::string kind = "constant"; ///< constant | ramp | sine | hydrostatic
    double value = 0;              ///< constant, end of the ramp, amplitude of the sine [Pa]
    double duration = 1;           ///< of the ramp [s]
    double frequency = 1;          ///< of the sine [Hz]
    double level = 0;              ///< hydrostatic: height y of the surface [m]
    double density = 1000;         ///< hydrostatic [kg/m^3]
    double gravity = 9.81;         ///< hydrostatic, downwards [m/s^2]
};

///     constant: value              ramp: value min(t/duration, 1)
///     sine: value sin(2 pi f t)    hydrostatic: density gravity max(level - y, 0)
/// \param y height [m] \param t time [s] \return [Pa]
double pressure_at(const PressureConfig& law, double y, double t);

} // namespace coupler
