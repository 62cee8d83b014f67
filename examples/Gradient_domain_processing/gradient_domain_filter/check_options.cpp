// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_parts.h"
#include "Failure.h"

#include <cmath>
#include <filesystem>
#include <initializer_list>

namespace po = boost::program_options;
namespace GDP = CGAL::Gradient_domain_processing;

bool is_given(const po::variables_map& given, const std::string& option)
{
  return given.count(option) && !given[option].defaulted();
}

namespace {

void exclude(const po::variables_map& given, const std::string& a, const std::string& b)
{
  if(is_given(given, a) && is_given(given, b))
    throw Usage_error("--" + a + " contradicts --" + b);
}

// None of the options may be given; `because` follows "contradicts".
void forbid(const po::variables_map& given, std::initializer_list<const char*> options, const std::string& because)
{
  for(const char* option : options)
    if(is_given(given, option))
      throw Usage_error("--" + std::string(option) + " contradicts " + because);
}

// An option that would have no effect is a mistake.
void require(const po::variables_map& given, std::initializer_list<const char*> options, bool has_effect,
             const char* needed)
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

void check_count(const char* option, int n)
{
  if(n < 1)
    throw Usage_error("--" + std::string(option) + " is at least 1");
}

// However they are spelled, and whether they exist.
bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  const auto place_a = std::filesystem::weakly_canonical(a, error),
             place_b = std::filesystem::weakly_canonical(b, error);
  return a == b || (!error && std::filesystem::absolute(place_a, error) == std::filesystem::absolute(place_b, error))
         || std::filesystem::equivalent(a, b, error);
}

void check_exclusions(const po::variables_map& given)
{
  for(const char* weight : {"value-weight", "gradient-weight", "gradient-scale"})
    exclude(given, weight, std::string(weight) + "-property");
  exclude(given, "ascii", "binary");
  exclude(given, "verbose", "quiet");
  exclude(given, "restore-volume", "constrain");
  exclude(given, "restore-volume", "region");
  exclude(given, "restore-volume", "axes");
  exclude(given, "restore-volume", "max-displacement");
  exclude(given, "weld-tolerance", "no-weld");
  exclude(given, "non-shrinking", "gradient-scale");
  exclude(given, "non-shrinking", "gradient-scale-property");
}

bool is_of_filter_only(Signal_kind signal)
{
  return signal == Signal_kind::NORMAL_TO_POSITION || signal == Signal_kind::CURVATURE;
}

// The operations that are not of the paper have none of its weights.
void check_beyond(const po::variables_map& given, const Options& o)
{
  const bool is_fair = o.operation == Operation::FAIR, is_spectrum = o.operation == Operation::SPECTRUM;
  if(is_fair || is_spectrum || o.is_band())
    forbid(given,
           {"value-weight", "gradient-weight", "gradient-scale", "hessian-weight", "value-weight-property",
            "gradient-weight-property", "gradient-scale-property", "non-shrinking", "iterations", "restore-volume",
            "missing-values", "solver"},
           "--operation " + o.operation_name);
  if(is_fair || is_spectrum)
    forbid(given, {"region", "metric", "curvature-weight", "area-normalization"}, "--operation " + o.operation_name);
  if(is_spectrum)
    forbid(given, {"border", "non-manifold", "weld-tolerance"}, "--operation spectrum");
  if(o.is_band())
    forbid(given, {"axes", "max-displacement"}, "--operation " + o.operation_name);
  require(given, {"region-vertices"}, is_fair, "--operation fair");
  require(given, {"wavelengths", "order", "window"}, o.is_band(),
          "--operation low-pass, high-pass, band-pass or band-stop");
  require(given, {"degree"}, o.is_band() && o.window, "--window");
  exclude(given, "order", "window");
  require(given, {"count", "eigenvalues", "shift"}, is_spectrum, "--operation spectrum");
  if(is_fair && o.region_vertices_property.empty() && o.constrained_property.empty())
    throw Usage_error("--operation fair needs --region-vertices, or --constrain and moves all others");
  const std::size_t needed = o.operation == Operation::LOW_PASS || o.operation == Operation::HIGH_PASS ? 1 : 2;
  if(o.is_band() && o.wavelengths.size() != needed)
    throw Usage_error("--operation " + o.operation_name + " needs --wavelengths with "
                      + (needed == 1 ? "one number" : "two numbers"));
  for(double x : o.wavelengths)
    if(!(x > 0) || !std::isfinite(x))
      throw Usage_error("--wavelengths are positive numbers");
}

