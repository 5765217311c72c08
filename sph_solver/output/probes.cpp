// SPDX-License-Identifier: MIT
#include "sph_solver/output/probes.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace sph {

template<int D> std::unique_ptr<Probe<D>> make_probe(const ProbeConfig& config, const ProbeScale<D>& scale)
{
    if (auto probe = make_point_probe<D>(config, scale)) return probe;
    if (auto probe = make_body_probe<D>(config, scale)) return probe;
    throw base::Error(base::ExitCode::bad_input,
                      base::text("probe \"", config.name, "\": there is no quantity \"", config.quantity, "\""));
}

template<int D> Probes<D>::Probes(const std::vector<ProbeConfig>& probes, const CubicSpline<D>& kernel, double spacing)
{
    for (const ProbeConfig& probe : probes) {
        names_.push_back(probe.name);
        probes_.push_back(make_probe<D>(probe, {kernel, spacing}));
    }
}

template<int D> std::vector<std::string> Probes<D>::columns() const
{
    std::vector<std::string> columns;
    for (std::size_t k = 0; k < probes_.size(); ++k)
        for (const std::string& column : probes_[k]->columns()) columns.push_back(names_[k] + column);
    return columns;
}

template<int D>
std::vector<double> Probes<D>::values(const Particles<D>& particles, const base::Communicator& comm) const
{
    std::vector<double> values;
    for (const auto& probe : probes_) probe->append(values, particles, comm);
    return values;
}

template std::unique_ptr<Probe<2>> make_probe(const ProbeConfig&, const ProbeScale<2>&);
template std::unique_ptr<Probe<3>> make_probe(const ProbeConfig&, const ProbeScale<3>&);
template class Probes<2>;
template class Probes<3>;

} // namespace sph
