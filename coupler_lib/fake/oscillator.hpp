// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace coupler {

/// A mass on a spring, per wet area: m a + k u = f + m g, with u, g and f along one axis.
struct OscillatorConfig {
    double mass = 0;                ///< m [kg/m^2]
    double stiffness = 0;           ///< k [N/m^3]
    double displacement = 0;        ///< u at the start, from the relaxed spring [m]
    double velocity = 0;            ///< at the start [m/s]
    double gravity = 0;             ///< g, positive along the axis [m/s^2]
    std::string integrator = "hht"; ///< hht | exact
    double alpha = -0.05;           ///< of HHT, -1/3 .. 0; 0 is the trapezoidal rule
};

/// The load during a step: f_1 = load - Z (v_1 - vbar), Z = 0 without impedance correction.
struct OscillatorLoad {
    double load = 0;          ///< as received, along the axis [Pa]
    double impedance = 0;     ///< Z [kg/(m^2 s)]
    double mean_velocity = 0; ///< vbar: of the wall while the fluid measured the load [m/s]
};

/// Integrates the oscillator as fem_solver does a mesh.
///
///     HHT: m a_1 + (1+alpha) g_1 - alpha g_0 = 0,  g = k u - m g - f,  f_0 = f_1 of the last step
///     u_1 = u_0 + dt v_0 + dt^2 [(1/2-beta) a_0 + beta a_1],  v_1 = v_0 + dt [(1-gamma) a_0 + gamma a_1]
///     beta = (1-alpha)^2/4,  gamma = 1/2 - alpha
///
/// `exact`: the exact motion under the constant load f - Z (v - vbar). Energies close by HHT's discrete identity
/// (docs/theory/solid.md) to round-off; all are per area [J/m^2].
class Oscillator {
public:
    /// Throws base::Error(bad_input) when m, k or alpha cannot be.
    explicit Oscillator(const OscillatorConfig& config);

    /// Solves m a_0 = f_0 + m g - k u_0 at the start.
    void start(double load);
    void advance(const OscillatorLoad& load, double dt);

    double displacement() const { return u_; }
    double velocity() const { return v_; }
    double acceleration() const { return a_; }
    double applied_load() const { return f_; } ///< f_1 of the last step [Pa]
    double kinetic() const { return 0.5 * config_.mass * v_ * v_; }
    double strain() const { return 0.5 * config_.stiffness * u_ * u_; }
    double potential() const { return -config_.mass * config_.gravity * u_; }
    double work() const { return work_; }                         ///< of the load since the start
    double numerical_dissipation() const { return dissipation_; } ///< since the start; of either sign
    /// kinetic + strain + potential + dissipation - work, minus the same at the start.
    double balance_error() const;

private:
    void advance_hht(const OscillatorLoad& load, double dt);
    void advance_exact(const OscillatorLoad& load, double dt);

    OscillatorConfig config_;
    double u_ = 0, v_ = 0, a_ = 0, f_ = 0;
    double weighted_load_ = 0, weighted_spring_ = 0; ///< fh_0 of the load and of the spring
    double work_ = 0, dissipation_ = 0, energy_start_ = 0;
};

} // namespace coupler
