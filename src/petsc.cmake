# PETSc, and the MPI and the HDF5 that it was built with: others would link, and fail while they run.
#
# PETSC_DIR and PETSC_ARCH, as variables of CMake or of the environment, name an installation or a source tree; without
# them pkg-config finds PETSc (PKG_CONFIG_PATH: Spack's and conda's environments set it or need it).
# Gives PkgConfig::PETSC, MPI::MPI_C, MPIEXEC_EXECUTABLE, scree_hdf5.

foreach(name PETSC_DIR PETSC_ARCH)
  if(NOT DEFINED ${name} AND DEFINED ENV{${name}})
    set(${name} "$ENV{${name}}")
  endif()
endforeach()

find_package(PkgConfig REQUIRED)
if(PETSC_DIR)
  foreach(folder "${PETSC_DIR}/${PETSC_ARCH}/lib/pkgconfig" "${PETSC_DIR}/lib/pkgconfig")
    if(EXISTS "${folder}/PETSc.pc" OR EXISTS "${folder}/petsc.pc")
      get_filename_component(petsc_folder "${folder}" ABSOLUTE)
      break()
    endif()
  endforeach()
  if(NOT petsc_folder)
    message(FATAL_ERROR "PETSC_DIR = ${PETSC_DIR}, PETSC_ARCH = ${PETSC_ARCH}: no PETSc.pc in lib/pkgconfig of either. "
                        "PETSC_ARCH is empty for an installation, and names a build inside a source tree.")
  endif()
  set(ENV{PKG_CONFIG_PATH} "${petsc_folder}:$ENV{PKG_CONFIG_PATH}")
endif()
pkg_search_module(PETSC QUIET IMPORTED_TARGET PETSc>=3.18 petsc>=3.18)
if(PETSC_FOUND AND petsc_folder)
  pkg_get_variable(found ${PETSC_MODULE_NAME} pcfiledir)
  if(NOT found STREQUAL petsc_folder)  # pkg-config went on to another one
    set(PETSC_FOUND FALSE)
  endif()
endif()
if(NOT PETSC_FOUND)
  message(FATAL_ERROR "No PETSc of at least 3.18: set PETSC_DIR (and PETSC_ARCH), or PKG_CONFIG_PATH to the folder of "
                      "its PETSc.pc. scripts/install_dependencies.sh installs it from the system's packages.")
endif()
message(STATUS "PETSc ${PETSC_VERSION} in ${PETSC_PREFIX}")

# What Scree cannot do without.
file(WRITE "${CMAKE_BINARY_DIR}/petsc_fits.c" [[
#include <petscconf.h>
#ifdef PETSC_USE_COMPLEX
#error wanted: PETSc with real numbers, this one has complex ones
#endif
#ifndef PETSC_USE_REAL_DOUBLE
#error wanted: PETSc in double precision
#endif
#ifdef PETSC_USE_64BIT_INDICES
#error wanted: PETSc with 32-bit indices
#endif
#ifndef PETSC_HAVE_HDF5
#error wanted: PETSc with HDF5
#endif
#ifndef PETSC_HAVE_HYPRE
#error wanted: PETSc with hypre
#endif
#ifndef PETSC_HAVE_MUMPS
#error wanted: PETSc with MUMPS
#endif
]])
execute_process(COMMAND ${CMAKE_C_COMPILER} -E ${PETSC_CFLAGS} "${CMAKE_BINARY_DIR}/petsc_fits.c"
                RESULT_VARIABLE petsc_fits OUTPUT_QUIET ERROR_VARIABLE petsc_lacks)
if(NOT petsc_fits EQUAL 0)
  message(FATAL_ERROR "PETSc ${PETSC_VERSION} in ${PETSC_PREFIX} does not suit Scree:\n${petsc_lacks}")
endif()

# Its MPI: the compiler wrapper that built it, and the launcher beside that.
pkg_get_variable(petsc_compiler ${PETSC_MODULE_NAME} ccompiler)
if(petsc_compiler MATCHES "mpi")
  find_program(MPI_C_COMPILER NAMES ${petsc_compiler} HINTS "${PETSC_PREFIX}/bin")
endif()
if(MPI_C_COMPILER)
  get_filename_component(petsc_programs "${MPI_C_COMPILER}" DIRECTORY)
  find_program(MPIEXEC_EXECUTABLE NAMES mpiexec mpirun HINTS "${petsc_programs}")
endif()
find_package(MPI REQUIRED COMPONENTS C)

# Its HDF5: the flags it was linked with; where it tells none, the parallel one that CMake finds.
set(hdf5_flags "")
if(EXISTS "${PETSC_LIBDIR}/petsc/conf/petscvariables")
  file(STRINGS "${PETSC_LIBDIR}/petsc/conf/petscvariables" lines REGEX "^HDF5_(INCLUDE|LIB) *=")
  foreach(line ${lines})
    string(REGEX REPLACE "^[^=]*= *" "" flags "${line}")
    separate_arguments(flags UNIX_COMMAND "${flags}")
    list(APPEND hdf5_flags ${flags})
  endforeach()
endif()
add_library(scree_hdf5 INTERFACE)
set(hdf5_folders "")
foreach(flag ${hdf5_flags})
  if(flag MATCHES "^-I(.+)")
    target_include_directories(scree_hdf5 SYSTEM INTERFACE "${CMAKE_MATCH_1}")
  elseif(flag MATCHES "^-L(.+)")
    list(APPEND hdf5_folders "${CMAKE_MATCH_1}")
  endif()
endforeach()
if("-lhdf5" IN_LIST hdf5_flags)
  find_library(HDF5_OF_PETSC hdf5 HINTS ${hdf5_folders} REQUIRED)
  target_link_libraries(scree_hdf5 INTERFACE "${HDF5_OF_PETSC}")
else()
  set(HDF5_PREFER_PARALLEL TRUE)
  find_package(HDF5 REQUIRED COMPONENTS C)
  if(NOT HDF5_IS_PARALLEL)
    message(FATAL_ERROR "The HDF5 in ${HDF5_INCLUDE_DIRS} is serial; wanted: the parallel one that PETSc was built with")
  endif()
  target_include_directories(scree_hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
  target_link_libraries(scree_hdf5 INTERFACE ${HDF5_C_LIBRARIES})
endif()
target_link_libraries(scree_hdf5 INTERFACE MPI::MPI_C)

# The installed program finds libraries outside of the system's folders where they are now.
if(NOT PETSC_PREFIX MATCHES "^/usr(/|$)")
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
endif()
