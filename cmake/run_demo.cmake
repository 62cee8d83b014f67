# Smooths and sharpens a real scan: cmake -DFILTER=<program> -DFALLBACK=<mesh> -DRESULTS=<folder> -P run_demo.cmake
#
# The scan comes from the archive of CGAL's Debian packages; without it, the mesh of this repository takes its place.

set(archive /usr/share/doc/libcgal-dev/data.tar.gz)
set(scan data/meshes/bunny00.off)

# To the same stream as the program, so that the lines keep their order when piped.
function(say line)
  execute_process(COMMAND ${CMAKE_COMMAND} -E echo "${line}")
endfunction()

file(MAKE_DIRECTORY ${RESULTS})
if(EXISTS ${archive})
  file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${RESULTS} PATTERNS ${scan})
endif()
if(EXISTS ${RESULTS}/${scan})
  set(input ${RESULTS}/${scan})
  say("The scan: ${scan} from ${archive}")
else()
  set(input ${FALLBACK})
  say("No ${archive} with ${scan}: using ${FALLBACK}")
endif()

function(filter what result)
  string(JOIN " " options ${ARGN})
  say("")
  say("${what}: gradient_domain_filter ${options}")
  execute_process(
    COMMAND ${FILTER} ${input} ${RESULTS}/${result} ${ARGN}
    RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "gradient_domain_filter failed: ${status}")
  endif()
  say("  result: ${RESULTS}/${result}")
endfunction()

filter("Smoothed" smoothed.ply --gradient-weight 1e-4 --gradient-scale 0 --verbose)
filter("Sharpened" sharpened.ply --gradient-weight 1e-4 --gradient-scale 2 --verbose)
