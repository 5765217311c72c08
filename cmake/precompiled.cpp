// SPDX-License-Identifier: MIT
// Carries the precompiled headers of RivagePrecompiled.cmake; holds nothing itself.
