// SPDX-License-Identifier: MIT
#include "coupler_lib/base/expression.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <muParser.h>
#include <numbers>

namespace base {
namespace {

std::string quoted_formula(const Formula& formula)
{
    return (formula.where.empty() ? "" : formula.where + ": ") + "the formula \"" + formula.text + "\"";
}

std::string list(const std::vector<std::string>& names)
{
    std::string all;
    for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
    return all.empty() ? "none, it must be a number" : all;
}

[[noreturn]] void fail_at(const Formula& formula, std::size_t position, const std::string& message,
                          const std::vector<std::string>& variables)
{
    throw Error(ExitCode::bad_input, text(quoted_formula(formula), " cannot be read at position ", position + 1, ": ",
                                          message, "; variables here: ", list(variables)));
}

/// muParser's words without its own "at position 4.", which counts from 0.
std::string complaint(const mu::ParserError& error)
{
    const std::string& message = error.GetMsg();
    return message.substr(0, std::min(message.find(" at position"), message.find_last_not_of(". ") + 1));
}

/// muParser would take "x = 3" for an assignment.
std::size_t single_equals(const std::string& formula)
{
    for (std::size_t k = 0; k < formula.size(); ++k) {
        if (formula[k] != '=') continue;
        if (k + 1 < formula.size() && formula[k + 1] == '=') {
            ++k;
        } else if (k == 0 || std::string("<>!").find(formula[k - 1]) == std::string::npos) {
            return k;
        }
    }
    return std::string::npos;
}

} // namespace

void convert(const ConfigNode& node, const std::string& key, Formula& out)
{
    if (const auto* formula = std::get_if<std::string>(&node.value)) {
        out.text = *formula;
    } else if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
        out.text = std::to_string(*integer);
    } else if (const auto* number = std::get_if<double>(&node.value)) {
        require_input(std::isfinite(*number), node.where, ": '", key, "' = ", *number, " is not a finite number");
        out.text = fmt::format("{}", *number);
    } else {
        fail_conversion(node, key, "a number or a formula in quotes");
    }
    out.where = node.where;
}

std::string to_toml(const Formula& formula)
{
    const bool is_number = !formula.text.empty() &&
                           formula.text.find_first_not_of("+-.0123456789e") == std::string::npos &&
                           formula.text.find_first_of("0123456789") != std::string::npos &&
                           formula.text.find_first_of("+-", 1) == std::string::npos;
    return is_number ? to_toml(std::stod(formula.text)) : to_toml(formula.text);
}

/// The parser, and the variables' values at fixed addresses.
struct Expression::Engine {
    Formula formula;
    std::vector<std::string> variables;
    std::vector<double> values;
    mu::Parser parser;
};

Expression::Expression(const Formula& formula, std::vector<std::string> variables) : engine_(std::make_unique<Engine>())
{
    Engine& engine = *engine_;
    engine.formula = formula;
    engine.variables = std::move(variables);
    engine.values.assign(engine.variables.size(), 0.0);
    const std::size_t assignment = single_equals(formula.text);
    if (assignment != std::string::npos)
        fail_at(formula, assignment, "'=' assigns; to compare, write ==", engine.variables);
    try {
        engine.parser.DefineConst("pi", std::numbers::pi);
        for (std::size_t k = 0; k < engine.variables.size(); ++k)
            engine.parser.DefineVar(engine.variables[k], &engine.values[k]);
        engine.parser.SetExpr(formula.text);
        engine.parser.Eval();
    } catch (const mu::ParserError& error) {
        fail_at(formula, static_cast<std::size_t>(std::max(error.GetPos(), 0)), complaint(error), engine.variables);
    }
    if (engine.parser.GetNumResults() != 1)
        fail_at(formula, formula.text.find(','), "a comma separates two values, one is wanted", engine.variables);
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(const std::vector<double>& values) const
{
    Engine& engine = *engine_;
    ensure(values.size() == engine.values.size(), "as many values as the expression has variables");
    std::copy(values.begin(), values.end(), engine.values.begin());
    const double result = engine.parser.Eval();
    if (std::isfinite(result)) return result;
    std::string at;
    for (std::size_t k = 0; k < values.size(); ++k)
        at += fmt::format("{}{} = {}", k ? ", " : " at ", engine.variables[k], values[k]);
    throw Error(ExitCode::bad_input, text(quoted_formula(engine.formula), " has no finite value", at));
}

bool Expression::uses(const std::string& variable) const { return engine_->parser.GetUsedVar().contains(variable); }

} // namespace base
