# SPDX-License-Identifier: MIT
# What most sources include, compiled once: some 3 s less for each source with Eigen in it (8.7 -> 5.7 s, 12.8 -> 9.1 s). Sources still
# name all that they use; the build without it (-DRIVAGE_PRECOMPILED=OFF) shows whether they do.
#   rivage_precompiled(TARGET)         for rooms and programs
#   rivage_precompiled(TARGET LIBRARY) for what goes into librivage.so
#   rivage_precompiled(TARGET TESTS)   with GoogleTest
option(RIVAGE_PRECOMPILED "Compile common headers once, for a faster build" ON)

set(RIVAGE_COMMON_HEADERS <Eigen/Dense> <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits>
                          <map> <memory> <mpi.h> <numeric> <optional> <set> <span> <sstream> <string> <variant> <vector>)

function(rivage_add_precompiled name)
    cmake_parse_arguments(PRE "" "" "HEADERS;LINK" ${ARGN})
    add_library(${name} OBJECT "${CMAKE_SOURCE_DIR}/cmake/precompiled.cpp")
    target_link_libraries(${name} PRIVATE rivage::options Eigen3::Eigen MPI::MPI_CXX ${PRE_LINK})
    target_precompile_headers(${name} PRIVATE ${RIVAGE_COMMON_HEADERS} ${PRE_HEADERS})
endfunction()

function(rivage_precompiled target)
    if(NOT RIVAGE_PRECOMPILED)
        return()
    endif()
    if("TESTS" IN_LIST ARGN)
        target_precompile_headers(${target} REUSE_FROM rivage_precompiled_tests)
    elseif("LIBRARY" IN_LIST ARGN)
        target_precompile_headers(${target} REUSE_FROM rivage_precompiled_library)
    else()
        target_precompile_headers(${target} REUSE_FROM rivage_precompiled_rooms)
    endif()
endfunction()

if(RIVAGE_PRECOMPILED)
    rivage_add_precompiled(rivage_precompiled_rooms)
    rivage_add_precompiled(rivage_precompiled_library)
    set_target_properties(rivage_precompiled_library PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(RIVAGE_TESTS)
        rivage_add_precompiled(rivage_precompiled_tests HEADERS <gtest/gtest.h> LINK GTest::gtest)
    endif()
endif()
