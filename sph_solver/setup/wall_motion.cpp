// SPDX-License-Identifier: MIT
#include "sph_solver/setup/wall_motion.hpp"

#include "coupler_lib/base/csv_table.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <memory>

namespace sph {
namespace {

base::TimeFunction function_of(const base::Formula& formula, const MotionSpan& span)
{
    auto expression = std::make_shared<base::Expression>(formula, std::vector<std::string>{"t"});
    return base::with_derivatives([expression](double t) { return (*expression)({t}); }, span.derivative_step);
}

template<int D> void read_table(RigidMotion<D>& motion, const std::string& path, const MotionSpan& span)
{
    const base::CsvTable table = base::read_csv(path);
    const auto& time = table.column("t");
    base::require_input(time.front() <= span.start && time.back() >= span.end, path, ": the motion is given from ",
                        time.front(), " s to ", time.back(), " s, the run goes from ", span.start, " s to ", span.end,
                        " s");
    const char* names[] = {"x", "y", "z"};
    for (std::size_t a = 0; a < D; ++a) motion.translation[a] = base::spline_through(time, table.column(names[a]));
}

} // namespace

template<int D> RigidMotion<D> make_motion(const WallConfig& wall, const MotionSpan& span)
{
    const WallMotionConfig& config = wall.motion;
    RigidMotion<D> motion;
    for (std::size_t a = 0; a < config.translation.size(); ++a)
        motion.translation[a] = function_of(config.translation[a], span);
    if (!config.table.empty()) read_table(motion, config.table, span);
    if (config.rotation.text.empty()) return motion;
    motion.rotation = function_of(config.rotation, span);
    motion.centre = Eigen::Map<const Vec<D>>(config.centre.data());
    motion.axis = Eigen::Map<const Vec<3>>(config.axis.data()).normalized();
    return motion;
}

template RigidMotion<2> make_motion(const WallConfig&, const MotionSpan&);
template RigidMotion<3> make_motion(const WallConfig&, const MotionSpan&);

} // namespace sph
