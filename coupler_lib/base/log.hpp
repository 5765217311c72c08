// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

namespace spdlog {
class logger;
}

namespace base {

/// What a participant tells: rank 0 writes to the terminal and to DIR/<role>.log, other ranks stay silent.
class Log {
public:
    /// A silent log.
    Log() = default;
    /// \param path log file, empty for the terminal only.
    Log(const std::string& role, const std::string& path);

    void info(const std::string& message) const;
    void warn(const std::string& message) const;
    /// To the file only.
    void note(const std::string& message) const;
    bool active() const { return terminal_ != nullptr; }

private:
    std::shared_ptr<spdlog::logger> terminal_, file_;
};

}  // namespace base
