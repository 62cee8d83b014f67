// Reading and writing a Surface_mesh takes as long to compile as the rest of a program: polygon_mesh_io.cpp does it for all of them.

#ifndef GDP_POLYGON_MESH_IO_H
#define GDP_POLYGON_MESH_IO_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <string>

namespace CGAL {
namespace IO {

extern template bool read_polygon_mesh(const std::string&, Surface_mesh<Simple_cartesian<double>::Point_3>&,
                                       const parameters::Default_named_parameters&);
extern template bool write_polygon_mesh(const std::string&, Surface_mesh<Simple_cartesian<double>::Point_3>&,
                                        const Named_function_parameters<int, internal_np::stream_precision_t>&);

} // namespace IO
} // namespace CGAL

#endif // GDP_POLYGON_MESH_IO_H
