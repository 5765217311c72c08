// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/introduction.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "coupler_lib/foundation/nearest_name.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace coupler {
namespace {

using Introductions = std::vector<Introduction>;

int code_of(base::ExitCode code) { return static_cast<int>(code); }

std::string quoted(const std::string& name) { return "'" + name + "'"; }

std::string joined(const std::vector<std::string>& pieces, const std::string& between)
{
    std::string all;
    for (const auto& piece : pieces) all += (all.empty() ? "" : between) + piece;
    return all;
}

/// "fluid (rank 0), solid (ranks 1, 2)"
std::string who_is_there(const Introductions& introductions)
{
    std::map<std::string, std::vector<std::string>> ranks;
    for (std::size_t rank = 0; rank < introductions.size(); ++rank)
        ranks[introductions[rank].role].push_back(std::to_string(rank));
    std::vector<std::string> pieces;
    for (const auto& [role, list] : ranks)
        pieces.push_back(quoted(role) + (list.size() > 1 ? " (ranks " : " (rank ") + joined(list, ", ") + ")");
    return joined(pieces, ", ");
}

/// With as many ranks of each role as there are now, one where there is none.
std::string advice(const Introductions& introductions)
{
    std::map<std::string, int> ranks;
    for (const auto& introduction : introductions) ++ranks[introduction.role];
    for (const auto& introduction : introductions)
        if (!introduction.launch.empty())
            return "\n  Start all of them with one command:\n    " + launch_line(introduction.launch, ranks);
    return "\n  Start all of them with one mpirun command, one segment for each role.";
}

std::set<std::string> expected_roles(const Introductions& introductions)
{
    std::set<std::string> roles;
    for (const auto& introduction : introductions)
        roles.insert(introduction.expected_roles.begin(), introduction.expected_roles.end());
    return roles;
}

/// Errors met before the handshake: every different text once, the code of the first.
Verdict own_errors(const Introductions& introductions)
{
    Verdict verdict;
    std::vector<std::string> texts;
    for (const auto& introduction : introductions) {
        if (introduction.failure_code == 0) continue;
        if (verdict.code == 0) verdict.code = introduction.failure_code;
        if (std::find(texts.begin(), texts.end(), introduction.failure) == texts.end())
            texts.push_back(introduction.failure);
    }
    verdict.message = joined(texts, "\n  and: ");
    return verdict;
}

Verdict unknown_role(const Introductions& introductions)
{
    const std::set<std::string> all = expected_roles(introductions);
    for (std::size_t rank = 0; rank < introductions.size(); ++rank) {
        const auto& own = introductions[rank];
        const auto& known = own.expected_roles;
        const bool known_to_itself = std::find(known.begin(), known.end(), own.role) != known.end();
        if (known_to_itself && all.count(own.role)) continue;
        std::vector<std::string> candidates(all.begin(), all.end());
        return {code_of(base::ExitCode::bad_input),
                base::text("rank ", rank, " calls itself ", quoted(own.role), ", which is no participant of ",
                           own.config_file.empty() ? "this run" : own.config_file,
                           base::suggestion(own.role, candidates))};
    }
    return {};
}

/// The same role from two launch segments, or by two programs where segments cannot be told apart (`srun
/// --multi-prog`): two programs would both believe to be the fluid.
Verdict doubled_role(const Introductions& introductions)
{
    std::map<std::string, std::set<std::pair<int, std::string>>> players;
    for (const auto& one : introductions) players[one.role].insert({one.appnum, one.program});
    for (const auto& [role, which] : players) {
        if (which.size() < 2) continue;
        return {
            code_of(base::ExitCode::bad_input),
            base::text("the role ", quoted(role), " is doubled: ", which.size(),
                       " segments of the mpirun command or programs play it; present: ", who_is_there(introductions),
                       ". Name the role of one of them with --as NAME, or give one segment more ranks (-n)",
                       advice(introductions))};
    }
    return {};
}

Verdict missing_role(const Introductions& introductions)
{
    std::vector<std::string> missing;
    for (const auto& role : expected_roles(introductions)) {
        const bool present = std::any_of(introductions.begin(), introductions.end(),
                                         [&role](const Introduction& one) { return one.role == role; });
        if (!present) missing.push_back(quoted(role));
    }
    if (missing.empty()) return {};
    return {code_of(base::ExitCode::partner_lost),
            base::text("the participant ", joined(missing, " and "), " is missing: it was not started; present: ",
                       who_is_there(introductions), advice(introductions))};
}

std::string difference_of(const Introductions& introductions, std::size_t a, std::size_t b, const std::string& of_a,
                          const std::string& of_b)
{
    return base::text(quoted(introductions[a].role), " (rank ", a, ") has ", of_a, ", ", quoted(introductions[b].role),
                      " (rank ", b, ") has ", of_b);
}

/// "'fluid' (rank 0) has A, 'solid' (rank 1) has B" for the first two ranks that differ in a property. Who leaves it
/// empty, as a solver from outside may, is not compared.
template<class Property> std::string difference(const Introductions& introductions, Property property)
{
    std::size_t first = introductions.size();
    for (std::size_t rank = 0; rank < introductions.size(); ++rank) {
        if (property(introductions[rank]).empty()) continue;
        if (first == introductions.size()) first = rank;
        if (property(introductions[first]) != property(introductions[rank]))
            return difference_of(introductions, first, rank, property(introductions[first]),
                                 property(introductions[rank]));
    }
    return {};
}

Verdict different_files(const Introductions& introductions)
{
    const std::string hashes = difference(introductions, [](const Introduction& one) { return one.config_hash; });
    if (hashes.empty()) return {};
    const std::string both = difference(introductions, [](const Introduction& one) {
        return one.config_hash.empty() ? "" : one.config_file + " [content " + one.config_hash + "]";
    });
    return {code_of(base::ExitCode::bad_input),
            "the participants read different coupling files or overrides: " + both +
                ". All must be given the same shared file and the same --set options"};
}

/// All ranks of a role must read the same own file: on a cluster a node may still see an old one.
Verdict different_own_files(const Introductions& introductions)
{
    const auto what = [](const Introduction& one) { return one.own_file + " [content " + one.own_hash + "]"; };
    std::map<std::string, std::size_t> first;
    for (std::size_t rank = 0; rank < introductions.size(); ++rank) {
        const auto& own = introductions[rank];
        const std::size_t before = first.emplace(own.role, rank).first->second;
        if (own.own_hash == introductions[before].own_hash) continue;
        return {code_of(base::ExitCode::bad_input),
                "the ranks of one participant read different files: " +
                    difference_of(introductions, before, rank, what(introductions[before]), what(own)) +
                    ". Do all nodes see the same, present folder?"};
    }
    return {};
}

Verdict different_versions(const Introductions& introductions)
{
    const std::string versions = difference(introductions, [](const Introduction& one) { return one.version; });
    if (!versions.empty())
        return {code_of(base::ExitCode::bad_input),
                "the programs are of different versions: " + versions + ". Build both from the same source"};
    const std::string libraries = difference(introductions, [](const Introduction& one) { return one.libraries; });
    if (!libraries.empty())
        return {code_of(base::ExitCode::bad_input), "the programs use different libraries: " + libraries +
                                                        ". Build both, and run all nodes, with the same ones"};
    return {};
}

} // namespace

Verdict judge(const std::vector<Introduction>& introductions)
{
    using Check = Verdict (*)(const Introductions&);
    for (const Check check : {Check(own_errors), Check(unknown_role), Check(doubled_role), Check(missing_role),
                              Check(different_files), Check(different_own_files), Check(different_versions)}) {
        const Verdict verdict = check(introductions);
        if (verdict.code != 0) return verdict;
    }
    return {};
}

} // namespace coupler