void check_operation(const po::variables_map& given, const Options& o)
{
  if(o.operation != Operation::FILTER && o.signal != Signal_kind::POSITION
     && (!o.is_band() || is_of_filter_only(o.signal)))
    throw Usage_error("--operation " + o.operation_name + " contradicts --signal " + o.signal_name);
  if(o.signal == Signal_kind::CURVATURE)
  {
    forbid(given,
           {"value-weight", "gradient-weight", "gradient-scale", "metric", "curvature-weight", "iterations",
            "constrain", "region", "value-weight-property", "gradient-weight-property", "gradient-scale-property",
            "border", "non-manifold", "non-shrinking", "hessian-weight"},
           "--signal curvature, which filters nothing");
    if(o.curvature == GDP::Curvature_estimator::NORMALS)
      throw Usage_error("--curvature normals contradicts --signal curvature, which knows jets only");
  }
  if(o.operation == Operation::DENOISE)
    forbid(given,
           {"gradient-weight", "gradient-scale", "metric", "curvature-weight", "value-weight-property",
            "gradient-weight-property", "gradient-scale-property", "hessian-weight", "non-shrinking", "restore-volume",
            "solver"},
           "--operation denoise, which chooses from the data");
  if(o.operation == Operation::DENOISE && is_given(given, "value-weight") && !(o.value_weight > 0))
    throw Usage_error("--value-weight of --operation denoise is larger than 0");
  if(o.operation == Operation::DENOISE && o.non_manifold == GDP::Border_condition::ALONG_BORDER)
    throw Usage_error(
      "--non-manifold along-lines contradicts --operation denoise, which leaves such lines free or fixed");
  if(o.operation == Operation::ENHANCE_DETAILS)
    forbid(given, {"non-shrinking"}, "--operation enhance-details");
}

void check_needs(const po::variables_map& given, const Options& o)
{
  const bool is_filter = o.operation == Operation::FILTER, is_denoising = o.operation == Operation::DENOISE;
  const bool is_fit = o.signal == Signal_kind::NORMAL_TO_POSITION;
  require(given, {"curvature", "jet-degree", "presmoothing-weight"},
          o.has_metric() || o.signal == Signal_kind::CURVATURE, "a --metric other than embedding");
  if(o.curvature == GDP::Curvature_estimator::NORMALS && is_given(given, "jet-degree"))
    throw Usage_error("--jet-degree contradicts --curvature normals");
  if(is_given(given, "metric") && !o.has_metric())
    exclude(given, "metric", "curvature-weight");
  require(given, {"sharpening-weight", "sharpening-scale"}, o.operation == Operation::ENHANCE_DETAILS,
          "--operation enhance-details");
  require(given, {"passes", "noise-level", "noise-scale"}, is_denoising, "--operation denoise");
  require(given, {"normal-projection-weight", "normal-fit"}, is_fit, "--signal normal-to-position");
  require(given, {"iterations"}, is_filter && !is_fit, "--operation filter and a signal other than normal-to-position");
  require(given, {"non-shrinking"}, is_filter && !is_fit,
          "--operation filter and a signal other than normal-to-position");
  require(given, {"restore-volume", "axes", "max-displacement", "keep-normals", "picture"}, o.moves_vertices(),
          "a signal that moves vertices");
  require(given, {"missing-values"}, o.signal == Signal_kind::PROPERTY || o.fills_heights(),
          "--signal with the name of a property, or --axes with one axis");
}

