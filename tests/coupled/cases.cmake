# SPDX-License-Identifier: MIT
# Whole cases through mpirun of both executables, judged by their expect.toml; the same bits on 1, 2, 3, 4 and 7 fluid ranks.
set(RIVAGE_PROGRAMS "${CMAKE_BINARY_DIR}/bin")

function(rivage_coupled_test name)
    add_test(NAME coupled_${name} COMMAND ${RIVAGE_PYTHON} ${ARGN})
    set_tests_properties(coupled_${name} PROPERTIES LABELS coupled PROCESSORS 2 TIMEOUT 900)
endfunction()

foreach(case gate_static gate_sudden piston_column elastic_gate_small)
    rivage_coupled_test(${case} ${CMAKE_CURRENT_LIST_DIR}/run_case.py ${PROJECT_SOURCE_DIR}/cases/${case} --programs ${RIVAGE_PROGRAMS})
endforeach()
foreach(load conservative averaged)
    rivage_coupled_test(rank_identity_${load} ${CMAKE_CURRENT_LIST_DIR}/rank_identity.py ${PROJECT_SOURCE_DIR}/cases/elastic_gate_small
                        --programs ${RIVAGE_PROGRAMS} --ranks 1 2 3 4 7 --end 0.015 --load ${load})
endforeach()
# A fluid between closing walls: jets on one rank, water at rest on another.
rivage_coupled_test(rank_identity_closing_gap ${CMAKE_CURRENT_LIST_DIR}/rank_identity.py ${PROJECT_SOURCE_DIR}/cases/tyre_block/closing_gap
                    --programs ${RIVAGE_PROGRAMS} --ranks 1 2 3 --end 0.0016)
rivage_coupled_test(rank_agreement_tip ${CMAKE_CURRENT_LIST_DIR}/rank_agreement.py ${PROJECT_SOURCE_DIR}/cases/elastic_gate_small
                    --programs ${RIVAGE_PROGRAMS} --ranks 1+1 2+1 3+1 --end 0.1 --tip 1e-4)
rivage_coupled_test(rank_agreement_solid ${CMAKE_CURRENT_LIST_DIR}/rank_agreement.py ${PROJECT_SOURCE_DIR}/cases/elastic_gate_small
                    --programs ${RIVAGE_PROGRAMS} --ranks 1+1 1+2 2+2 --end 0.01 --tip 1e-10)
rivage_coupled_test(schemes ${CMAKE_CURRENT_LIST_DIR}/schemes.py --programs ${RIVAGE_PROGRAMS})
rivage_coupled_test(two_solids ${CMAKE_CURRENT_LIST_DIR}/two_solids.py --programs ${RIVAGE_PROGRAMS})
rivage_coupled_test(outside ${CMAKE_CURRENT_LIST_DIR}/outside.py --build ${CMAKE_BINARY_DIR})
foreach(fake spring beam rigid_wall recorded)
    rivage_coupled_test(fake_${fake} ${CMAKE_CURRENT_LIST_DIR}/run_case.py ${PROJECT_SOURCE_DIR}/cases/fakes/${fake} --programs ${RIVAGE_PROGRAMS})
endforeach()
rivage_coupled_test(python_module ${CMAKE_CURRENT_LIST_DIR}/python_module.py --build ${CMAKE_BINARY_DIR})
rivage_coupled_test(code_aster ${CMAKE_CURRENT_LIST_DIR}/code_aster.py --build ${CMAKE_BINARY_DIR})
rivage_coupled_test(fakes ${CMAKE_CURRENT_LIST_DIR}/fakes.py --build ${CMAKE_BINARY_DIR})
rivage_coupled_test(replay ${CMAKE_CURRENT_LIST_DIR}/replay.py --programs ${RIVAGE_PROGRAMS})
rivage_coupled_test(closing_gap ${CMAKE_CURRENT_LIST_DIR}/run_case.py ${PROJECT_SOURCE_DIR}/cases/tyre_block/closing_gap --programs ${RIVAGE_PROGRAMS})
# Walls that move as prescribed, the fluid alone: the sound wave of the case itself, the tank with coarser particles for one period.
rivage_coupled_test(moving_piston_acoustic ${CMAKE_CURRENT_LIST_DIR}/run_case.py ${PROJECT_SOURCE_DIR}/cases/moving_piston/acoustic
                    --programs ${RIVAGE_PROGRAMS})
rivage_coupled_test(moving_piston_coarse ${CMAKE_CURRENT_LIST_DIR}/run_case.py ${PROJECT_SOURCE_DIR}/cases/moving_piston
                    --programs ${RIVAGE_PROGRAMS} --set fluid.resolution.spacing=0.005 --set fluid.time.end=0.5)
# Small siblings of the validation runs: coarser and shorter, held to their own distance from the fine ones.
foreach(case wedge_impact stretching_patch standing_wave hydrostatic_tank hydrostatic_plate dam_break taylor_green elastic_gate/outside_solver
        elastic_gate/lossy elastic_gate_3d tyre_block/squeeze_film piston_column)
    string(REPLACE / _ name ${case})
    rivage_coupled_test(small_${name} ${PROJECT_SOURCE_DIR}/cases/tools/verify.py ${case} --test --programs ${RIVAGE_PROGRAMS}
                        --out ${CMAKE_BINARY_DIR}/tests/small)
endforeach()
rivage_coupled_test(small_tyre_block ${PROJECT_SOURCE_DIR}/cases/tools/verify.py tyre_block --test --run coarse --programs ${RIVAGE_PROGRAMS}
                    --out ${CMAKE_BINARY_DIR}/tests/small)
# The solid alone against exact answers, each run short enough as it stands.
foreach(case elastica rubber_bar thick_cylinder cook turek_hron tyre_block/dry_slide)
    string(REPLACE / _ name ${case})
    rivage_coupled_test(solid_${name} ${PROJECT_SOURCE_DIR}/cases/tools/verify.py ${case} --keep-page --programs ${RIVAGE_PROGRAMS}
                        --out ${CMAKE_BINARY_DIR}/tests/small)
endforeach()
