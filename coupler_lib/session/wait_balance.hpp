// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace coupler {

/// How long a participant waited for its partners.
struct WaitShare {
    std::string role;
    int ranks = 1;
    double share = 0; ///< of the wall time, mean over its ranks, 0 ... 1
};

/// What to make of the waits, in one sentence: "fluid waits 3 %, solid waits 62 %: give solid fewer ranks, or fluid more". Waits up to
/// 15 % are called balanced.
std::string wait_advice(const std::vector<WaitShare>& waits);

/// For the way from each participant's root to world rank 0.
std::string to_text(const WaitShare& wait);
WaitShare wait_share_from(const std::string& role, const std::string& text);

} // namespace coupler
