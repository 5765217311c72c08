// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace coupler {

/// What a program of Rivage can be told on its command line.
struct CommandLine {
    std::string file;       ///< coupling.toml, or the program's own file to run alone
    std::string role;       ///< --as
    std::string output_dir; ///< --out
    std::vector<std::pair<std::string, std::string>> overrides; ///< --set KEY=VALUE, in order
    bool check_only = false;                                    ///< --check
    bool describe = false; ///< --describe: print what the check needs, nothing else
    std::string replay;    ///< --replay: the recording that stands for the partner
};

/// What came of reading a command line: go on, or leave at once with a text for the terminal.
struct ParsedCommandLine {
    CommandLine command;
    bool leave = false;
    int code = 0;
    std::string text;
};

/// \param program   name of the executable, for the help
/// \param purpose   one sentence for the help
/// \param key_help  called for --help-config
ParsedCommandLine parse_command_line(int argc, char** argv, const std::string& program, const std::string& purpose,
                                     std::string (*key_help)(const void* context), const void* context);

} // namespace coupler
