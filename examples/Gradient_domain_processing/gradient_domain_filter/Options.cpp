// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"
#include "Failure.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <utility>

#ifndef GRADIENT_DOMAIN_PROCESSING_VERSION
#define GRADIENT_DOMAIN_PROCESSING_VERSION "unknown"
#endif

namespace po = boost::program_options;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

template <class T>
T choice(const po::variables_map& given, const std::string& option, std::initializer_list<std::pair<const char*, T> > choices)
{
  const std::string& word = given[option].as<std::string>();
  std::string known;
  for(const auto& c : choices)
  {
    if(word == c.first)
      return c.second;
    known += (known.empty() ? "" : ", ") + std::string(c.first);
  }
  throw Usage_error("--" + option + " is one of " + known + ", not '" + word + "'");
}

bool is_given(const po::variables_map& given, const std::string& option)
{
  return given.count(option) && !given[option].defaulted();
}

void exclude(const po::variables_map& given, const std::string& a, const std::string& b)
{
  if(is_given(given, a) && is_given(given, b))
    throw Usage_error("--" + a + " contradicts --" + b);
}

// An option that would have no effect is a mistake.
void require(const po::variables_map& given, std::initializer_list<const char*> options, bool has_effect, const char* needed)
{
  for(const char* option : options)
    if(!has_effect && is_given(given, option))
      throw Usage_error("--" + std::string(option) + " needs " + needed);
}

void check_number(const char* option, double x, bool non_negative)
{
  if(!std::isfinite(x) || (non_negative && x < 0))
    throw Usage_error("--" + std::string(option) + " is a " + (non_negative ? "number, at least 0" : "finite number"));
}

// However they are spelled, and whether they exist.
bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  const auto place_a = std::filesystem::weakly_canonical(a, error), place_b = std::filesystem::weakly_canonical(b, error);
  return a == b || (!error && std::filesystem::absolute(place_a, error) == std::filesystem::absolute(place_b, error))
         || std::filesystem::equivalent(a, b, error);
}

po::options_description filter_options(Options& o)
{
  po::options_description d("What is done", 100, 60);
  d.add_options()
    ("operation", po::value<std::string>()->default_value("filter"), "filter | enhance-details (smooth, then sharpen what is left) | denoise")
    ("signal", po::value<std::string>()->default_value("position"),
     "position | normal | color | normal-to-position (filter the normals, then fit the positions to them) | curvature (nothing is "
     "filtered: k1^2 + k2^2 is written as property 'curvature' and as color)")
    ("value-weight", po::value(&o.value_weight)->default_value(1, "1"), "alpha: how strongly values are kept")
    ("gradient-weight", po::value(&o.gradient_weight)->default_value(1e-4, "1e-4"),
     "beta: how strongly gradients are fitted, 1e-6 (fine noise) to 1e-2; in units of the area of the mesh")
    ("gradient-scale", po::value(&o.gradient_scale)->default_value(0, "0"), "lambda: below 1 smooths, above 1 sharpens")
    ("metric", po::value<std::string>()->default_value("embedding"),
     "embedding | edge-aware | anisotropic | preserve-convex | preserve-concave; edge-aware if a --curvature-weight is given")
    ("curvature-weight", po::value(&o.curvature_weight)->default_value(0.02, "0.02"), "epsilon: how strongly curvature stretches the metric")
    ("curvature", po::value<std::string>()->default_value("jets"), "jets | normals: how curvature is estimated")
    ("jet-degree", po::value(&o.jet_degree)->default_value(2), "2 to 4")
    ("presmoothing-weight", po::value(&o.presmoothing_weight)->default_value(1e-4, "1e-4"),
     "gamma: smoothing before curvature is estimated; 0 for none")
    ("normal-projection-weight", po::value(&o.normal_projection_weight)->default_value(100, "100"),
     "how strongly normal-to-position fits the normals")
    ("iterations", po::value(&o.iterations)->default_value(1), "passes, each with a metric of its own")
    ("sharpening-weight", po::value(&o.sharpening_weight)->default_value(1e-5, "1e-5"), "beta of the second pass of enhance-details")
    ("sharpening-scale", po::value(&o.sharpening_scale)->default_value(4, "4"), "lambda of the second pass of enhance-details")
    ("passes", po::value(&o.passes), "passes of denoise")
    ("area-normalization", po::value<std::string>()->default_value("on"), "on | off: weights are squared lengths in the unit of the file");
  return d;
}

