// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/csv.hpp"
#include "fem_solver/dofs/contact_resultants.hpp"

#include <string>
#include <vector>

namespace fem {

/// contact.csv: one block of columns for each contact.
class ContactTable {
public:
    ContactTable(const std::string& folder, int dimension, const std::vector<std::string>& groups);
    void write(double time, const std::vector<ContactResultants>& rows);

private:
    int dimension_;
    base::CsvWriter file_;
};

} // namespace fem
