// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace base {

/// A table of numbers from a comma-separated file: lines that begin with # say where it comes from, the first other line
/// names the columns, with units in brackets.
struct CsvTable {
    std::string path;
    std::vector<std::string> names;           ///< as written, "x[m]"
    std::vector<std::vector<double>> columns; ///< one for each name, all of the same length

    /// The column called `name` ("x" or "x[m]"). Throws Error(bad_input) with the columns that there are.
    const std::vector<double>& column(const std::string& name) const;
};

/// Throws Error(bad_input) with file and line for a missing file, a value that is no number and rows of other lengths.
CsvTable read_csv(const std::string& path);

} // namespace base
