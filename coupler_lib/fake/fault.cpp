// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/fault.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <csignal>
#include <ctime>
#include <map>

namespace coupler {
namespace {

const std::map<std::string, int> signals{
    {"kill", SIGKILL}, {"crash", SIGSEGV}, {"terminate", SIGTERM}, {"stop", SIGSTOP}};

} // namespace

Fault act_out(const FaultConfig& fault, const std::string& moment, std::int64_t step, int rank)
{
    const bool any_step = moment == "start" || moment == "end";
    if (fault.kind == "none" || moment != fault.moment || rank != fault.rank) return Fault::none;
    if (!any_step && step != fault.step) return Fault::none;
    if (fault.kind == "throw")
        throw base::Error(base::ExitCode::numerical_failure, "the fault that was asked for ([fault] kind = \"throw\")");
    const auto signal = signals.find(fault.kind);
    if (signal != signals.end()) {
        std::raise(signal->second);
        return Fault::none;
    }
    while (fault.kind == "silent") {
        const timespec second{1, 0};
        nanosleep(&second, nullptr);
    }
    return fault.kind == "nan" ? Fault::nan : Fault::leave;
}

} // namespace coupler
