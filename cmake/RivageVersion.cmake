# SPDX-License-Identifier: MIT
# Version and git hash for every output (--version, summary.json): a target, so that a new commit reaches the binaries.
set(RIVAGE_VERSION_HEADER "${CMAKE_BINARY_DIR}/generated/rivage_version.hpp")
add_custom_target(rivage_version_header
    COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${CMAKE_SOURCE_DIR} -DVERSION=${PROJECT_VERSION} -DBUILD_TYPE=${CMAKE_BUILD_TYPE}
            -DCOMPILER=${CMAKE_CXX_COMPILER_ID}-${CMAKE_CXX_COMPILER_VERSION} -DHEADER=${RIVAGE_VERSION_HEADER}
            -P ${CMAKE_SOURCE_DIR}/cmake/WriteVersion.cmake
    BYPRODUCTS "${RIVAGE_VERSION_HEADER}" COMMENT "" VERBATIM)
