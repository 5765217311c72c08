// SPDX-License-Identifier: MIT
#include "coupler_lib/base/csv_table.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <charconv>
#include <cmath>
#include <fstream>

namespace base {
namespace {

std::string trimmed(const std::string& word)
{
    const auto first = word.find_first_not_of(" \t\r\"");
    return first == std::string::npos ? "" : word.substr(first, word.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> words_of(const std::string& line)
{
    std::vector<std::string> words;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = line.find(',', begin);
        words.push_back(trimmed(line.substr(begin, end == std::string::npos ? end : end - begin)));
    }
    return words;
}

double number_of(const std::string& word, const std::string& place)
{
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    require_input(error == std::errc{} && stop == end && std::isfinite(value), place, ": \"", word, "\" is no number");
    return value;
}

void add_row(CsvTable& table, const std::vector<std::string>& words, const std::string& place)
{
    require_input(words.size() == table.names.size(), place, ": ", words.size(), " values under ", table.names.size(),
                  " columns");
    for (std::size_t c = 0; c < words.size(); ++c) table.columns[c].push_back(number_of(words[c], place));
}

} // namespace

const std::vector<double>& CsvTable::column(const std::string& name) const
{
    std::string there;
    for (std::size_t c = 0; c < names.size(); ++c) {
        if (names[c] == name || names[c].substr(0, names[c].find('[')) == name) return columns[c];
        there += (c > 0 ? ", " : "") + names[c];
    }
    throw Error(ExitCode::bad_input, text(path, ": there is no column \"", name, "\"; there are ", there));
}

CsvTable read_csv(const std::string& path)
{
    std::ifstream file(path);
    require_input(file.good(), "cannot read the file '", path, "'; is the path right?");
    CsvTable table;
    table.path = path;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
        if (table.names.empty()) {
            table.names = words_of(line);
            table.columns.resize(table.names.size());
        } else {
            add_row(table, words_of(line), text(path, ":", number));
        }
    }
    require_input(!table.names.empty() && !table.columns[0].empty(), path, ": the table has no rows");
    return table;
}

} // namespace base
