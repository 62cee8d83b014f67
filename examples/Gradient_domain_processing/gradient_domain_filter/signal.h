// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_SIGNAL_H
#define GRADIENT_DOMAIN_FILTER_SIGNAL_H

#include "Options.h"

#include <array>
#include <string>
#include <vector>

// A vertex property of the file, for weights and selections: it must be there and finite. Throws Failure.
const std::vector<double>& vertex_property(const Options& options, const Mesh_file& file, const std::string& name);

// The properties that are the signal, all of vertices or all of faces. Throws Failure where there are no such, or where
// one has a value that is not finite; NaN may be, with --missing-values.
struct Property_signal
{
  bool is_at_faces = false;
  std::vector<Column*> columns;
  std::vector<std::vector<double> > values; // to work on

  // The values become those of the columns.
  void set();
};
Property_signal property_signal(const Options& options, Mesh_file& file);

typedef std::array<double, 3> Three_channels;

// The normals as a signal: those of the file as they are, else those of the surface. Throws Failure where the corners
// of a vertex have several.
std::vector<Three_channels> normal_signal(const Options& options, const Mesh_file& file);
void set_normal_signal(const Options& options, const std::vector<Three_channels>& normals, Mesh_file& file);

// The colors, without alpha, which may be there too. Throws Failure where there are none.
std::vector<Three_channels> color_signal(const Options& options, const Mesh_file& file);

// Colors are clamped to what was black and white before.
void set_color_signal(const std::vector<Three_channels>& colors, const std::vector<double>& alpha, Mesh_file& file);

// As property 'curvature' and as color: blue where it is flat, over white to red; the scale is logarithmic, from the
// 5th to the 95th percentile.
void set_curvature(const std::vector<double>& total_curvature, Mesh_file& file);

// What the filter works on, as columns, to see what has changed.
std::vector<std::vector<double> > signal_values(const Options& options, const Mesh_file& file);

// What of it is rounded to integers, as the file has them.
std::vector<std::string> rounded_signals(const Options& options, const Mesh_file& file, const Output_form& form);

#endif // GRADIENT_DOMAIN_FILTER_SIGNAL_H
