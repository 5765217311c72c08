// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/fault.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <csignal>
#include <ctime>

namespace coupler {

Fault act_out(const FaultConfig& fault, std::int64_t step, int rank)
{
    if (fault.kind == "none" || step != fault.step || rank != fault.rank) return Fault::none;
    if (fault.kind == "throw")
        throw base::Error(base::ExitCode::numerical_failure, "the fault that was asked for ([fault] kind = \"throw\")");
    if (fault.kind == "kill") std::raise(SIGKILL);
    while (fault.kind == "silent") {
        const timespec second{1, 0};
        nanosleep(&second, nullptr);
    }
    return fault.kind == "nan" ? Fault::nan : Fault::leave;
}

} // namespace coupler
