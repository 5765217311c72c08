// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/json.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace base {

/// Seconds since the clock was made.
class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Where the time goes: nested, named scopes with seconds and calls.
///
///     auto scope = timers.scope("gradients");    // ends with its block
class TimerTree {
public:
    class Scope {
    public:
        explicit Scope(TimerTree& tree) : tree_(&tree) {}
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        ~Scope() { tree_->leave(watch_.seconds()); }

    private:
        TimerTree* tree_;
        Stopwatch watch_;
    };

    /// Starts the scope `name` inside the present one. `name` must outlive the tree (a literal).
    [[nodiscard]] Scope scope(const char* name);
    /// {"name": {"seconds": ..., "calls": ..., "inside": {...}}, ...}
    JsonObject json() const { return json_of(root_); }
    /// Seconds in all scopes of this name below the root.
    double seconds(const std::string& name) const { return seconds_of(root_, name); }

private:
    struct Node {
        const char* name = "";
        double seconds = 0;
        std::int64_t calls = 0;
        Node* parent = nullptr;
        std::vector<std::unique_ptr<Node>> children;
    };
    void leave(double seconds);
    static JsonObject json_of(const Node& node);
    static double seconds_of(const Node& node, const std::string& name);

    Node root_;
    Node* current_ = &root_;
};

}  // namespace base
