# Looks for CHOLMOD: sets CHOLMOD_INCLUDE_DIR, _gdp_cholmod_name and _gdp_cholmod_libraries; the last is empty where it is not
# found or does not link.
#
# A static libcholmod.a (set CHOLMOD_LIBRARY to it, where there is a shared one as well) brings its dependencies along.

set(_gdp_cholmod_name "CHOLMOD")
set(_gdp_cholmod_libraries)

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_library(OPENBLAS_LIBRARY openblas)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY OPENBLAS_LIBRARY)
if(NOT CHOLMOD_INCLUDE_DIR OR NOT CHOLMOD_LIBRARY)
  return()
endif()

set(_gdp_cholmod_libraries "${CHOLMOD_LIBRARY}")
set(_gdp_cholmod_is_static FALSE)
if(CHOLMOD_LIBRARY MATCHES "\\.a$" OR (WIN32 AND NOT MINGW))
  set(_gdp_cholmod_is_static TRUE)
  foreach(_gdp_name ccolamd camd colamd amd metis suitesparseconfig)
    string(TOUPPER ${_gdp_name}_LIBRARY _gdp_variable)
    get_filename_component(_gdp_folder "${CHOLMOD_LIBRARY}" DIRECTORY)
    find_library(${_gdp_variable} NAMES lib${_gdp_name}.a ${_gdp_name} HINTS "${_gdp_folder}")
    mark_as_advanced(${_gdp_variable})
    if(${_gdp_variable})
      list(APPEND _gdp_cholmod_libraries "${${_gdp_variable}}")
    endif()
  endforeach()
endif()

if(OPENBLAS_LIBRARY)
  string(APPEND _gdp_cholmod_name " with OpenBLAS")
  if(UNIX AND NOT APPLE AND NOT _gdp_cholmod_is_static)
    # Nothing but the shared CHOLMOD calls it: without the flag a linker that drops unused libraries would leave CHOLMOD with whichever
    # BLAS the system has chosen. A flag goes to the shell as it is: hence the quotes.
    list(APPEND _gdp_cholmod_libraries "-Wl,--push-state,--no-as-needed,\"${OPENBLAS_LIBRARY}\",--pop-state")
  else()
    list(APPEND _gdp_cholmod_libraries "${OPENBLAS_LIBRARY}")
  endif()
elseif(_gdp_cholmod_is_static)
  find_package(LAPACK QUIET)
  list(APPEND _gdp_cholmod_libraries ${LAPACK_LIBRARIES})
endif()

if(_gdp_cholmod_is_static)
  find_package(Threads QUIET)
  # What a static BLAS and an OpenMP in CHOLMOD may ask for besides.
  foreach(_gdp_name gomp gfortran)
    string(TOUPPER ${_gdp_name}_LIBRARY _gdp_variable)
    find_library(${_gdp_variable} ${_gdp_name} HINTS ${CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES})
    mark_as_advanced(${_gdp_variable})
    if(${_gdp_variable})
      list(APPEND _gdp_cholmod_libraries "${${_gdp_variable}}")
    endif()
  endforeach()
  list(APPEND _gdp_cholmod_libraries ${CMAKE_THREAD_LIBS_INIT} ${CMAKE_DL_LIBS})

  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_INCLUDES "${CHOLMOD_INCLUDE_DIR}")
  set(CMAKE_REQUIRED_LIBRARIES "${_gdp_cholmod_libraries}")
  set(CMAKE_REQUIRED_QUIET TRUE)
  check_cxx_source_compiles("
    #include <cholmod.h>
    int main()
    {
      cholmod_common common;
      cholmod_start(&common);
      return cholmod_factorize(nullptr, nullptr, &common) + (cholmod_analyze(nullptr, &common) != nullptr);
    }" CGAL_GDP_CHOLMOD_LINKS)
  unset(CMAKE_REQUIRED_INCLUDES)
  unset(CMAKE_REQUIRED_LIBRARIES)
  unset(CMAKE_REQUIRED_QUIET)
  if(NOT CGAL_GDP_CHOLMOD_LINKS)
    message(WARNING "${CHOLMOD_LIBRARY} does not link with ${_gdp_cholmod_libraries}: Eigen's factorization takes its place. "
                    "Set CHOLMOD_LIBRARY to a shared library or to all that it needs, or CGAL_GDP_WITH_CHOLMOD to OFF.")
    set(_gdp_cholmod_libraries)
  endif()
endif()
