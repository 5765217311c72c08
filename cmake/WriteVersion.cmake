# SPDX-License-Identifier: MIT
execute_process(COMMAND git -C "${SOURCE_DIR}" describe --always --dirty --abbrev=10
                OUTPUT_VARIABLE GIT_HASH OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT GIT_HASH)
    set(GIT_HASH "unknown")
endif()
set(CONTENT "// Written by cmake/WriteVersion.cmake.
#pragma once
#define RIVAGE_VERSION \"${VERSION}\"
#define RIVAGE_GIT_HASH \"${GIT_HASH}\"
#define RIVAGE_COMPILER \"${COMPILER}\"
#define RIVAGE_BUILD_TYPE \"${BUILD_TYPE}\"
")
if(EXISTS "${HEADER}")
    file(READ "${HEADER}" OLD)
endif()
if(NOT "${OLD}" STREQUAL "${CONTENT}")
    file(WRITE "${HEADER}" "${CONTENT}")
endif()
