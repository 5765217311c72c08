// SPDX-License-Identifier: MIT
#pragma once
#include <fstream>
#include <string>
#include <vector>

namespace base {

/// A comma-separated table written row by row; the header names every column with its unit in brackets.
/// Opened by one rank only. Throws Error(bad_input) when the file cannot be made, with its path.
class CsvWriter {
public:
    CsvWriter(const std::string& path, const std::vector<std::string>& header);

    /// One row of as many values as the header has columns, 13 significant digits.
    void row(const std::vector<double>& values);
    void flush() { file_.flush(); }

private:
    std::string path_;
    std::ofstream file_;
    std::size_t columns_;
};

}  // namespace base
