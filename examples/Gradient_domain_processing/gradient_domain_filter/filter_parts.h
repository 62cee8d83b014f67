// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILTER_PARTS_H
#define GRADIENT_DOMAIN_FILTER_FILTER_PARTS_H

#include "filter_mesh.h"
#include "signal.h"

#include <CGAL/Gradient_domain_processing/parameters.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace filter_mesh_impl {

namespace GDP = CGAL::Gradient_domain_processing;
using GDP::Error_code;

// Property maps over arrays that are indexed by the vertices or faces.
template <class Value>
struct Array_map
{
  typedef std::size_t key_type;
  typedef Value value_type;
  typedef const Value& reference;
  typedef boost::lvalue_property_map_tag category;

  std::vector<Value>* values;

  friend const Value& get(const Array_map& map, std::size_t key) { return (*map.values)[key]; }
  friend void put(const Array_map& map, std::size_t key, const Value& value) { (*map.values)[key] = value; }
};

// A weight: that of a property, or one for all.
struct Weight_map
{
  typedef std::size_t key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;

  const std::vector<double>* values; // none: the constant
  double constant;

  friend double get(const Weight_map& map, std::size_t key) { return map.values ? (*map.values)[key] : map.constant; }
};

// What all filters read of the file and the options. Throws Failure where a property is missing.
struct Filter_input
{
  std::vector<char> is_constrained;
  bool has_region = false;
  std::vector<std::size_t> region; // the faces all of whose vertices are selected
  std::string movable_axes;

  Filter_input(const Options& options, const Mesh_file& file);
};

// A vertex property at the faces, as the mean of the corners; empty without a name.
std::vector<double> at_faces(const Options& options, const Mesh_file& file, const std::string& name);

// What a pack of named parameters holds is known when compiled, and every pack is a compilation of its own: so one pack
// has all names, with values that change nothing where nothing is asked for.
template <class SparseLinearSolver>
auto common_parameters(const Options& options, Filter_input& input, Stage_clock& clock,
                       const SparseLinearSolver& solver)
{
  return GDP::parameters::sparse_linear_solver(solver)
    .visitor(std::ref(clock))
    .area_normalization(options.area_normalization)
    .border_condition(options.border)
    .non_manifold_condition(options.non_manifold)
    .weld_tolerance(options.weld_tolerance.value_or(-1)) // negative: nothing is welded
    .movable_axes(input.movable_axes)
    .max_displacement(options.max_displacement.value_or(std::numeric_limits<double>::infinity()))
    .vertex_is_constrained_map(Array_map<char>{&input.is_constrained});
}

// What Default_sparse_linear_solver is, for the report.
inline const char* default_solver_name()
{
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  return "cholmod";
#else
  return "eigen";
#endif
}

// Calls verb(), or verb(region) where there is one.
template <class Verb>
Error_code in_region(const Filter_input& input, Filter_facts& facts, const Verb& verb)
{
  if(!input.has_region)
    return verb();
  if(!input.region.empty())
    return verb(input.region);
  facts.why_unchanged = "the region is empty: no face has all of its vertices in it";
  return GDP::ok;
}

} // namespace filter_mesh_impl

#endif // GRADIENT_DOMAIN_FILTER_FILTER_PARTS_H
