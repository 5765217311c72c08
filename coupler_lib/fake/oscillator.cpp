// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/oscillator.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <cmath>

namespace coupler {

Oscillator::Oscillator(const OscillatorConfig& config) : config_(config), u_(config.displacement), v_(config.velocity)
{
    base::require_input(config.mass > 0, "the piston's mass is ", config.mass, " kg/m^2; it must be positive");
    base::require_input(config.stiffness >= 0, "the spring's stiffness is ", config.stiffness,
                        " N/m^3; it cannot be negative");
    base::require_input(config.alpha >= -1.0 / 3.0 && config.alpha <= 0, "alpha is ", config.alpha,
                        "; HHT takes -1/3 to 0");
    energy_start_ = kinetic() + strain() + potential();
}

void Oscillator::start(double load)
{
    f_ = load;
    a_ = (load + config_.mass * config_.gravity - config_.stiffness * u_) / config_.mass;
    weighted_load_ = load;
    weighted_spring_ = config_.stiffness * u_;
}

void Oscillator::advance(const OscillatorLoad& load, double dt)
{
    config_.integrator == "exact" ? advance_exact(load, dt) : advance_hht(load, dt);
}

void Oscillator::advance_hht(const OscillatorLoad& load, double dt)
{
    const double m = config_.mass, k = config_.stiffness, alpha = config_.alpha;
    const double beta = (1 - alpha) * (1 - alpha) / 4, gamma = 0.5 - alpha;
    const double u_predicted = u_ + dt * v_ + dt * dt * (0.5 - beta) * a_;
    const double v_predicted = v_ + dt * (1 - gamma) * a_;
    const double z = load.impedance;
    const double spring_0 = k * u_, load_0 = f_, weight = m * config_.gravity;
    // f_1 = load - Z (v_predicted + gamma dt a_1 - vbar): linear in a_1.
    const double matrix = m + (1 + alpha) * (k * beta * dt * dt + z * gamma * dt);
    const double force = (1 + alpha) * (load.load - z * (v_predicted - load.mean_velocity) - k * u_predicted) -
                         alpha * (load_0 - spring_0) + weight;
    const double a_1 = force / matrix;
    const double u_1 = u_predicted + beta * dt * dt * a_1, v_1 = v_predicted + gamma * dt * a_1;
    const double f_1 = load.load - z * (v_1 - load.mean_velocity);

    const double weighted_load_1 = (1 + alpha) * f_1 - alpha * load_0;
    const double weighted_spring_1 = (1 + alpha) * k * u_1 - alpha * spring_0;
    const double du = u_1 - u_, da = a_1 - a_;
    const double spring_work = du * ((1 - gamma) * weighted_spring_ + gamma * weighted_spring_1);
    work_ += du * ((1 - gamma) * weighted_load_ + gamma * weighted_load_1);
    dissipation_ += spring_work - 0.5 * k * (u_1 * u_1 - u_ * u_) +
                    dt * dt * (beta - gamma / 2) * m * (0.5 * (a_1 * a_1 - a_ * a_) + (gamma - 0.5) * da * da);
    u_ = u_1;
    v_ = v_1;
    a_ = a_1;
    f_ = f_1;
    weighted_load_ = weighted_load_1;
    weighted_spring_ = weighted_spring_1;
}

/// m u'' + Z u' + k u = F with F = load + Z vbar + m g constant: closed form about the state at the start of the step.
void Oscillator::advance_exact(const OscillatorLoad& load, double dt)
{
    const double m = config_.mass, z = load.impedance, k = config_.stiffness;
    const double force = load.load + z * load.mean_velocity + m * config_.gravity;
    const double damping = z / (2 * m), square = k / m - damping * damping;
    const double a_0 = (force - z * v_ - k * u_) / m;
    const double root = std::sqrt(std::abs(square)), decay = std::exp(-damping * dt);
    // The velocity solves v'' + 2 damping v' + (k/m) v = 0 with v(0) = v_0, v'(0) = a_0.
    const double c = square >= 0 ? std::cos(root * dt) : std::cosh(root * dt);
    const double s = root * dt < 1e-8 ? dt : (square >= 0 ? std::sin(root * dt) : std::sinh(root * dt)) / root;
    const double v_1 = decay * (v_ * c + (a_0 + damping * v_) * s);
    const double a_1 = decay * (a_0 * c - (damping * a_0 + k / m * v_) * s);
    const double before = kinetic() + strain() + potential();
    const double u_0 = u_;
    if (k > 0) {
        u_ = (force - z * v_1 - m * a_1) / k;
    } else {
        base::require_input(z == 0, "a piston without a spring and with an impedance needs integrator = \"hht\"");
        u_ = u_0 + dt * v_ + 0.5 * dt * dt * a_0;
    }
    v_ = v_1;
    a_ = a_1;
    f_ = load.load - z * (v_ - load.mean_velocity);
    work_ += kinetic() + strain() + potential() - before;
}

double Oscillator::balance_error() const
{
    return kinetic() + strain() + potential() + dissipation_ - work_ - energy_start_;
}

} // namespace coupler
