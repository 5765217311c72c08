// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/csv.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace fem {

/// What one contact does at one instant: force of the pressures and of friction on the body [N] (2D: N/m), area in contact
/// [m^2] (2D: m), largest pressure [Pa], deepest penetration [m].
struct ContactRow {
    Eigen::Vector3d normal, friction;
    double area, pressure, penetration;
};

/// contact.csv: one block of columns for each contact.
class ContactTable {
public:
    ContactTable(const std::string& folder, int dimension, const std::vector<std::string>& groups);
    void write(double time, const std::vector<ContactRow>& rows);

private:
    int dimension_;
    base::CsvWriter file_;
};

} // namespace fem
