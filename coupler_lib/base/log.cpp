// SPDX-License-Identifier: MIT
#include "coupler_lib/base/log.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace base {

Log::Log(const std::string& role, const std::string& path)
{
    terminal_ = std::make_shared<spdlog::logger>(role, std::make_shared<spdlog::sinks::stdout_sink_mt>());
    terminal_->set_pattern("%n: %v");
    terminal_->flush_on(spdlog::level::info);
    if (path.empty()) return;
    try {
        file_ = std::make_shared<spdlog::logger>(role, std::make_shared<spdlog::sinks::basic_file_sink_mt>(path, true));
    } catch (const spdlog::spdlog_ex& error) {
        throw Error(ExitCode::bad_input, "cannot write the log file '" + path + "': " + error.what());
    }
    file_->set_pattern("%Y-%m-%d %H:%M:%S.%e %l %v");
    file_->flush_on(spdlog::level::info);
}

void Log::info(const std::string& message) const
{
    if (terminal_) terminal_->info("{}", message);
    note(message);
}

void Log::warn(const std::string& message) const
{
    if (terminal_) terminal_->warn("warning: {}", message);
    if (file_) file_->warn("{}", message);
}

void Log::note(const std::string& message) const
{
    if (file_) file_->info("{}", message);
}

}  // namespace base
