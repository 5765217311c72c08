// SPDX-License-Identifier: MIT
#include "coupler_lib/base/timer.hpp"

#include <cstring>

namespace base {

TimerTree::Scope TimerTree::scope(const char* name)
{
    Node* entered = nullptr;
    for (auto& child : current_->children)
        if (child->name == name || std::strcmp(child->name, name) == 0) entered = child.get();
    if (!entered) {
        current_->children.push_back(std::make_unique<Node>());
        entered = current_->children.back().get();
        entered->name = name;
        entered->parent = current_;
    }
    current_ = entered;
    return Scope(*this);
}

void TimerTree::leave(double seconds)
{
    current_->seconds += seconds;
    current_->calls += 1;
    current_ = current_->parent;
}

JsonObject TimerTree::json_of(const Node& node)
{
    JsonObject object;
    for (const auto& child : node.children) {
        JsonObject entry;
        entry.set("seconds", child->seconds).set("calls", child->calls);
        if (!child->children.empty()) entry.set("inside", json_of(*child));
        object.set(child->name, entry);
    }
    return object;
}

double TimerTree::seconds_of(const Node& node, const std::string& name)
{
    double sum = 0;
    for (const auto& child : node.children) sum += child->name == name ? child->seconds : seconds_of(*child, name);
    return sum;
}

}  // namespace base