po::options_description place_options(Options& o)
{
  po::options_description d("Where (PROPERTY: a number at every vertex of the file, as in PLY)", 100, 60);
  d.add_options()
    ("constrain", po::value(&o.constrained_property)->value_name("PROPERTY"), "vertices where it is not 0 are kept")
    ("region", po::value(&o.region_property)->value_name("PROPERTY"),
     "only faces with three vertices where it is not 0 are worked on; all other vertices are kept")
    ("value-weight-property", po::value(&o.value_weight_property)->value_name("PROPERTY"), "alpha at every vertex")
    ("gradient-weight-property", po::value(&o.gradient_weight_property)->value_name("PROPERTY"),
     "beta at every vertex; that of a face is the mean of its three")
    ("gradient-scale-property", po::value(&o.gradient_scale_property)->value_name("PROPERTY"), "lambda, likewise")
    ("border", po::value<std::string>()->default_value("free"),
     "free | fixed | along-border (the border is filtered as a curve of its own)")
    ("restore-volume", "scale every component so that it encloses the volume it enclosed before");
  return d;
}

po::options_description file_options(Options& o)
{
  po::options_description d("Files and machine", 100, 60);
  d.add_options()
    ("triangulate", "split faces that are not triangles; without it they are an error")
    ("repair", "make a manifold of a mesh that is none (slow); without it that is an error")
    ("ascii", "write PLY or STL as text (PLY is binary otherwise)")
    ("binary", "write PLY or STL in binary (STL is text otherwise: its binary form is single precision)")
    ("solver", po::value<std::string>()->default_value("auto"), "auto | eigen | cholmod | cg")
    ("threads", po::value(&o.threads), "at most so many threads (TBB)")
    ("report", po::value(&o.report)->value_name("FILE.json"), "write what was done, with times and memory")
    ("verbose", "say what was done")
    ("quiet", "no progress on the terminal")
    ("help", "this text")
    ("version", "the version");
  return d;
}

void print_help(const po::options_description& options)
{
  std::cout << "gradient_domain_filter INPUT OUTPUT [options]\n\n"
               "Smooths, sharpens and otherwise filters a signal on a triangle mesh by prescribing its gradients: finds the g that\n"
               "minimizes alpha |f - g|^2 + beta |lambda grad f - grad g|^2. Reads and writes OFF, OBJ, PLY and STL, by extension.\n"
               "Normals and colors, and for PLY all vertex properties, are kept as they are unless they are the signal; OUTPUT may be INPUT.\n"
            << options
            << "\nExit code: 0, or 1 if the work failed, or 2 if the command line makes no sense. On failure OUTPUT is as it was.\n\n"
               "  gradient_domain_filter scan.ply smooth.ply --gradient-weight 1e-4\n"
               "  gradient_domain_filter scan.ply sharp.ply --gradient-scale 2\n"
               "  gradient_domain_filter part.obj clean.obj --metric anisotropic --gradient-weight 1e-3\n";
}

