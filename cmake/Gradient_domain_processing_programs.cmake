# What the examples, tests and benchmarks share: one program a source file.

include_guard(GLOBAL)

include(${CMAKE_CURRENT_LIST_DIR}/Gradient_domain_processing_mpi.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Gradient_domain_processing_viewer.cmake)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

option(CGAL_GDP_SEPARATE_COMPILATION "Link this project's programs with CGAL::Gradient_domain_processing_compiled" ON)

# What a program of this project links.
function(gradient_domain_processing_link target)
  if(CGAL_GDP_SEPARATE_COMPILATION)
    target_link_libraries(${target} ${ARGN} CGAL::Gradient_domain_processing_compiled)
  else()
    target_link_libraries(${target} ${ARGN} CGAL::Gradient_domain_processing)
  endif()
endfunction()

# Less optimized they compile faster; what takes their time is the library's, which is optimized.
set(CGAL_GDP_TEST_FLAGS -O1 CACHE STRING "Compiler flags of the tests and examples, after all others")
set(gradient_domain_processing_test_flags)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(gradient_domain_processing_test_flags ${CGAL_GDP_TEST_FLAGS})
endif()

# The precompiled header of tests and examples, and what it declares.
function(gradient_domain_processing_precompile target)
  if(NOT TARGET gradient_domain_processing_precompiled)
    add_library(gradient_domain_processing_precompiled STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/polygon_mesh_io.cpp)
    set_target_properties(gradient_domain_processing_precompiled PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_options(gradient_domain_processing_precompiled PRIVATE ${gradient_domain_processing_test_flags})
    target_precompile_headers(gradient_domain_processing_precompiled PRIVATE "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/precompiled.h")
    gradient_domain_processing_link(gradient_domain_processing_precompiled PRIVATE)
  endif()
  target_precompile_headers(${target} REUSE_FROM gradient_domain_processing_precompiled)
  target_link_libraries(${target} PRIVATE gradient_domain_processing_precompiled)
endfunction()

# gradient_domain_processing_programs(<kind> [EXCEPT <source>...] [HEADER_ONLY <source>...] [WORKING_DIRECTORY <dir>])
#
# Every *.cpp in the current folder becomes a program of its name and, unless the kind is benchmark, a CTest test
# <kind>/<name> that runs it. Targets are <kind>_<name>, so that a test and an example may share a name; a name that
# begins so already stays as it is. Tests and examples share a precompiled header of other libraries' headers, but not of ours,
# whose includes shall be seen to be complete (CMAKE_DISABLE_PRECOMPILE_HEADERS switches it off). Those that are HEADER_ONLY do not: they link
# nothing that is compiled separately.
function(gradient_domain_processing_programs kind)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "WORKING_DIRECTORY" "EXCEPT;HEADER_ONLY")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(source IN LISTS sources)
    get_filename_component(file ${source} NAME)
    get_filename_component(name ${source} NAME_WE)
    if(file IN_LIST arg_EXCEPT)
      continue()
    endif()
    set(target ${name})
    if(NOT name MATCHES "^${kind}_")
      set(target ${kind}_${name})
    endif()
    add_executable(${target} ${source})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} CXX_EXTENSIONS OFF)
    if(file IN_LIST arg_HEADER_ONLY)
      target_link_libraries(${target} PRIVATE CGAL::Gradient_domain_processing)
    else()
      gradient_domain_processing_link(${target} PRIVATE)
    endif()
    if(NOT kind STREQUAL "benchmark")
      target_compile_options(${target} PRIVATE ${gradient_domain_processing_test_flags})
      if(NOT file IN_LIST arg_HEADER_ONLY)
        gradient_domain_processing_precompile(${target})
      endif()
      add_test(NAME ${kind}/${name} COMMAND ${target} WORKING_DIRECTORY ${arg_WORKING_DIRECTORY})
      set_tests_properties(${kind}/${name} PROPERTIES TIMEOUT 900)
    endif()
  endforeach()
endfunction()

# gradient_domain_filter and, as a library, all of it but main(); built once for whoever needs them. Without
# Boost.Program_options there are no such targets.
function(gradient_domain_processing_filter)
  get_filename_component(folder ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../examples/Gradient_domain_processing ABSOLUTE)
  set(source ${folder}/gradient_domain_filter.cpp)
  if(NOT EXISTS ${source})
    return()
  endif()
  # Its targets are seen in the calling folder only. With Iostreams and zlib, compressed files are read and written.
  find_package(Boost QUIET COMPONENTS program_options OPTIONAL_COMPONENTS iostreams)
  if(NOT TARGET Boost::program_options)
    message(STATUS "Boost.Program_options was not found: gradient_domain_filter will not be built")
    return()
  endif()
  if(TARGET gradient_domain_filter)
    return()
  endif()
  file(GLOB_RECURSE parts CONFIGURE_DEPENDS ${folder}/gradient_domain_filter/*.cpp)
  add_library(gradient_domain_filter_parts STATIC ${parts})
  set_target_properties(gradient_domain_filter_parts PROPERTIES CXX_EXTENSIONS OFF)
  target_include_directories(gradient_domain_filter_parts INTERFACE ${folder}/gradient_domain_filter)
  target_compile_definitions(gradient_domain_filter_parts PRIVATE
    GRADIENT_DOMAIN_PROCESSING_VERSION="${Gradient_domain_processing_VERSION}")
  gradient_domain_processing_link(gradient_domain_filter_parts PUBLIC)
  target_link_libraries(gradient_domain_filter_parts PUBLIC Boost::program_options)
  if(TARGET Boost::iostreams)
    target_compile_definitions(gradient_domain_filter_parts PRIVATE GRADIENT_DOMAIN_FILTER_HAS_ZLIB)
    target_link_libraries(gradient_domain_filter_parts PUBLIC Boost::iostreams)
  endif()
  gradient_domain_processing_drawing()
  if(TARGET gradient_domain_drawing)
    # where it counts only: the rest need not be compiled again
    set_source_files_properties(${folder}/gradient_domain_filter/check_options.cpp ${source}
      PROPERTIES COMPILE_DEFINITIONS GRADIENT_DOMAIN_FILTER_HAS_PICTURES)
  endif()
  add_executable(gradient_domain_filter ${source})
  set_target_properties(gradient_domain_filter PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(gradient_domain_filter PRIVATE gradient_domain_filter_parts)
  if(TARGET gradient_domain_drawing)
    target_link_libraries(gradient_domain_filter PRIVATE gradient_domain_drawing)
  endif()
  gradient_domain_processing_mpi_filter()
  gradient_domain_processing_viewer()
endfunction()
