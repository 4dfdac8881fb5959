# scree_program_test(LABEL NAME [RANKS 1 2] [TIMEOUT seconds] [COST number] [PROGRAM target]): runs NAME.py of the current
# directory, which starts the program, scree unless said otherwise, on that many ranks. One rank needs no mpirun. Tests of
# greater COST, roughly seconds, start first.
include_guard(GLOBAL)

# SCREE_LAUNCHER: mpirun and its options. Open MPI wants to be told that ranks may share cores and that root may start
# them; others have no such options.
set(launcher ${MPIEXEC_EXECUTABLE})
execute_process(COMMAND ${MPIEXEC_EXECUTABLE} --version OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(said MATCHES "Open MPI|OpenRTE")
  list(APPEND launcher --bind-to none --oversubscribe)
  execute_process(COMMAND id -u OUTPUT_VARIABLE user_id OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(user_id EQUAL 0)
    list(APPEND launcher --allow-run-as-root)
  endif()
endif()
set(SCREE_LAUNCHER ${launcher} CACHE INTERNAL "mpirun and its options, without -n")

# SCREE_TEST_ENVIRONMENT: ranks may share a core. They share a machine: Open MPI need not look for networks, nor start a
# daemon for a process that was not started by mpirun; both take longer than a small run. For a run on one rank the
# program sees to that itself (app/lone_rank.hpp).
set(SCREE_TEST_ENVIRONMENT OMP_NUM_THREADS=1 OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_pml=ob1
    OMPI_MCA_ess_singleton_isolated=1 PYTHONDONTWRITEBYTECODE=1)

# SCREE_PYTHON: the python3 of the tests' scripts.
if(NOT SCREE_PYTHON)
  execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/python.sh OUTPUT_VARIABLE python RESULT_VARIABLE failed
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    message(FATAL_ERROR "The tests need a python3 with the modules named above; -DSCREE_TESTS=OFF builds without them.")
  endif()
  set(SCREE_PYTHON ${python} CACHE FILEPATH "python3 of the tests' scripts")
endif()

function(scree_program_test label name)
  cmake_parse_arguments(ARG "" "TIMEOUT;COST;PROGRAM" "RANKS" ${ARGN})
  if(NOT ARG_PROGRAM)
    set(ARG_PROGRAM scree)
  endif()
  if(NOT ARG_RANKS)
    set(ARG_RANKS 1 2)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 1500)  # a machine three times slower would not miss it
  endif()
  foreach(ranks ${ARG_RANKS})
    set(suffix "")
    if(ranks GREATER 1)
      set(suffix s)
    endif()
    set(test ${label}.${name}.${ranks}_rank${suffix})
    add_test(NAME ${test}
      COMMAND ${SCREE_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/${name}.py --scree $<TARGET_FILE:${ARG_PROGRAM}> --ranks ${ranks}
              --work ${CMAKE_CURRENT_BINARY_DIR}/${name}_${ranks} -- ${SCREE_LAUNCHER})
    set_tests_properties(${test} PROPERTIES LABELS ${label} PROCESSORS ${ranks} TIMEOUT ${ARG_TIMEOUT}
      ENVIRONMENT "${SCREE_TEST_ENVIRONMENT};PYTHONPATH=${PROJECT_SOURCE_DIR}/tests/support")
    if(ARG_COST)
      set_tests_properties(${test} PROPERTIES COST ${ARG_COST})
    endif()
  endforeach()
endfunction()
