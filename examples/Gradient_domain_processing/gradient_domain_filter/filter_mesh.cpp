// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_mesh_impl.h"

#include <CGAL/Gradient_domain_processing/internal/linear_solver/memory_estimate.h>

CGAL::Gradient_domain_processing::Error_code filter_mesh(const Options& options, Mesh_file& file, Stage_clock& clock, Solver_facts& facts)
{
  switch(options.solver)
  {
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
    case Solver_kind::EIGEN: return filter_with_eigen(options, file, clock, facts);
#endif
    case Solver_kind::CG: return filter_with_cg(options, file, clock, facts);
    case Solver_kind::AUTO:
      if(!CGAL::Gradient_domain_processing::internal::cholesky_fits(file.mesh.number_of_vertices()))
        return filter_with_cg(options, file, clock, facts);
      return filter_with_default(options, file, clock, facts);
    default: return filter_with_default(options, file, clock, facts);
  }
}

namespace filter_mesh_impl {

const std::vector<double>& property(const Options& options, const Mesh_file& file, const std::string& name)
{
  const Column* const column = file.vertex_columns.find(name);
  if(!column)
  {
    std::string known;
    for(const Column& c : file.vertex_columns)
      known += (known.empty() ? "; there are: " : ", ") + c.name;
    throw Failure(options.input, "no vertex property '" + name + "'" + known);
  }
  for(std::size_t v = 0; v < column->values.size(); ++v)
    if(!std::isfinite(column->values[v]))
      throw Failure(options.input, "the property '" + name + "' of vertex " + std::to_string(v) + " is NaN or infinite");
  return column->values;
}

// Those of the file as they are, else normalized sums of the normals of the faces, weighted by area.
std::vector<Vector> vertex_normals(const Mesh_file& file)
{
  const Mesh& mesh = file.mesh;
  std::vector<Vector> normals(mesh.number_of_vertices(), Vector(0, 0, 0));
  if(file.vertex_columns.has_normals())
  {
    const std::vector<Three_channels> given = three_columns(file.vertex_columns, normal_names);
    for(std::size_t v = 0; v < normals.size(); ++v)
      normals[v] = Vector(given[v][0], given[v][1], given[v][2]);
    return normals;
  }

  // lengths relative to the extent, so that no product over- or underflows
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double extent = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  const double factor = extent > 0 ? std::ldexp(1., -std::ilogb(extent)) : 1;
  for(Mesh::Face_index f : mesh.faces())
  {
    std::array<Mesh::Vertex_index, 3> t;
    std::size_t corner = 0;
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      t[corner++ % 3] = v;
    const Vector n = CGAL::cross_product(factor * (mesh.point(t[1]) - mesh.point(t[0])), factor * (mesh.point(t[2]) - mesh.point(t[0])));
    for(Mesh::Vertex_index v : t)
      normals[std::size_t(v)] = normals[std::size_t(v)] + n;
  }
  for(Vector& n : normals)
  {
    const double length = std::sqrt(n.squared_length());
    n = length > 0 ? n / length : Vector(0, 0, 0);
  }
  return normals;
}

// Blue where it is flat, over white to red; the scale is logarithmic, from the 5th to the 95th percentile.
void write_curvature(const std::vector<double>& total_curvature, Columns& columns)
{
  std::vector<double> sorted = total_curvature;
  std::sort(sorted.begin(), sorted.end());
  const auto percentile = [&](std::size_t percent) { return sorted[(sorted.size() - 1) * percent / 100]; };
  const double most = percentile(95);
  const double least = (std::max)(percentile(5), 1e-6 * most);
  const double decades = most > least ? std::log(most / least) : 1;

  Column& curvature = columns.find_or_add("curvature", Number_type::DOUBLE, total_curvature.size());
  curvature.type = Number_type::DOUBLE;
  curvature.values = total_curvature;
  for(std::size_t i = 0; i < 3; ++i)
  {
    Column& color = columns.find_or_add(color_names[i], Number_type::UINT8, total_curvature.size());
    color.type = Number_type::UINT8;
    for(std::size_t v = 0; v < total_curvature.size(); ++v)
    {
      const double k = total_curvature[v];
      const double t = k <= least || !(most > 0) ? 0 : (std::min)(1., std::log(k / least) / decades);
      const double low = (std::min)(1., 2 * t), high = (std::min)(1., 2 - 2 * t); // of red, of blue
      color.values[v] = 255 * (i == 0 ? low : i == 1 ? (std::min)(low, high) : high);
    }
  }
}

} // namespace filter_mesh_impl
