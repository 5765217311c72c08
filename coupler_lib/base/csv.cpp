// SPDX-License-Identifier: MIT
#include "coupler_lib/base/csv.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <cstdio>

namespace base {

CsvWriter::CsvWriter(const std::string& path, const std::vector<std::string>& header)
    : path_(path), file_(path), columns_(header.size())
{
    require_input(file_.good(), "cannot write the file '", path, "'; does its folder exist, is the disk full?");
    for (std::size_t k = 0; k < header.size(); ++k) file_ << (k ? "," : "") << header[k];
    file_ << '\n' << std::flush;
}

void CsvWriter::row(const std::vector<double>& values)
{
    ensure(values.size() == columns_, "a CSV row has as many values as its header has columns");
    std::string line;
    char buffer[32];
    for (std::size_t k = 0; k < values.size(); ++k) {
        std::snprintf(buffer, sizeof buffer, k ? ",%.13g" : "%.13g", values[k]);
        line += buffer;
    }
    file_ << line << '\n';
    require(file_.good(), ExitCode::numerical_failure, "cannot write to '", path_, "'; is the disk full?");
}

}  // namespace base
