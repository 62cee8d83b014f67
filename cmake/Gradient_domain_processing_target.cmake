# Defines the target CGAL::Gradient_domain_processing: the headers, CGAL, Eigen and the accelerators of this machine.
#
# The one place that looks for them, whoever asks: the build from the root, the stand-alone examples, tests and benchmarks,
# and find_package(Gradient_domain_processing), which sets Gradient_domain_processing_INCLUDE_DIR beforehand.
#
# Each accelerator is used if it is found, and can be switched off:
#   CGAL_GDP_WITH_CHOLMOD  SuiteSparse's supernodal Cholesky factorization, with OpenBLAS where that is found
#   CGAL_GDP_WITH_TBB      threads

set(Gradient_domain_processing_VERSION 0.1.0)

if(TARGET CGAL::Gradient_domain_processing)
  return()
endif()

option(CGAL_GDP_WITH_CHOLMOD "Use CHOLMOD (SuiteSparse) if it is found" ON)
option(CGAL_GDP_WITH_TBB "Use TBB if it is found" ON)

get_property(_gdp_targets_before DIRECTORY PROPERTY IMPORTED_TARGETS)

find_package(CGAL 5.5)
find_package(Eigen3 3.3 CONFIG)
foreach(_gdp_needed CGAL Eigen3)
  if(NOT ${_gdp_needed}_FOUND)
    if(CMAKE_FIND_PACKAGE_NAME STREQUAL "Gradient_domain_processing")
      set(Gradient_domain_processing_FOUND FALSE)
      set(Gradient_domain_processing_NOT_FOUND_MESSAGE "${_gdp_needed} was not found; set ${_gdp_needed}_DIR.")
      return()
    endif()
    message(FATAL_ERROR "Gradient_domain_processing needs ${_gdp_needed}; set ${_gdp_needed}_DIR.")
  endif()
endforeach()
include(${CGAL_MODULES_DIR}/CGAL_Eigen3_support.cmake)

if(CMAKE_FIND_PACKAGE_NAME STREQUAL "Gradient_domain_processing")
  add_library(CGAL::Gradient_domain_processing INTERFACE IMPORTED)
else()
  get_filename_component(Gradient_domain_processing_INCLUDE_DIR "${CMAKE_CURRENT_LIST_DIR}/../include" ABSOLUTE)
  add_library(CGAL::Gradient_domain_processing INTERFACE IMPORTED GLOBAL)
  # Warnings in our own headers must show in our own builds.
  set_target_properties(CGAL::Gradient_domain_processing PROPERTIES SYSTEM FALSE)
endif()
target_compile_features(CGAL::Gradient_domain_processing INTERFACE cxx_std_17)
target_include_directories(CGAL::Gradient_domain_processing INTERFACE ${Gradient_domain_processing_INCLUDE_DIR})
target_link_libraries(CGAL::Gradient_domain_processing INTERFACE CGAL::CGAL CGAL::Eigen3_support)

set(_gdp_solver "Eigen's Cholesky factorization")
if(CGAL_GDP_WITH_CHOLMOD)
  find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
  find_library(CHOLMOD_LIBRARY cholmod)
  find_library(OPENBLAS_LIBRARY openblas)
  mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY OPENBLAS_LIBRARY)
  if(CHOLMOD_INCLUDE_DIR AND CHOLMOD_LIBRARY)
    set(_gdp_solver "CHOLMOD")
    target_compile_definitions(CGAL::Gradient_domain_processing INTERFACE CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD)
    target_include_directories(CGAL::Gradient_domain_processing SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
    target_link_libraries(CGAL::Gradient_domain_processing INTERFACE ${CHOLMOD_LIBRARY})
    if(OPENBLAS_LIBRARY)
      string(APPEND _gdp_solver " with OpenBLAS")
      # Nothing but CHOLMOD calls it: without the flag a linker that drops unused libraries would leave CHOLMOD
      # with whichever BLAS the system has chosen.
      if(UNIX AND NOT APPLE)
        target_link_libraries(CGAL::Gradient_domain_processing INTERFACE
          "-Wl,--push-state,--no-as-needed,${OPENBLAS_LIBRARY},--pop-state")
      else()
        target_link_libraries(CGAL::Gradient_domain_processing INTERFACE ${OPENBLAS_LIBRARY})
      endif()
    endif()
  endif()
endif()

set(_gdp_threads "one thread")
if(CGAL_GDP_WITH_TBB)
  find_package(TBB QUIET)
  include(${CGAL_MODULES_DIR}/CGAL_TBB_support.cmake)
  if(TARGET CGAL::TBB_support)
    set(_gdp_threads "TBB")
    target_link_libraries(CGAL::Gradient_domain_processing INTERFACE CGAL::TBB_support)
  endif()
endif()

# Imported targets are seen in their directory and below only; a project that adds this one as a subdirectory
# links from above.
if(NOT CMAKE_FIND_PACKAGE_NAME STREQUAL "Gradient_domain_processing")
  get_property(_gdp_targets DIRECTORY PROPERTY IMPORTED_TARGETS)
  list(REMOVE_ITEM _gdp_targets ${_gdp_targets_before} CGAL::Gradient_domain_processing)
  foreach(_gdp_target IN LISTS _gdp_targets)
    get_target_property(_gdp_is_global ${_gdp_target} IMPORTED_GLOBAL)
    if(NOT _gdp_is_global)
      set_target_properties(${_gdp_target} PROPERTIES IMPORTED_GLOBAL TRUE)
    endif()
  endforeach()
endif()

message(STATUS "Gradient_domain_processing ${Gradient_domain_processing_VERSION}: "
               "CGAL ${CGAL_VERSION}, Eigen ${Eigen3_VERSION}, ${_gdp_solver}, ${_gdp_threads}")
