// SPDX-License-Identifier: MIT
#include "coupler_lib/session/partner_description.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace coupler {
namespace {

namespace fs = std::filesystem;

/// As one word of a shell command.
std::string quoted(const std::string& word)
{
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

struct Answer {
    bool good = false;
    std::string text;
};

Answer answer_of(const std::string& command)
{
    Answer answer;
    FILE* pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
    if (!pipe) return answer;
    std::array<char, 4096> piece{};
    while (const std::size_t got = fread(piece.data(), 1, piece.size(), pipe)) answer.text.append(piece.data(), got);
    answer.good = pclose(pipe) == 0;
    return answer;
}

/// The program's own message, without the mark that it begins with.
std::string message_in(const std::string& text)
{
    const std::string mark = "rivage: ";
    const std::size_t at = text.find(mark);
    return at == std::string::npos ? text : text.substr(at + mark.size());
}

std::string command_line(const fs::path& program, const CommandLine& command, const std::string& role)
{
    std::string line =
        quoted(program.string()) + " " + quoted(command.file) + " --as " + quoted(role) + " --check --describe";
    for (const auto& [key, value] : command.overrides) line += " --set " + quoted(key + "=" + value);
    return line;
}

} // namespace

bool started_alone()
{
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
        if (std::getenv(name)) return false;
    return true;
}

std::vector<PartnerDescription> describe_partners(const CouplingConfig& config, const CommandLine& command,
                                                  const std::string& own_role)
{
    std::vector<PartnerDescription> partners;
    std::error_code unknown;
    const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    for (const auto& [role, participant] : config.participants) {
        if (role == own_role) continue;
        if (participant.is_from_outside()) {
            partners.push_back(
                {role, {}, participant.program + " is a solver from outside, which does not describe itself"});
            continue;
        }
        const fs::path program = folder / participant.program;
        if (!fs::exists(program)) {
            partners.push_back({role, {}, base::text(participant.program, " is not in ", folder.string())});
            continue;
        }
        const Answer answer = answer_of(command_line(program, command, role));
        base::require_input(answer.good, message_in(answer.text));
        partners.push_back({role, data_flow_from(answer.text), ""});
    }
    return partners;
}

} // namespace coupler
