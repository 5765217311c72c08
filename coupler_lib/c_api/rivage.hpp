// SPDX-License-Identifier: MIT
#ifndef RIVAGE_HPP
#define RIVAGE_HPP

#include <rivage.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// The coupling library for C++11 and later: rivage.h with exceptions in the place of return codes. What arrays hold, and how
/// long pointers live, stands there. A code of its own may call rivage.h beside this; `handle()` gives what it wants.
namespace rivage {

class Error : public std::runtime_error {
public:
    Error(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
    int code() const { return code_; }

private:
    int code_;
};

inline void check(int code)
{
    if (code != RIVAGE_OK) throw Error(code, rivage_last_error());
}

/// A role of a coupled run, on this rank; run() makes it.
class Participant {
public:
    explicit Participant(rivage_participant* handle) : handle_(handle) {}
    rivage_participant* handle() const { return handle_; }
    int comm() const { return rivage_comm(handle_); } ///< of the ranks of this role, for MPI_Comm_f2c
    int rank() const { return rivage_rank(handle_); }
    int size() const { return rivage_size(handle_); }
    std::string output_dir() const { return rivage_output_dir(handle_); } ///< of --out; empty: not given
    double end_time() const { return rivage_end_time(handle_); }          ///< [s]
    /// Whether the solid steps after the fluid, with the load of the same step.
    bool serial() const { return rivage_is_serial(handle_) != 0; }

private:
    rivage_participant* handle_;
};

/// The solid's end of its interface; close before the body of run() ends by letting it go out of scope.
class Solid {
public:
    /// facet_nodes: 4 for each facet, -1 where unused.
    Solid(const Participant& me, int dimension, const std::vector<std::int64_t>& node_ids,
          const std::vector<double>& reference, const std::vector<std::int64_t>& facet_ids,
          const std::vector<std::int32_t>& facet_nodes)
        : entries_(reference.size())
    {
        const auto nodes = static_cast<std::int64_t>(node_ids.size()),
                   facets = static_cast<std::int64_t>(facet_ids.size());
        if (reference.size() != node_ids.size() * dimension || facet_nodes.size() != 4 * facet_ids.size())
            throw Error(RIVAGE_BAD_INPUT,
                        "the wet surface wants 'dimension' coordinates for each node, 4 nodes for each facet");
        check(rivage_solid_open(me.handle(), dimension, nodes, node_ids.data(), reference.data(), facets,
                                facet_ids.data(), facet_nodes.data(), &handle_));
    }
    Solid(const Solid&) = delete;
    Solid& operator=(const Solid&) = delete;
    ~Solid() { rivage_solid_close(handle_); }

    rivage_solid* handle() const { return handle_; }
    /// Waits for the fluid's next packet. False, without waiting, when the last one has been answered.
    bool receive()
    {
        if (window.last) return false;
        check(rivage_solid_receive(handle_, &window));
        return true;
    }
    const double* force() const { return rivage_solid_force(handle_); }
    const double* pressure() const { return rivage_solid_pressure(handle_); }
    /// Answers the last receive, each array [nodes * dimension].
    void send(const std::vector<double>& position, const std::vector<double>& velocity,
              const std::vector<double>& acceleration, const rivage_solid_report& report = {})
    {
        if (position.size() != entries_ || velocity.size() != entries_ || acceleration.size() != entries_)
            throw Error(RIVAGE_BAD_INPUT,
                        "position, velocity and acceleration want an entry for each coordinate of the surface");
        check(rivage_solid_send(handle_, position.data(), velocity.data(), acceleration.data(), &report));
    }

    rivage_window window{-1, 0, 0, 0, 0};

private:
    rivage_solid* handle_ = nullptr;
    std::size_t entries_;
};

namespace detail {

template<class Body> int play(rivage_participant* handle, Body&& body)
{
    int code = RIVAGE_NUMERICAL_FAILURE;
    std::string message;
    try {
        body(Participant(handle));
        return rivage_leave(handle);
    } catch (const Error& error) {
        code = error.code();
        message = error.what();
    } catch (const std::exception& error) {
        message = error.what();
    }
    rivage_fail(handle, code, message.c_str());
    return code;
}

} // namespace detail

/// Starts MPI where it does not run, joins the run of `coupling_file` in `role`, calls body(const Participant&), leaves. An exception
/// ends every rank of every participant with its message. Returns the exit code.
/// \param arguments the words that follow the file in the command line, as rivage_join takes them
template<class Body>
int run(const std::string& role, const std::string& coupling_file, const std::vector<std::string>& arguments,
        Body&& body)
{
    std::vector<const char*> texts;
    for (const std::string& text : arguments) texts.push_back(text.c_str());
    rivage_participant* handle = nullptr;
    int code = rivage_mpi_start(role.c_str(), 30);
    if (code == RIVAGE_OK)
        code = rivage_join(rivage_world(), role.c_str(), coupling_file.c_str(), texts.data(),
                           static_cast<int>(texts.size()), &handle);
    if (code == RIVAGE_OK) code = detail::play(handle, body);
    rivage_mpi_end();
    return code;
}

} // namespace rivage
#endif
