// SPDX-License-Identifier: MIT
#include "fem_solver/output/contact_table.hpp"

namespace fem {
namespace {

std::vector<std::string> contact_columns(int dimension, const std::vector<std::string>& groups)
{
    std::vector<std::string> columns{"t[s]"};
    const std::string force = dimension == 2 ? "[N/m]" : "[N]";
    for (const std::string& group : groups) {
        for (const char* kind : {".normal_", ".friction_"})
            for (int k = 0; k < dimension; ++k) columns.push_back(group + kind + "xyz"[k] + force);
        columns.push_back(group + ".area" + (dimension == 2 ? "[m]" : "[m^2]"));
        columns.push_back(group + ".pressure[Pa]");
        columns.push_back(group + ".penetration[m]");
    }
    return columns;
}

} // namespace

ContactTable::ContactTable(const std::string& folder, int dimension, const std::vector<std::string>& groups)
    : dimension_(dimension), file_(folder + "/contact.csv", contact_columns(dimension, groups))
{}

void ContactTable::write(double time, const std::vector<ContactResultants>& rows)
{
    std::vector<double> values{time};
    for (const ContactResultants& row : rows) {
        values.insert(values.end(), row.normal.data(), row.normal.data() + dimension_);
        values.insert(values.end(), row.friction.data(), row.friction.data() + dimension_);
        values.insert(values.end(), {row.area, row.pressure, row.penetration});
    }
    file_.row(values);
    file_.flush();
}

} // namespace fem
