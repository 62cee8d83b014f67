# gradient_domain_viewer, a window for gradient_domain_filter, and the pictures of that: where Qt and VTK are, and are asked for.

include_guard(GLOBAL)

option(CGAL_GDP_WITH_VIEWER "Build gradient_domain_viewer, and gradient_domain_filter with --picture (VTK with Qt)" OFF)
if(CGAL_GDP_WITH_VIEWER)
  enable_language(C) # VTK's own dependencies are looked for with it
endif()

# Without VTK there are no such targets.
function(gradient_domain_processing_drawing)
  if(NOT CGAL_GDP_WITH_VIEWER OR TARGET gradient_domain_drawing)
    return()
  endif()
  find_package(VTK QUIET COMPONENTS CommonCore CommonDataModel GUISupportQt InteractionStyle IOImage RenderingCore
               RenderingFreeType RenderingOpenGL2)
  if(NOT TARGET VTK::GUISupportQt)
    message(STATUS "VTK with Qt was not found: neither gradient_domain_viewer nor --picture will be built")
    return()
  endif()
  get_filename_component(folder ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../examples/Gradient_domain_processing ABSOLUTE)
  set(viewer ${folder}/gradient_domain_viewer)
  set_property(GLOBAL PROPERTY gradient_domain_viewer_folder ${viewer})
  add_library(gradient_domain_drawing STATIC ${viewer}/Drawn_surface.cpp ${viewer}/draw_picture.cpp ${viewer}/heat_map.cpp)
  target_include_directories(gradient_domain_drawing PUBLIC ${viewer} ${folder}/gradient_domain_filter)
  set(modules VTK::IOImage VTK::RenderingCore VTK::RenderingFreeType VTK::RenderingOpenGL2)
  gradient_domain_processing_link(gradient_domain_drawing PUBLIC)
  target_link_libraries(gradient_domain_drawing PUBLIC ${modules})
  vtk_module_autoinit(TARGETS gradient_domain_drawing MODULES ${modules})
  set_target_properties(gradient_domain_drawing PROPERTIES CXX_EXTENSIONS OFF)
endfunction()

function(gradient_domain_processing_viewer)
  if(NOT TARGET gradient_domain_drawing OR NOT TARGET gradient_domain_filter_parts OR TARGET gradient_domain_viewer)
    return()
  endif()
  get_property(viewer GLOBAL PROPERTY gradient_domain_viewer_folder)
  # Without a screen, for the window and for its test.
  add_library(gradient_domain_viewer_model STATIC
    ${viewer}/Filter_model.cpp ${viewer}/Painting.cpp ${viewer}/Prepared_filter.cpp ${viewer}/Wavelengths.cpp)
  target_include_directories(gradient_domain_viewer_model PUBLIC ${viewer})
  target_link_libraries(gradient_domain_viewer_model PUBLIC gradient_domain_filter_parts)
  # Found again, for targets of VTK are seen in the calling folder only.
  find_package(VTK QUIET COMPONENTS GUISupportQt InteractionStyle RenderingOpenGL2)
  add_executable(gradient_domain_viewer
    ${viewer}/Control_panel.cpp ${viewer}/Script.cpp ${viewer}/Surface_view.cpp ${viewer}/Value_slider.cpp
    ${viewer}/Viewer_window.cpp ${viewer}/main.cpp)
  target_link_libraries(gradient_domain_viewer PRIVATE
    gradient_domain_viewer_model gradient_domain_drawing VTK::GUISupportQt VTK::InteractionStyle)
  vtk_module_autoinit(TARGETS gradient_domain_viewer MODULES VTK::GUISupportQt VTK::InteractionStyle VTK::RenderingOpenGL2)
  set_target_properties(gradient_domain_viewer gradient_domain_viewer_model PROPERTIES CXX_EXTENSIONS OFF)
endfunction()