void check_combination(const po::variables_map& given, const Options& o)
{
  const bool is_filter = o.operation == Operation::FILTER;
  const bool is_curvature = o.signal == Signal_kind::CURVATURE;
  const bool has_metric = o.metric != GDP::Curvature_metric_kind::EMBEDDING;

  if(!is_filter && o.signal != Signal_kind::POSITION)
    throw Usage_error("--operation " + o.operation_name + " contradicts --signal " + o.signal_name);
  if(is_given(given, "metric") && !has_metric)
    exclude(given, "metric", "curvature-weight");
  exclude(given, "value-weight", "value-weight-property");
  exclude(given, "gradient-weight", "gradient-weight-property");
  exclude(given, "gradient-scale", "gradient-scale-property");
  exclude(given, "ascii", "binary");
  exclude(given, "verbose", "quiet");
  exclude(given, "restore-volume", "constrain");
  exclude(given, "restore-volume", "region");

  if(is_curvature)
  {
    for(const char* option : {"value-weight", "gradient-weight", "gradient-scale", "metric", "curvature-weight", "iterations", "constrain",
                              "region", "value-weight-property", "gradient-weight-property", "gradient-scale-property", "border"})
      if(is_given(given, option))
        throw Usage_error("--" + std::string(option) + " contradicts --signal curvature, which filters nothing");
    if(o.curvature == GDP::Curvature_estimator::NORMALS)
      throw Usage_error("--curvature normals contradicts --signal curvature, which knows jets only");
    if(o.output_format != File_format::PLY)
      throw Usage_error("--signal curvature writes PLY only");
  }
  if(o.operation == Operation::DENOISE)
    for(const char* option : {"value-weight", "gradient-weight", "gradient-scale", "metric", "curvature-weight", "restore-volume",
                              "value-weight-property", "gradient-weight-property", "gradient-scale-property"})
      if(is_given(given, option))
        throw Usage_error("--" + std::string(option) + " contradicts --operation denoise, which chooses from the data");
  require(given, {"curvature", "jet-degree", "presmoothing-weight"}, has_metric || is_curvature, "a --metric other than embedding");
  if(o.curvature == GDP::Curvature_estimator::NORMALS && is_given(given, "jet-degree"))
    throw Usage_error("--jet-degree contradicts --curvature normals");
  require(given, {"sharpening-weight", "sharpening-scale"}, o.operation == Operation::ENHANCE_DETAILS, "--operation enhance-details");
  require(given, {"passes"}, o.operation == Operation::DENOISE, "--operation denoise");
  require(given, {"normal-projection-weight"}, o.signal == Signal_kind::NORMAL_TO_POSITION, "--signal normal-to-position");
  require(given, {"iterations"}, is_filter && o.signal != Signal_kind::NORMAL_TO_POSITION,
          "--operation filter and a signal other than normal-to-position");
  require(given, {"restore-volume"}, o.moves_vertices(), "a signal that moves vertices");
  require(given, {"ascii", "binary"}, o.output_format == File_format::PLY || o.output_format == File_format::STL, "an output of PLY or STL");
  if(o.output_format == File_format::STL && !o.moves_vertices())
    throw Usage_error(o.output + ": STL cannot hold the signal " + o.signal_name);
  if(!o.report.empty() && is_same_file(o.report, o.output))
    throw Usage_error("--report is also the output");
  if(!o.report.empty() && is_same_file(o.report, o.input))
    throw Usage_error("--report is also the input");

  check_number("value-weight", o.value_weight, true);
  check_number("gradient-weight", o.gradient_weight, true);
  check_number("gradient-scale", o.gradient_scale, false);
  check_number("curvature-weight", o.curvature_weight, true);
  check_number("presmoothing-weight", o.presmoothing_weight, true);
  check_number("normal-projection-weight", o.normal_projection_weight, true);
  check_number("sharpening-weight", o.sharpening_weight, true);
  check_number("sharpening-scale", o.sharpening_scale, false);
  if(o.iterations < 1)
    throw Usage_error("--iterations is at least 1");
  if(o.jet_degree < 2 || o.jet_degree > 4)
    throw Usage_error("--jet-degree is 2, 3 or 4");
  if(is_given(given, "passes") && o.passes < 1)
    throw Usage_error("--passes is at least 1");
  if(is_given(given, "threads") && o.threads < 1)
    throw Usage_error("--threads is at least 1");
#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  if(o.solver == Solver_kind::CHOLMOD)
    throw Usage_error("--solver cholmod: this program was built without CHOLMOD");
#endif
}

} // namespace

