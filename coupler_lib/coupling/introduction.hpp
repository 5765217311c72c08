// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

namespace coupler {

/// A part of the command that starts a run.
struct LaunchSegment {
    std::string role;
    std::string command; ///< "sph_solver coupling.toml"
};

/// "mpirun -n 2 sph_solver coupling.toml : -n 1 fem_solver coupling.toml"; empty without segments.
/// \param ranks of each role; 1 for those that it does not name
std::string launch_line(const std::vector<LaunchSegment>& segments, const std::map<std::string, int>& ranks = {});

/// What every rank tells world rank 0 about itself right after MPI_Init.
struct Introduction {
    std::string role;
    std::vector<std::string> expected_roles;
    std::string config_file;
    std::string config_hash;
    std::string program;               ///< name of the executable
    std::string own_file;              ///< the role's own configuration
    std::string own_hash;              ///< of its content
    std::string version;               ///< git hash
    std::string libraries;             ///< "Open MPI v4.1.4, HDF5 1.10.8"
    std::vector<LaunchSegment> launch; ///< what starts the whole run, or nothing
    std::string failure;               ///< message of an error met before the handshake, or empty
    int failure_code = 0;              ///< its exit code, 0: none
    std::string host;
    int pid = 0;
    int appnum = 0; ///< launch segment of mpirun; 0 for all under `srun --multi-prog`
};

/// Binary form for one message. `unpack` throws base::Error(bad_input) on a text that is cut short.
std::string pack(const Introduction& introduction);
Introduction unpack_introduction(const std::string& text);

/// What world rank 0 makes of all introductions.
struct Verdict {
    int code = 0;        ///< exit code, 0: the run may start
    std::string message; ///< what is wrong and what to do
};

/// Judges a complete set of introductions, in world rank order. The first matching case decides:
/// an error met by some rank (its own code), a role that nobody expects (2, with the nearest known name), a role from
/// two launch segments or played by two programs (2), a role that is missing (4, with the mpirun line), different
/// shared files (2, both sides' names), ranks of a role with different own files (2), different versions of Rivage or
/// of the libraries (2).
Verdict judge(const std::vector<Introduction>& introductions);

} // namespace coupler
