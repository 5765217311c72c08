// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/session/command_line.hpp"
#include "coupler_lib/session/coupling_config.hpp"
#include "coupler_lib/session/data_flow.hpp"

#include <optional>
#include <string>
#include <vector>

namespace coupler {

/// What a partner said about itself, or why it could not be asked.
struct PartnerDescription {
    std::string role;
    std::optional<DataFlow> flow;
    std::string note; ///< without a flow: what was tried
};

/// Whether this process was started without mpirun or srun.
bool started_alone();

/// Asks every other participant's program to describe itself, `PROGRAM FILE --as ROLE --check --describe` with the same
/// overrides; the programs are looked for beside this one. Call before MPI_Init and without mpirun.
/// Throws base::Error(bad_input) with the partner's own message when its files cannot be used.
std::vector<PartnerDescription> describe_partners(const CouplingConfig& config, const CommandLine& command,
                                                  const std::string& own_role);

} // namespace coupler
