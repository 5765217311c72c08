// SPDX-License-Identifier: MIT
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace base {

/// How a program of Rivage ends; the numbers are what the shell sees.
enum class ExitCode {
    done = 0,
    bad_input = 2,          ///< a file, a key or a command line that cannot be used
    numerical_failure = 3,  ///< NaN, no convergence, a limit passed
    partner_lost = 4,       ///< the partner never came, fell silent or left early
    stopped_on_request = 5  ///< ended early because it was asked to
};

/// An error with the exit code it leads to. The text says what happened, the value, and what to do.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& what) : std::runtime_error(what), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

/// The pieces streamed one after the other: text("dx = ", 0.1, " m").
template <class... Pieces>
std::string text(Pieces&&... pieces)
{
    std::ostringstream stream;
    (stream << ... << std::forward<Pieces>(pieces));
    return stream.str();
}

/// For what comes from outside: always checked. Throws Error(code) with the pieces as its text.
template <class... Pieces>
void require(bool holds, ExitCode code, Pieces&&... pieces)
{
    if (!holds) throw Error(code, text(std::forward<Pieces>(pieces)...));
}

/// `require` for files, keys and command lines (exit code 2).
template <class... Pieces>
void require_input(bool holds, Pieces&&... pieces)
{
    require(holds, ExitCode::bad_input, std::forward<Pieces>(pieces)...);
}

/// For what Rivage itself guarantees: checked in debug and audit builds only. Throws std::logic_error.
inline void ensure([[maybe_unused]] bool holds, [[maybe_unused]] const char* what)
{
#if defined(RIVAGE_ENSURE) || !defined(NDEBUG)
    if (!holds) throw std::logic_error(std::string("internal check failed: ") + what);
#endif
}

}  // namespace base
