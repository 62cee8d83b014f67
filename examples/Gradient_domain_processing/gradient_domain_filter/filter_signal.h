// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILTER_SIGNAL_H
#define GRADIENT_DOMAIN_FILTER_FILTER_SIGNAL_H

#include "Failure.h"
#include "filter_parts.h"

#include <string>
#include <vector>

namespace filter_mesh_impl {

// The following read what the options name as signal, filter it in with_filter(body), which calls body(filtered), by
// filtered(values), for all of its channels, and put the result into the file. Normals, colors and properties are reals
// then, whatever the file made of them.

template <class With_filter>
Error_code filter_normals(const Options& options, Mesh_file& file, const With_filter& with_filter)
{
  std::vector<Three_channels> normals = normal_signal(options, file);
  return with_filter([&](const auto& filtered) -> Error_code {
    const Error_code code = filtered(normals);
    if(code == GDP::ok)
      set_normal_signal(options, normals, file);
    return code;
  });
}

template <class With_filter>
Error_code filter_colors(const Options& options, Mesh_file& file, const With_filter& with_filter)
{
  std::vector<Three_channels> colors = color_signal(options, file);
  const Column* const column = file.vertex_columns.find("alpha");
  std::vector<double> alpha = column ? column->values : std::vector<double>();
  return with_filter([&](const auto& filtered) -> Error_code {
    if(const Error_code code = filtered(colors))
      return code;
    if(const Error_code code = alpha.empty() ? GDP::ok : filtered(alpha))
      return code;
    set_color_signal(colors, alpha, file);
    return GDP::ok;
  });
}

template <class With_filter>
Error_code filter_properties(const Options& options, Mesh_file& file, const With_filter& with_filter)
{
  Property_signal signal = property_signal(options, file);
  if(signal.is_at_faces)
    throw Failure(options.input_name(), "--operation " + options.operation_name
                                          + " works on signals of vertices, and '" + options.signal_name
                                          + "' is one of faces");
  return with_filter([&](const auto& filtered) -> Error_code {
    for(std::vector<double>& values : signal.values)
      if(const Error_code code = filtered(values))
        return code;
    signal.set();
    return GDP::ok;
  });
}

} // namespace filter_mesh_impl

#endif // GRADIENT_DOMAIN_FILTER_FILTER_SIGNAL_H
