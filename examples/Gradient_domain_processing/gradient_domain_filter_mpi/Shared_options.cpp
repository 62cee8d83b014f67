// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shared_options.h"

#include "../gradient_domain_filter/Failure.h"

#include <algorithm>
#include <string>

const char* const shared_options_help =
  "mpirun -n N gradient_domain_filter_mpi INPUT.ply OUTPUT.ply [options]\n"
  "\n"
  "Filters a surface that is too large for one machine: gradient_domain_filter on many processes. Every process\n"
  "reads, holds and writes its part of a binary PLY file of triangles. These options of gradient_domain_filter are\n"
  "known here, and mean the same; its --help explains them:\n"
  "\n"
  "  --operation filter|enhance-details --signal position|normal|color|PROPERTY,... --value-weight --gradient-weight\n"
  "  --gradient-scale --metric --curvature-weight --curvature --jet-degree --presmoothing-weight --non-shrinking\n"
  "  --iterations --sharpening-weight --sharpening-scale --area-normalization --constrain --value-weight-property\n"
  "  --gradient-weight-property --gradient-scale-property --no-weld --keep-normals --verbose --quiet --help --version\n"
  "\n"
  "The environment variable PETSC_OPTIONS changes the solver: conjugate gradients, preconditioned by the diagonal or,\n"
  "where the weight is large for the size of the triangles, by multigrid.\n";

namespace {

constexpr const char* known[] = {
  "operation", "signal", "value-weight", "gradient-weight", "gradient-scale", "metric", "curvature-weight", "curvature",
  "jet-degree", "presmoothing-weight", "non-shrinking", "iterations", "sharpening-weight", "sharpening-scale",
  "area-normalization", "constrain", "value-weight-property", "gradient-weight-property", "gradient-scale-property",
  "no-weld", "keep-normals", "verbose", "quiet"};

} // namespace

void check_shared_options(int argc, char* argv[], const Options& o)
{
  for(int i = 1; i < argc; ++i)
  {
    const std::string word(argv[i]);
    if(word.compare(0, 2, "--") != 0)
      continue;
    const std::string name = word.substr(2, word.find('=') - 2);
    if(std::find(std::begin(known), std::end(known), name) == std::end(known))
      throw Usage_error("--" + name + " works on one machine only: gradient_domain_filter has it");
  }
  if(o.operation != Operation::FILTER && o.operation != Operation::ENHANCE_DETAILS)
    throw Usage_error("--operation " + o.operation_name + " works on one machine only: gradient_domain_filter has it");
  if(o.signal == Signal_kind::NORMAL_TO_POSITION || o.signal == Signal_kind::CURVATURE)
    throw Usage_error("--signal " + o.signal_name + " works on one machine only: gradient_domain_filter has it");
  for(const std::string* file : {&o.input, &o.output})
    if(*file == "-" || is_compressed_name(*file) || file_format(*file) != File_format::PLY)
      throw Usage_error(*file + ": only files of PLY, not packed, can be read and written in parts");
  if(o.value_weight == 0)
    throw Usage_error("--value-weight 0 works on one machine only: the system would be singular without constraints");
}
