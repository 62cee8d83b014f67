# How the package reaches a project: cmake -DROOT=<repository> -DWORK=<folder> -DGENERATOR=<generator> -DEIGEN_HEADERS=<folder>
# [-DCGAL_DIR=<folder>] [-DOPENBLAS_LIBRARY=<file>] [-DSTATIC_CHOLMOD_LIBRARY=<file>] [-DMETIS_LIBRARY=<file>] -P test_packaging.cmake
#
# Projects of a few lines are configured, and each expectation about them checked. All paths have spaces.

set(WORK "${WORK}/a folder with spaces")
file(REMOVE_RECURSE "${WORK}")
set(failures 0)

# run(<argument>...): CMake; sets status and output
macro(run)
  execute_process(COMMAND ${CMAKE_COMMAND} ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
endmacro()

# project(<name> <text>): a project, not yet configured
function(project name text)
  file(WRITE "${WORK}/${name}/CMakeLists.txt"
       "cmake_minimum_required(VERSION 3.24)\nproject(consumer LANGUAGES CXX)\n${text}\n")
endfunction()

# configure(<name> <argument>...): anew; sets status and output
function(configure name)
  file(REMOVE_RECURSE "${WORK}/${name}/build")
  set(arguments -S "${WORK}/${name}" -B "${WORK}/${name}/build" -G "${GENERATOR}" -DCMAKE_BUILD_TYPE=Release)
  if(CGAL_DIR)
    list(APPEND arguments "-DCGAL_DIR=${CGAL_DIR}")
  endif()
  run(${arguments} ${ARGN})
  set(status "${status}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

macro(fail what)
  message("${output}")
  message(SEND_ERROR "${what}")
  math(EXPR failures "${failures} + 1")
endmacro()
macro(expect_success what)
  if(NOT status EQUAL 0)
    fail("${what}: did not configure")
  endif()
endmacro()
macro(expect_failure what pattern)
  if(status EQUAL 0)
    fail("${what}: should have failed")
  elseif(NOT output MATCHES "${pattern}")
    fail("${what}: failed for another reason than `${pattern}`")
  endif()
endmacro()
macro(expect_output what pattern)
  if(NOT output MATCHES "${pattern}")
    fail("${what}: no `${pattern}`")
  endif()
endmacro()

set(expect_target "
if(NOT TARGET CGAL::Gradient_domain_processing)
  message(FATAL_ERROR \"no target\")
endif()
file(WRITE \${CMAKE_BINARY_DIR}/main.cpp \"int main() { return 0; }\")
add_executable(consumer \${CMAKE_BINARY_DIR}/main.cpp)
target_link_libraries(consumer PRIVATE CGAL::Gradient_domain_processing)")

# As a subdirectory, and linked: OpenBLAS lies where there are spaces, too.
project(subdirectory "add_subdirectory([==[${ROOT}]==] gdp)${expect_target}")
set(openblas)
if(OPENBLAS_LIBRARY)
  file(MAKE_DIRECTORY "${WORK}/libraries")
  file(CREATE_LINK "${OPENBLAS_LIBRARY}" "${WORK}/libraries/libopenblas.so" SYMBOLIC)
  set(openblas "-DOPENBLAS_LIBRARY=${WORK}/libraries/libopenblas.so")
endif()
configure(subdirectory ${openblas})
expect_success("subdirectory")
run(--build "${WORK}/subdirectory/build")
expect_success("subdirectory, linked")

# FetchContent, with what find_package() may be told
function(configure_fetched with)
  project(fetched "
include(FetchContent)
FetchContent_Declare(Gradient_domain_processing SOURCE_DIR [==[${ROOT}]==] OVERRIDE_FIND_PACKAGE)
find_package(Gradient_domain_processing ${with}) ${expect_target}")
  configure(fetched)
  set(status "${status}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()
configure_fetched("0.1 REQUIRED")
expect_success("FetchContent")
expect_output("FetchContent" "Gradient_domain_processing [0-9.]+: CGAL")
configure_fetched("REQUIRED COMPONENTS nonsense")
expect_failure("FetchContent, a component that does not exist" "no component nonsense")

# Installed
project(package "
set(CGAL_GDP_INSTALL ON)
add_subdirectory([==[${ROOT}]==] gdp)")
configure(package)
expect_success("package")
run(--install "${WORK}/package/build" --prefix "${WORK}/prefix")
expect_success("install")
function(configure_installed with)
  project(installed "
find_package(Gradient_domain_processing ${with})
find_package(Gradient_domain_processing ${with}) # found again, where it was
${expect_target}")
  configure(installed "-DCMAKE_PREFIX_PATH=${WORK}/prefix" ${ARGN})
  set(status "${status}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()
configure_installed("0.1 REQUIRED QUIET")
expect_success("installed, quiet")
if(output MATCHES "Gradient_domain_processing [0-9]" OR output MATCHES "header-only")
  fail("installed, quiet: it speaks")
endif()
configure_installed("REQUIRED COMPONENTS nonsense")
expect_failure("installed, a component that does not exist" "no component nonsense")
configure_installed("OPTIONAL_COMPONENTS nonsense")
expect_success("installed, an optional component that does not exist")
configure_installed("REQUIRED COMPONENTS CHOLMOD" -DCGAL_GDP_WITH_CHOLMOD=OFF)
expect_failure("installed, a component that is switched off" "no component CHOLMOD")
configure_installed("9 REQUIRED")
expect_failure("installed, another version" "requested version \"9\"")

# Eigen: one that, as Eigen 5 does, answers no to any other major version; and an old one
function(make_eigen version)
  string(REGEX MATCH "^[0-9]+" major ${version})
  file(WRITE "${WORK}/eigen ${version}/Eigen3Config.cmake" "
if(NOT TARGET Eigen3::Eigen)
  add_library(Eigen3::Eigen INTERFACE IMPORTED)
  set_target_properties(Eigen3::Eigen PROPERTIES INTERFACE_INCLUDE_DIRECTORIES [==[${EIGEN_HEADERS}]==])
endif()")
  file(WRITE "${WORK}/eigen ${version}/Eigen3ConfigVersion.cmake" "
set(PACKAGE_VERSION ${version})
if(\"\${PACKAGE_FIND_VERSION}\" STREQUAL \"\" OR PACKAGE_FIND_VERSION_MAJOR STREQUAL \"${major}\")
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()")
endfunction()
make_eigen(5.0.1)
configure(subdirectory "-DEigen3_DIR=${WORK}/eigen 5.0.1")
expect_success("Eigen 5")
expect_output("Eigen 5" "Eigen 5.0.1")
make_eigen(3.2.10)
configure(subdirectory "-DEigen3_DIR=${WORK}/eigen 3.2.10")
expect_failure("Eigen 3.2" "Eigen 3.2.10 is older than 3.3")

# CHOLMOD as a static library, where it and METIS, on which it depends, are found
if(STATIC_CHOLMOD_LIBRARY AND METIS_LIBRARY)
  configure(subdirectory "-DCHOLMOD_LIBRARY=${STATIC_CHOLMOD_LIBRARY}")
  expect_success("static CHOLMOD")
  expect_output("static CHOLMOD" "CHOLMOD with OpenBLAS|, CHOLMOD,")
  if(output MATCHES "does not link")
    fail("static CHOLMOD: does not link")
  endif()
  run(--build "${WORK}/subdirectory/build")
  expect_success("static CHOLMOD, linked")
  # One that lacks what it depends on is left out, and that is said.
  file(WRITE "${WORK}/libraries/libcholmod.a" "!<arch>\n")
  configure(subdirectory "-DCHOLMOD_LIBRARY=${WORK}/libraries/libcholmod.a")
  expect_success("broken CHOLMOD")
  expect_output("broken CHOLMOD" "does not.*link")
  expect_output("broken CHOLMOD" "Eigen's Cholesky factorization, ")
else()
  message(STATUS "No static CHOLMOD, or no METIS to link with it: not tested")
endif()

message(STATUS "${failures} failures")
