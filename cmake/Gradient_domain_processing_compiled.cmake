# Defines the target CGAL::Gradient_domain_processing_compiled: CGAL::Gradient_domain_processing with all that is not a template in a
# static library, so that programs compile faster. The library is built only where something links it.

if(TARGET gradient_domain_processing_compiled OR NOT TARGET CGAL::Gradient_domain_processing)
  return()
endif()

set(_gdp_folder CGAL/Gradient_domain_processing/internal/compiled)
file(GLOB _gdp_parts RELATIVE "${Gradient_domain_processing_INCLUDE_DIR}" "${Gradient_domain_processing_INCLUDE_DIR}/${_gdp_folder}/*.h")
set(_gdp_sources)
foreach(_gdp_part IN LISTS _gdp_parts)
  get_filename_component(_gdp_name ${_gdp_part} NAME_WE)
  set(_gdp_source "${CMAKE_CURRENT_BINARY_DIR}/gradient_domain_processing_compiled/${_gdp_name}.cpp")
  file(CONFIGURE OUTPUT "${_gdp_source}" CONTENT "#include <@_gdp_part@>\n" @ONLY)
  list(APPEND _gdp_sources "${_gdp_source}")
endforeach()

add_library(gradient_domain_processing_compiled STATIC EXCLUDE_FROM_ALL ${_gdp_sources})
add_library(CGAL::Gradient_domain_processing_compiled ALIAS gradient_domain_processing_compiled)
set_target_properties(gradient_domain_processing_compiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_compile_definitions(gradient_domain_processing_compiled PUBLIC CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED)
target_link_libraries(gradient_domain_processing_compiled PUBLIC CGAL::Gradient_domain_processing)
