# SPDX-License-Identifier: MIT
# rivage_test(NAME sph_numerics SOURCES test_kernel.cpp ... LINK rivage::sph_numerics [RANKS 1 2 3] [TIMEOUT s]):
# one GoogleTest binary; without RANKS one ctest entry run directly, with RANKS one entry per rank count through mpirun.
set(RIVAGE_TEST_ENVIRONMENT
    "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_mpi_yield_when_idle=1;OMPI_MCA_hwloc_base_binding_policy=none;OMP_NUM_THREADS=1")

function(rivage_test)
    cmake_parse_arguments(TEST "" "NAME;TIMEOUT" "SOURCES;LINK;RANKS" ${ARGN})
    if(NOT TEST_TIMEOUT)
        set(TEST_TIMEOUT 120)
    endif()
    set(target test_${TEST_NAME})
    add_executable(${target} ${TEST_SOURCES})
    target_link_libraries(${target} PRIVATE rivage::test_main ${TEST_LINK})
    rivage_precompiled(${target} TESTS)
    if(NOT TEST_RANKS)
        add_test(NAME ${TEST_NAME} COMMAND ${target})
        set_tests_properties(${TEST_NAME} PROPERTIES TIMEOUT ${TEST_TIMEOUT} ENVIRONMENT "${RIVAGE_TEST_ENVIRONMENT}")
    endif()
    foreach(ranks ${TEST_RANKS})
        set(name ${TEST_NAME}_np${ranks})
        add_test(NAME ${name} COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe -n ${ranks} $<TARGET_FILE:${target}>)
        set_tests_properties(${name} PROPERTIES PROCESSORS ${ranks} TIMEOUT ${TEST_TIMEOUT}
                             ENVIRONMENT "${RIVAGE_TEST_ENVIRONMENT}")
    endforeach()
endfunction()
