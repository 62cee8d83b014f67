# Defines the target CGAL::Gradient_domain_processing: the headers, CGAL, Eigen and the accelerators of this machine.
#
# The one place that looks for them, whoever asks: the build from the root, the stand-alone examples, tests and benchmarks,
# FetchContent, and the installed Gradient_domain_processingConfig.cmake, which sets Gradient_domain_processing_INCLUDE_DIR.
#
# Each accelerator is used if it is found, and can be switched off:
#   CGAL_GDP_WITH_CHOLMOD  SuiteSparse's supernodal Cholesky factorization, with OpenBLAS where that is found
#   CGAL_GDP_WITH_TBB      threads
# CGAL::Gradient_domain_processing_compiled is beside it, see Gradient_domain_processing_compiled.cmake.
# Those that are used are components of the package: find_package(Gradient_domain_processing COMPONENTS CHOLMOD TBB).

set(Gradient_domain_processing_VERSION 0.1.0)

if(TARGET CGAL::Gradient_domain_processing)
  return()
endif()

option(CGAL_GDP_WITH_CHOLMOD "Use CHOLMOD (SuiteSparse) if it is found" ON)
option(CGAL_GDP_WITH_TBB "Use TBB if it is found" ON)

# FetchContent may run this within find_package() too: only the installed configuration file knows that it is one.
set(_gdp_is_installed ${Gradient_domain_processing_IS_INSTALLED})
set(_gdp_quiet)
set(_gdp_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
if(Gradient_domain_processing_FIND_QUIETLY)
  set(_gdp_quiet QUIET)
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE) # CGAL would speak all the same
endif()

get_property(_gdp_targets_before DIRECTORY PROPERTY IMPORTED_TARGETS)

# Eigen 5 answers no to whoever asks for 3.3 or later, so that its version is looked at here.
find_package(CGAL 5.5 ${_gdp_quiet})
find_package(Eigen3 CONFIG ${_gdp_quiet})
set(_gdp_missing)
if(NOT CGAL_FOUND)
  set(_gdp_missing "CGAL 5.5 or later was not found; set CGAL_DIR.")
elseif(NOT Eigen3_FOUND)
  set(_gdp_missing "Eigen 3.3 or later was not found; set Eigen3_DIR.")
elseif(Eigen3_VERSION VERSION_LESS 3.3)
  set(_gdp_missing "Eigen ${Eigen3_VERSION} is older than 3.3; set Eigen3_DIR.")
endif()
if(_gdp_missing)
  set(CMAKE_MESSAGE_LOG_LEVEL "${_gdp_log_level}")
  if(_gdp_is_installed)
    set(Gradient_domain_processing_FOUND FALSE)
    set(Gradient_domain_processing_NOT_FOUND_MESSAGE "${_gdp_missing}")
    return()
  endif()
  message(FATAL_ERROR "Gradient_domain_processing: ${_gdp_missing}")
endif()

# By these names CGAL 5 and 6.0 know Eigen, and since 3.4 Eigen no longer sets them.
if(NOT EIGEN3_INCLUDE_DIR)
  get_target_property(EIGEN3_INCLUDE_DIR Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
endif()
set(EIGEN3_FOUND TRUE)
include(${CGAL_MODULES_DIR}/CGAL_Eigen3_support.cmake)

if(_gdp_is_installed)
  add_library(CGAL::Gradient_domain_processing INTERFACE IMPORTED)
else()
  get_filename_component(Gradient_domain_processing_INCLUDE_DIR "${CMAKE_CURRENT_LIST_DIR}/../include" ABSOLUTE)
  add_library(CGAL::Gradient_domain_processing INTERFACE IMPORTED GLOBAL)
  # Warnings in our own headers must show in our own builds.
  set_target_properties(CGAL::Gradient_domain_processing PROPERTIES SYSTEM FALSE)
endif()
target_compile_features(CGAL::Gradient_domain_processing INTERFACE cxx_std_17)
target_include_directories(CGAL::Gradient_domain_processing INTERFACE "${Gradient_domain_processing_INCLUDE_DIR}")
target_link_libraries(CGAL::Gradient_domain_processing INTERFACE CGAL::CGAL CGAL::Eigen3_support ${CMAKE_DL_LIBS})

set(_gdp_solver "Eigen's Cholesky factorization")
if(CGAL_GDP_WITH_CHOLMOD)
  include("${CMAKE_CURRENT_LIST_DIR}/Gradient_domain_processing_cholmod.cmake")
  if(_gdp_cholmod_libraries)
    set(_gdp_solver "${_gdp_cholmod_name}")
    target_compile_definitions(CGAL::Gradient_domain_processing INTERFACE CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD)
    target_include_directories(CGAL::Gradient_domain_processing SYSTEM INTERFACE "${CHOLMOD_INCLUDE_DIR}")
    target_link_libraries(CGAL::Gradient_domain_processing INTERFACE ${_gdp_cholmod_libraries})
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
if(NOT _gdp_is_installed)
  get_property(_gdp_targets DIRECTORY PROPERTY IMPORTED_TARGETS)
  list(REMOVE_ITEM _gdp_targets ${_gdp_targets_before} CGAL::Gradient_domain_processing)
  foreach(_gdp_target IN LISTS _gdp_targets)
    get_target_property(_gdp_is_global ${_gdp_target} IMPORTED_GLOBAL)
    if(NOT _gdp_is_global)
      set_target_properties(${_gdp_target} PROPERTIES IMPORTED_GLOBAL TRUE)
    endif()
  endforeach()
endif()

include("${CMAKE_CURRENT_LIST_DIR}/Gradient_domain_processing_compiled.cmake")

message(STATUS "Gradient_domain_processing ${Gradient_domain_processing_VERSION}: "
               "CGAL ${CGAL_VERSION}, Eigen ${Eigen3_VERSION}, ${_gdp_solver}, ${_gdp_threads}")
set(CMAKE_MESSAGE_LOG_LEVEL "${_gdp_log_level}")
