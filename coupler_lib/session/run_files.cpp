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

/// Of the file and all overrides, which all participants must agree on.
std::string config_hash(const CommandLine& command)
{
    std::string hashed = content_of(command.file);
    for (const auto& [key, value] : command.overrides) hashed += "\n" + key + "=" + value;
    return hash_of(hashed);
}

/// \param used gets the file as TOML, defaults filled in
CouplingConfig read_shared(base::ConfigDocument document, const CommandLine& command, const std::string& role,
                           std::string& used)
{
    apply_overrides(document, "coupling", command);
    base::ConfigReader reader(document);
    CouplingConfig config = read_coupling_config(reader);
    used = reader.used();
    auto prefixes = config.roles();
    base::require_input(std::ranges::find(prefixes, role) != prefixes.end(), "--as ", role, ": ", command.file,
                        " has no [participants.", role, "]", base::suggestion(role, prefixes));
    prefixes.push_back("coupling");
    check_prefixes(command, prefixes);
    return config;
}

} // namespace

SharedFile read_shared_file(const std::string& path, const std::string& role,
                            const std::vector<std::pair<std::string, std::string>>& overrides)
{
    CommandLine command;
    command.file = path;
    command.overrides = overrides;
    std::string used;
    return {read_shared(base::ConfigDocument::load(path), command, role, used), config_hash(command)};
}

RunFiles read_run_files(const ProgramInfo& program, const CommandLine& command)
{
    RunFiles files;
    const fs::path path(command.file);
    files.role = command.role.empty() ? program.default_role : command.role;
    files.case_dir = path.has_parent_path() ? path.parent_path().string() : ".";
    files.output_dir = command.output_dir.empty() ? default_output_dir(files.case_dir) : command.output_dir;
    files.coupling_file = command.file;

    const auto document = base::ConfigDocument::load(command.file);
    files.config_hash = config_hash(command);
    if (!document.root().find("participants")) {
        check_prefixes(command, {files.role});
        read_own(program, command, command.file, files);
        return files;
    }
    files.coupling = read_shared(document, command, files.role, files.used_coupling);
    for (const auto& [name, participant] : files.coupling->participants)
        if (name == files.role) {
            base::require_input(!participant.file.empty(), command.file, ": [participants.", name,
                                "] names no file = \"...\", which ", program.name, " needs");
            read_own(program, command, (fs::path(files.case_dir) / participant.file).string(), files);
        }
    return files;
}

} // namespace coupler
