# Answers find_package(Gradient_domain_processing COMPONENTS ...): the components are the accelerators that the target brings.
# It looks at the target, which an earlier find_package() may have made.

set(_gdp_name "${CMAKE_FIND_PACKAGE_NAME}")
get_target_property(_gdp_definitions CGAL::Gradient_domain_processing INTERFACE_COMPILE_DEFINITIONS)
get_target_property(_gdp_libraries CGAL::Gradient_domain_processing INTERFACE_LINK_LIBRARIES)
set(${_gdp_name}_CHOLMOD_FOUND FALSE)
if("CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD" IN_LIST _gdp_definitions)
  set(${_gdp_name}_CHOLMOD_FOUND TRUE)
endif()
set(${_gdp_name}_TBB_FOUND FALSE)
if("CGAL::TBB_support" IN_LIST _gdp_libraries)
  set(${_gdp_name}_TBB_FOUND TRUE)
endif()

foreach(_gdp_component IN LISTS ${_gdp_name}_FIND_COMPONENTS)
  if(${_gdp_name}_FIND_REQUIRED_${_gdp_component} AND NOT ${_gdp_name}_${_gdp_component}_FOUND)
    set(${_gdp_name}_FOUND FALSE)
    set(${_gdp_name}_NOT_FOUND_MESSAGE
        "There is no component ${_gdp_component} here; known are CHOLMOD and TBB, where those are found.")
  endif()
endforeach()
