// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace base {

/// The candidate with the smallest edit distance to `name`; empty when none is closer than half of its length.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// ", did you mean 'x'?" or the list of candidates when none is near.
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace base