bool parse_command_line(int argc, char* argv[], Options& o)
{
  po::options_description visible, all;
  visible.add(filter_options(o)).add(place_options(o)).add(file_options(o));
  all.add(visible).add_options()("files", po::value<std::vector<std::string> >());
  po::positional_options_description positional;
  positional.add("files", -1);
  po::variables_map given;
  try
  {
    namespace style = po::command_line_style;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional)
                .style(style::allow_long | style::long_allow_adjacent | style::long_allow_next).run(), given);
    po::notify(given);
  }
  catch(const po::error& error)
  {
    // what() replaces %value% and the like, and what it puts there too: with such a word it would never end
    for(int i = 1; i < argc; ++i)
      if(const char* const first = std::strchr(argv[i], '%'); first && std::strchr(first + 1, '%'))
        throw Usage_error("an option or its value makes no sense; is it '" + std::string(argv[i]) + "'?");
    throw Usage_error(error.what());
  }
  if(given.count("help"))
  {
    print_help(visible);
    return false;
  }
  if(given.count("version"))
  {
    std::cout << "gradient_domain_filter " << GRADIENT_DOMAIN_PROCESSING_VERSION << std::endl;
    return false;
  }
  const std::vector<std::string> files = given.count("files") ? given["files"].as<std::vector<std::string> >() : std::vector<std::string>();
  for(const std::string& file : files)
    if(file.size() > 1 && file[0] == '-')
      throw Usage_error("unknown option " + file);
  if(files.size() != 2)
    throw Usage_error("two files are needed, INPUT and OUTPUT (--help explains)");
  o.input = files[0];
  o.output = files[1];
  file_format(o.input);
  o.output_format = file_format(o.output);

  typedef GDP::Curvature_metric_kind Metric;
  o.operation = choice<Operation>(given, "operation", {{"filter", Operation::FILTER}, {"enhance-details", Operation::ENHANCE_DETAILS},
                                                       {"denoise", Operation::DENOISE}});
  o.signal = choice<Signal_kind>(given, "signal", {{"position", Signal_kind::POSITION}, {"normal", Signal_kind::NORMAL},
                                                   {"color", Signal_kind::COLOR}, {"normal-to-position", Signal_kind::NORMAL_TO_POSITION},
                                                   {"curvature", Signal_kind::CURVATURE}});
  o.metric = choice<Metric>(given, "metric", {{"embedding", Metric::EMBEDDING}, {"edge-aware", Metric::EDGE_AWARE},
                                              {"anisotropic", Metric::ANISOTROPIC}, {"preserve-convex", Metric::PRESERVE_CONVEX},
                                              {"preserve-concave", Metric::PRESERVE_CONCAVE}});
  o.curvature = choice<GDP::Curvature_estimator>(given, "curvature", {{"jets", GDP::Curvature_estimator::JETS},
                                                                      {"normals", GDP::Curvature_estimator::NORMALS}});
  o.border = choice<GDP::Border_condition>(given, "border", {{"free", GDP::Border_condition::FREE}, {"fixed", GDP::Border_condition::FIXED},
                                                             {"along-border", GDP::Border_condition::ALONG_BORDER}});
  o.solver = choice<Solver_kind>(given, "solver", {{"auto", Solver_kind::AUTO}, {"eigen", Solver_kind::EIGEN},
                                                   {"cholmod", Solver_kind::CHOLMOD}, {"cg", Solver_kind::CG}});
  o.area_normalization = choice<bool>(given, "area-normalization", {{"on", true}, {"off", false}});
  o.operation_name = given["operation"].as<std::string>();
  o.signal_name = given["signal"].as<std::string>();
  o.metric_name = given["metric"].as<std::string>();
  if(given["metric"].defaulted() && is_given(given, "curvature-weight"))
  {
    o.metric = Metric::EDGE_AWARE;
    o.metric_name = "edge-aware";
  }
  o.restores_volume = given.count("restore-volume") > 0;
  o.read.triangulate = given.count("triangulate") > 0;
  o.read.repair = given.count("repair") > 0;
  o.encoding = given.count("ascii") ? Encoding::ASCII : given.count("binary") ? Encoding::BINARY : Encoding::DEFAULT;
  o.is_verbose = given.count("verbose") > 0;
  o.is_quiet = given.count("quiet") > 0;
  check_combination(given, o);
  return true;
}
