# SPDX-License-Identifier: MIT
# Every way a coupled run can go wrong, acted out with the fake participants, some with the solvers; and the overlap of both sides' computing.
function(rivage_drills file processors)
    execute_process(COMMAND ${RIVAGE_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/${file} list OUTPUT_VARIABLE drills
                    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/${file})
    string(REPLACE "\n" ";" drills "${drills}")
    foreach(drill ${drills})
        add_test(NAME drill_${drill} COMMAND ${RIVAGE_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/${file} ${drill} --programs ${CMAKE_BINARY_DIR}/bin)
        set_tests_properties(drill_${drill} PROPERTIES LABELS drill PROCESSORS ${processors} TIMEOUT 120)
    endforeach()
endfunction()

rivage_drills(drills.py 1)           # they mostly sleep
rivage_drills(solver_drills.py 2)
rivage_drills(cluster_files.py 2)
add_executable(stranger ${CMAKE_CURRENT_LIST_DIR}/stranger.cpp)    # calls MPI_Init and knows nothing of Rivage
target_link_libraries(stranger PRIVATE MPI::MPI_CXX)
add_executable(own_solid ${CMAKE_CURRENT_LIST_DIR}/own_solid.cpp)  # the example of docs/coupling.md
target_link_libraries(own_solid PRIVATE rivage::coupler_coupling)
set_target_properties(stranger own_solid PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/bin)
foreach(check overlap exact_pair)
    add_test(NAME coupling_${check} COMMAND ${RIVAGE_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/${check}.py --programs ${CMAKE_BINARY_DIR}/bin)
    set_tests_properties(coupling_${check} PROPERTIES LABELS drill PROCESSORS 2 TIMEOUT 180)
endforeach()
