// SPDX-License-Identifier: MIT
#include "sph_solver/output/field_output.hpp"

#include <array>

namespace sph {
namespace {

constexpr std::array<std::string_view, 6> written = {"id", "velocity", "pressure", "density", "volume", "mass"};

bool is_written(std::string_view name)
{
    for (const std::string_view candidate : written) {
        if (candidate == name) return true;
    }
    return false;
}

void append(std::vector<double>& numbers, double value) { numbers.push_back(value); }
void append(std::vector<double>& numbers, std::int64_t value) { numbers.push_back(static_cast<double>(value)); }

/// Vectors always take three numbers in the file.
template<int Rows> void append(std::vector<double>& numbers, const Eigen::Matrix<double, Rows, 1>& vector)
{
    for (int d = 0; d < 3; ++d) numbers.push_back(d < Rows ? vector[d] : 0.0);
}

template<int D> void append(std::vector<double>&, const Eigen::Matrix<double, D, D>&) {}

/// Numbers that a value of a field takes.
template<class T> constexpr int numbers_each = 1;
template<int Rows> constexpr int numbers_each<Eigen::Matrix<double, Rows, 1>> = 3;

template<class T> std::vector<double> owned_values(const std::vector<T>& column, const std::vector<int>& owned)
{
    std::vector<double> numbers;
    numbers.reserve(owned.size() * numbers_each<T>);
    for (const int i : owned) append(numbers, column[static_cast<std::size_t>(i)]);
    return numbers;
}

} // namespace

template<int D>
FieldOutput<D>::FieldOutput(const std::string& folder, const base::Communicator& comm)
    : comm_(comm), writer_(folder + "/fields", comm)
{}

template<int D> void FieldOutput<D>::write(double time, const Particles<D>& particles)
{
    std::vector<base::XdmfField> fields;
    for_each_field(particles, [&]<class T>(const FieldInfo& info, const std::vector<T>& column) {
        if (!is_written(info.name)) return;
        fields.push_back({std::string(info.name), std::string(info.unit_in(D)), std::string(info.description),
                          numbers_each<T>, [&] { return owned_values(column, particles.owned); }});
    });
    const auto ranks = [&] { return std::vector<double>(particles.owned.size(), static_cast<double>(comm_.rank())); };
    fields.push_back({"rank", "-", "rank that owns the particle", 1, ranks});
    writer_.write(time, {}, owned_values(particles.position, particles.owned), fields);
}

template class FieldOutput<2>;
template class FieldOutput<3>;

} // namespace sph
