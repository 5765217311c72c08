// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config_table.hpp"

#include <memory>
#include <string>
#include <vector>

namespace base {

/// A formula as it stands in a configuration file: the text of an expression, or a plain number; and its place.
struct Formula {
    std::string text = {};
    std::string where = {}; ///< "file:line:column", empty for one that no file holds
};

// What a configuration table needs of the type of a key.
void convert(const ConfigNode& node, const std::string& key, Formula& out);
std::string to_toml(const Formula& formula);
inline std::string type_name(const Formula&) { return "number or formula"; }
inline void check_value(const Formula&, const KeyInfo&, const std::string&, const std::string&) {}

/// A formula over named variables, read once and evaluated often: "500*(1 - x^2 - y^2)" over x and y.
///
/// + - * / ^, comparisons, a ? b : c, sin cos tan asin acos atan sinh cosh tanh exp ln log10 sqrt abs sign rint min max,
/// and the constant pi; angles in radians (muParser).
class Expression {
public:
    /// Throws Error(bad_input) with the place, the text, the position in it and the variables that there are.
    Expression(const Formula& formula, std::vector<std::string> variables);
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;
    ~Expression();

    /// The value for the variables' `values`, in the constructor's order; not to be called by two threads at once.
    /// Throws Error(bad_input) when it is not a finite number, with the values.
    double operator()(const std::vector<double>& values) const;

    /// Whether the formula mentions the variable.
    [[nodiscard]] bool uses(const std::string& variable) const;

private:
    struct Engine;
    std::unique_ptr<Engine> engine_;
};

} // namespace base
