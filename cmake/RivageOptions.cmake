# SPDX-License-Identifier: MIT
# What every target of Rivage is compiled with, as one interface target.
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
endif()

add_library(rivage_options INTERFACE)
add_library(rivage::options ALIAS rivage_options)
target_compile_features(rivage_options INTERFACE cxx_std_20)
target_include_directories(rivage_options INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_definitions(rivage_options INTERFACE OMPI_SKIP_MPICXX)
target_compile_options(rivage_options INTERFACE
    -Wall -Wextra -Wno-restrict -Wno-maybe-uninitialized -Wno-psabi -Wshadow -Wnon-virtual-dtor -fno-math-errno -fno-trapping-math -ffp-contract=off
    $<$<CONFIG:Release>:-O3> $<$<BOOL:${RIVAGE_NATIVE}>:-march=native> $<$<BOOL:${RIVAGE_WERROR}>:-Werror>
    $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-subobject-linkage>) # takes the joined sources for headers
# GCC 12 warns falsely inside its own AVX-512 header (-Wmaybe-uninitialized) and of a calling convention for eight
# doubles (-Wpsabi) that no interface of ours uses.
# Sums keep one order and products are never fused behind our back (-ffp-contract=off): a pair seen from both
# sides gives exactly opposite fluxes, and results do not depend on the number of ranks.
if(RIVAGE_AUDIT)
    target_compile_definitions(rivage_options INTERFACE RIVAGE_ENSURE=1)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
