# gradient_domain_filter_mpi, gradient_domain_filter on many processes: where MPI and PETSc are, and are asked for.

include_guard(GLOBAL)

option(CGAL_GDP_WITH_PETSC "Build gradient_domain_filter_mpi (MPI and PETSc with real numbers)" OFF)

# Without them there is no such target.
function(gradient_domain_processing_mpi_filter)
  if(NOT CGAL_GDP_WITH_PETSC OR NOT TARGET gradient_domain_filter_parts OR TARGET gradient_domain_filter_mpi)
    return()
  endif()
  set(MPI_CXX_SKIP_MPICXX ON)
  find_package(MPI QUIET COMPONENTS CXX)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(PETSC QUIET IMPORTED_TARGET PETSc)
  endif()
  if(NOT TARGET MPI::MPI_CXX OR NOT TARGET PkgConfig::PETSC)
    message(STATUS "MPI or PETSc was not found (pkg-config PETSc): gradient_domain_filter_mpi will not be built")
    return()
  endif()
  get_filename_component(folder
    ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../examples/Gradient_domain_processing/gradient_domain_filter_mpi ABSOLUTE)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  add_executable(gradient_domain_filter_mpi ${sources})
  set_target_properties(gradient_domain_filter_mpi PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(gradient_domain_filter_mpi PRIVATE gradient_domain_filter_parts MPI::MPI_CXX PkgConfig::PETSC)
endfunction()
