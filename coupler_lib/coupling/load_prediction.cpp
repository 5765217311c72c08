// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/load_prediction.hpp"

namespace coupler {
namespace {

class LaggedLoad final : public LoadPrediction {
public:
    void apply(SurfaceLoad&, const std::vector<double>&, double) override {}
};

class ExtrapolatedLoad final : public LoadPrediction {
public:
    void apply(SurfaceLoad& load, const std::vector<double>&, double dt) override
    {
        const double middle = time_ - 0.5 * last_dt_; // time_ is t_n
        const double share = last_dt_ > 0 ? (time_ + dt - middle) / (middle - last_middle_) : 0;
        carry_on(load.force, last_force_, share);
        carry_on(load.pressure, last_pressure_, share);
        last_middle_ = middle;
        time_ += dt;
        last_dt_ = dt;
    }

private:
    /// Replaces `values` by their extrapolation, and `last` by what they were.
    static void carry_on(std::vector<double>& values, std::vector<double>& last, double share)
    {
        last.resize(values.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double now = values[k];
            if (share > 0) values[k] += share * (now - last[k]);
            last[k] = now;
        }
    }

    std::vector<double> last_force_, last_pressure_;
    double time_ = 0, last_dt_ = 0, last_middle_ = 0;
};

class SmoothedReference final : public LoadPrediction {
public:
    explicit SmoothedReference(int steps) : steps_(steps) {}

    void apply(SurfaceLoad& load, const std::vector<double>& velocity, double dt) override
    {
        smooth_.resize(velocity.size(), 0.0);
        if (last_dt_ > 0)
            for (std::size_t k = 0; k < velocity.size(); ++k)
                smooth_[k] += ((velocity[k] - last_velocity_[k]) / last_dt_ - smooth_[k]) / steps_;
        const double lag = dt + 0.5 * last_dt_;
        for (std::size_t k = 0; k < load.wall_velocity.size(); ++k) load.wall_velocity[k] += lag * smooth_[k];
        last_velocity_ = velocity;
        last_dt_ = dt;
    }

private:
    int steps_;
    std::vector<double> smooth_, last_velocity_;
    double last_dt_ = 0;
};

} // namespace

std::unique_ptr<LoadPrediction> make_lagged_load() { return std::make_unique<LaggedLoad>(); }
std::unique_ptr<LoadPrediction> make_extrapolated_load() { return std::make_unique<ExtrapolatedLoad>(); }
std::unique_ptr<LoadPrediction> make_smoothed_reference(int steps)
{
    return std::make_unique<SmoothedReference>(steps);
}

} // namespace coupler
