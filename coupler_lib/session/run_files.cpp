// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/nearest_name.hpp"
#include "coupler_lib/session/session.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace coupler {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits, as 16 hexadecimal digits.
std::string hash_of(const std::string& content)
{
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

std::string content_of(const std::string& path)
{
    std::ifstream file(path);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

/// The overrides whose first part is `prefix`, without it.
void apply_overrides(base::ConfigDocument& document, const std::string& prefix, const CommandLine& command)
{
    for (const auto& [key, value] : command.overrides)
        if (key.rfind(prefix + ".", 0) == 0) document.override_key(key.substr(prefix.size() + 1), value);
}

void check_prefixes(const CommandLine& command, std::vector<std::string> known)
{
    for (const auto& [key, value] : command.overrides) {
        const std::string prefix = key.substr(0, key.find('.'));
        base::require_input(std::find(known.begin(), known.end(), prefix) != known.end() && key.size() > prefix.size(),
                            "--set ", key, "=", value, ": a key begins with a participant's name or 'coupling'",
                            base::suggestion(prefix, known));
    }
}

std::string default_output_dir(const fs::path& folder)
{
    const std::string name = fs::absolute(folder).lexically_normal().filename().string();
    return "runs/" + (name.empty() ? "run" : name);
}

void read_own(const ProgramInfo& program, const CommandLine& command, const std::string& path, RunFiles& files)
{
    files.own_file = path;
    files.own_hash = hash_of(content_of(path));
    files.own = base::ConfigDocument::load(path);
    apply_overrides(files.own, files.role, command);
    base::ConfigReader reader(files.own);
    program.read_own_file(reader);
    files.used_own = reader.used();
}

void read_shared(const base::ConfigDocument& document, const CommandLine& command, RunFiles& files)
{
    base::ConfigReader reader(document);
    files.coupling = read_coupling_config(reader);
    files.used_coupling = reader.used();
    const auto roles = files.coupling->roles();
    base::require_input(std::find(roles.begin(), roles.end(), files.role) != roles.end(), "--as ", files.role, ": ",
                        command.file, " has no [participants.", files.role, "]", base::suggestion(files.role, roles));
    auto prefixes = roles;
    prefixes.push_back("coupling");
    check_prefixes(command, prefixes);
}

} // namespace

RunFiles read_run_files(const ProgramInfo& program, const CommandLine& command)
{
    RunFiles files;
    const fs::path path(command.file);
    files.role = command.role.empty() ? program.default_role : command.role;
    files.case_dir = path.has_parent_path() ? path.parent_path().string() : ".";
    files.output_dir = command.output_dir.empty() ? default_output_dir(files.case_dir) : command.output_dir;
    files.coupling_file = command.file;

    auto document = base::ConfigDocument::load(command.file);
    std::string hashed = content_of(command.file);
    for (const auto& [key, value] : command.overrides) hashed += "\n" + key + "=" + value;
    files.config_hash = hash_of(hashed);

    if (!document.root().find("participants")) {
        check_prefixes(command, {files.role});
        read_own(program, command, command.file, files);
        return files;
    }
    apply_overrides(document, "coupling", command);
    read_shared(document, command, files);
    for (const auto& [name, participant] : files.coupling->participants)
        if (name == files.role)
            read_own(program, command, (fs::path(files.case_dir) / participant.file).string(), files);
    return files;
}

} // namespace coupler
