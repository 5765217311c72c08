// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_body.hpp"
#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/solve/newton.hpp"

#include <string>

namespace fem {

/// Why Newton's iteration led nowhere.
struct Failure {
    enum class Kind {
        no_convergence, ///< residuals that do not fall
        inversion,      ///< an element turned inside out, whatever part of a correction is taken
        unheld,         ///< a singular matrix: the body moves without resistance
        unsettled,      ///< contact that finds no end
        not_a_number    ///< forces that are not numbers
    };
    Kind kind = Kind::no_convergence;
    Inversion inversion = {}; ///< of kind inversion
    int node = -1; ///< of kind unheld: the one that moves farthest, -1 when it is not known or on another rank
    std::string complaint = {}; ///< of kind unsettled: in words
};

/// The failure in words: what happened, at which node or element, where that is in the reference state, and how far it
/// has moved. Collective. \param newton holds the residuals of the iteration that failed.
std::string describe(const Failure& failure, const Mesh& mesh, const Motion& motion, const NewtonMonitor& newton);

} // namespace fem