void check_numbers(const Options& o)
{
  check_number("value-weight", o.value_weight, true);
  check_number("gradient-weight", o.gradient_weight, true);
  check_number("gradient-scale", o.gradient_scale, false);
  check_number("hessian-weight", o.hessian_weight, true);
  check_number("curvature-weight", o.curvature_weight, true);
  check_number("presmoothing-weight", o.presmoothing_weight, true);
  check_number("normal-projection-weight", o.normal_projection_weight, true);
  check_number("sharpening-weight", o.sharpening_weight, true);
  check_number("sharpening-scale", o.sharpening_scale, false);
  check_number("noise-level", o.noise_level.value_or(0), true);
  check_number("noise-scale", o.noise_scale.value_or(0), true);
  check_number("max-displacement", o.max_displacement.value_or(0), true);
  check_number("weld-tolerance", o.weld_tolerance.value_or(0), true);
  check_count("iterations", o.iterations);
  check_count("order", o.filter_order);
  check_count("count", o.number_of_harmonics);
  check_count("degree", o.filter_degree);
  check_number("shift", o.spectral_shift.value_or(0), false);
  check_count("non-shrinking", o.non_shrinking);
  check_count("passes", o.passes.value_or(1));
  if(o.jet_degree < 2 || o.jet_degree > 4)
    throw Usage_error("--jet-degree is 2, 3 or 4");
}

void check_files(const Options& o)
{
  if(!o.report.empty() && (o.report == "-" ? o.output == "-" : o.output != "-" && is_same_file(o.report, o.output)))
    throw Usage_error("--report is also the output");
  if(!o.report.empty() && o.report != "-" && o.input != "-" && is_same_file(o.report, o.input))
    throw Usage_error("--report is also the input");
  for(const std::string* other : {&o.input, &o.output, &o.report})
    if(!o.eigenvalues.empty() && !other->empty()
       && (o.eigenvalues == "-" ? *other == "-" && other != &o.input
                                : *other != "-" && is_same_file(o.eigenvalues, *other)))
      throw Usage_error(std::string("--eigenvalues is also the ")
                        + (other == &o.input ? "input" : other == &o.output ? "output" : "report"));
  for(const std::string* other : {&o.input, &o.output, &o.report, &o.eigenvalues})
    if(!o.picture.empty() && (o.picture == "-" || (!other->empty() && is_same_file(o.picture, *other))))
      throw Usage_error("--picture is a file of its own");
#ifndef GRADIENT_DOMAIN_FILTER_HAS_PICTURES
  if(!o.picture.empty())
    throw Usage_error("--picture: this program was built without VTK, which draws it (CGAL_GDP_WITH_VIEWER)");
#endif
#ifndef GRADIENT_DOMAIN_FILTER_HAS_ZLIB
  if(is_compressed_name(o.output))
    throw Usage_error(o.output + ": this program was built without Boost.Iostreams, which packs files");
#endif
}

} // namespace

void check_options(const po::variables_map& given, const Options& o)
{
  check_exclusions(given);
  check_operation(given, o);
  check_needs(given, o);
  check_beyond(given, o);
  check_numbers(o);
  check_files(o);
  if(is_given(given, "threads"))
    check_count("threads", o.threads);
#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  if(o.solver == Solver_kind::CHOLMOD)
    throw Usage_error("--solver cholmod: this program was built without CHOLMOD");
#endif
}

void check_output_form(const Options& o, const Output_form& form)
{
  const bool is_stl = form.format == File_format::STL, is_ply = form.format == File_format::PLY;
  if(o.signal == Signal_kind::CURVATURE && !is_ply)
    throw Usage_error("--signal curvature writes PLY only");
  if(o.operation == Operation::SPECTRUM && !is_ply)
    throw Usage_error("--operation spectrum writes PLY only: other formats have no properties");
  if(o.signal == Signal_kind::PROPERTY && !is_ply)
    throw Usage_error("--signal " + o.signal_name + " writes PLY only: other formats have no properties");
  if(is_stl && !o.moves_vertices() && o.operation != Operation::SPECTRUM)
    throw Usage_error(o.output_name() + ": STL cannot hold the signal " + o.signal_name);
  if(form.encoding != Encoding::DEFAULT && !is_stl && !is_ply)
    throw Usage_error(std::string(form.encoding == Encoding::ASCII ? "--ascii" : "--binary")
                      + " needs an output of PLY or STL");
}
