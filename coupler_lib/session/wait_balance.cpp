// SPDX-License-Identifier: MIT
#include "coupler_lib/session/wait_balance.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace coupler {
namespace {

constexpr double balanced = 0.15;

/// Those for whom the others wait: who waits least, and whoever hardly waits.
std::string bottlenecks(const std::vector<WaitShare>& waits)
{
    const double least = std::ranges::min_element(waits, {}, &WaitShare::share)->share;
    std::string names;
    for (const auto& wait : waits)
        if (wait.share <= std::max(least, balanced)) names += (names.empty() ? "" : " and ") + wait.role;
    return names;
}

} // namespace

std::string wait_advice(const std::vector<WaitShare>& waits)
{
    std::string shares;
    for (const auto& wait : waits)
        shares += fmt::format("{}{} waits {:.0f} %", shares.empty() ? "" : ", ", wait.role, 100 * wait.share);
    const auto most = std::max_element(waits.begin(), waits.end(),
                                       [](const WaitShare& a, const WaitShare& b) { return a.share < b.share; });
    if (most == waits.end()) return "";
    if (waits.size() == 1) return shares; // the partner is a solver from outside, which does not tell
    if (most->share <= balanced) return shares + ": balanced";
    if (most->ranks == 1) return fmt::format("{}: give {} more ranks", shares, bottlenecks(waits));
    return fmt::format("{}: give {} fewer ranks, or {} more", shares, most->role, bottlenecks(waits));
}

std::string to_text(const WaitShare& wait) { return fmt::format("{} {:.17g}", wait.ranks, wait.share); }

WaitShare wait_share_from(const std::string& role, const std::string& text)
{
    WaitShare wait;
    wait.role = role;
    std::istringstream(text) >> wait.ranks >> wait.share;
    return wait;
}

} // namespace coupler
