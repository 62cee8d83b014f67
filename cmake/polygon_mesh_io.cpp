#include "polygon_mesh_io.h"

namespace CGAL {
namespace IO {

template bool read_polygon_mesh(const std::string&, Surface_mesh<Simple_cartesian<double>::Point_3>&,
                                const parameters::Default_named_parameters&);
template bool write_polygon_mesh(const std::string&, Surface_mesh<Simple_cartesian<double>::Point_3>&,
                                 const Named_function_parameters<int, internal_np::stream_precision_t>&);

} // namespace IO
} // namespace CGAL
