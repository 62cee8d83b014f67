// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"
#include "Failure.h"
#include "option_parts.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <locale>
#include <set>
#include <sstream>
#include <utility>

#ifndef GRADIENT_DOMAIN_PROCESSING_VERSION
#define GRADIENT_DOMAIN_PROCESSING_VERSION "unknown"
#endif

namespace po = boost::program_options;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

template <class T>
T choice(const po::variables_map& given, const std::string& option,
         std::initializer_list<std::pair<const char*, T> > choices)
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

// The value of --non-shrinking may be left out, so Boost takes one only after a '='.
std::vector<std::string> words(int argc, char* argv[])
{
  std::vector<std::string> words(argv + 1, argv + argc);
  for(std::size_t i = 0; i + 1 < words.size(); ++i)
    if(words[i] == "--non-shrinking" && !words[i + 1].empty()
       && words[i + 1].find_first_not_of("0123456789") == std::string::npos)
    {
      words[i] += "=" + words[i + 1];
      words.erase(words.begin() + std::ptrdiff_t(i) + 1);
    }
  return words;
}

void store(int argc, char* argv[], const po::options_description& all, po::variables_map& given)
{
  po::positional_options_description positional;
  positional.add("files", -1);
  try
  {
    namespace style = po::command_line_style;
    po::store(po::command_line_parser(words(argc, argv)).options(all).positional(positional)
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
}

void read_files(const po::variables_map& given, Options& o)
{
  const std::vector<std::string> files =
    given.count("files") ? given["files"].as<std::vector<std::string> >() : std::vector<std::string>();
  for(const std::string& file : files)
    if(file.size() > 1 && file[0] == '-')
      throw Usage_error("unknown option " + file);
  if(files.size() != 2)
    throw Usage_error("two files are needed, INPUT and OUTPUT (--help explains)");
  o.input = files[0];
  o.output = files[1];
  const auto format = [&](const char* option, const std::string& file) -> std::optional<File_format> {
    if(given.count(option))
      return choice<File_format>(
        given, option,
        {{"off", File_format::OFF}, {"obj", File_format::OBJ}, {"ply", File_format::PLY}, {"stl", File_format::STL}});
    if(file == "-")
      return std::nullopt;
    return file_format(file);
  };
  o.input_format = format("input-format", o.input);
  o.output_format = format("output-format", o.output);
  if(!o.output_format)
    o.output_format = o.input_format;
}

void read_choices(const po::variables_map& given, Options& o)
{
  typedef GDP::Curvature_metric_kind Metric;
  o.operation = choice<Operation>(given, "operation",
                                  {{"filter", Operation::FILTER},
                                   {"enhance-details", Operation::ENHANCE_DETAILS},
                                   {"denoise", Operation::DENOISE},
                                   {"fair", Operation::FAIR},
                                   {"low-pass", Operation::LOW_PASS},
                                   {"high-pass", Operation::HIGH_PASS},
                                   {"band-pass", Operation::BAND_PASS},
                                   {"band-stop", Operation::BAND_STOP},
                                   {"spectrum", Operation::SPECTRUM}});
  o.metric = choice<Metric>(given, "metric",
                            {{"embedding", Metric::EMBEDDING},
                             {"edge-aware", Metric::EDGE_AWARE},
                             {"anisotropic", Metric::ANISOTROPIC},
                             {"preserve-convex", Metric::PRESERVE_CONVEX},
                             {"preserve-concave", Metric::PRESERVE_CONCAVE}});
  o.curvature = choice<GDP::Curvature_estimator>(given, "curvature", {{"jets", GDP::Curvature_estimator::JETS},
                                                                      {"normals", GDP::Curvature_estimator::NORMALS}});
  o.border = choice<GDP::Border_condition>(given, "border",
                                           {{"free", GDP::Border_condition::FREE},
                                            {"fixed", GDP::Border_condition::FIXED},
                                            {"along-border", GDP::Border_condition::ALONG_BORDER}});
  o.non_manifold = choice<GDP::Border_condition>(given, "non-manifold",
                                                 {{"free", GDP::Border_condition::FREE},
                                                  {"fixed", GDP::Border_condition::FIXED},
                                                  {"along-lines", GDP::Border_condition::ALONG_BORDER}});
  o.solver = choice<Solver_kind>(given, "solver", {{"auto", Solver_kind::AUTO}, {"eigen", Solver_kind::EIGEN},
                                                   {"cholmod", Solver_kind::CHOLMOD}, {"cg", Solver_kind::CG}});
  o.normal_fit = choice<GDP::Normal_fit_kind>(
    given, "normal-fit", {{"faces", GDP::Normal_fit_kind::FACES}, {"edges", GDP::Normal_fit_kind::EDGES}});
  o.area_normalization = choice<bool>(given, "area-normalization", {{"on", true}, {"off", false}});
  if(given.count("precision"))
    o.precision = choice<Precision>(given, "precision", {{"single", Precision::SINGLE}, {"double", Precision::DOUBLE}});
  o.operation_name = given["operation"].as<std::string>();
  o.metric_name = given["metric"].as<std::string>();
  if(given["metric"].defaulted() && is_given(given, "curvature-weight"))
  {
    o.metric = Metric::EDGE_AWARE;
    o.metric_name = "edge-aware";
  }
}

// Any word that is not a kind of signal is the name of a property, or several with commas.
void read_signal(const po::variables_map& given, Options& o)
{
  static const std::pair<const char*, Signal_kind> kinds[] = {
    {"position", Signal_kind::POSITION}, {"normal", Signal_kind::NORMAL}, {"color", Signal_kind::COLOR},
    {"normal-to-position", Signal_kind::NORMAL_TO_POSITION}, {"curvature", Signal_kind::CURVATURE}};
  o.signal_name = given["signal"].as<std::string>();
  for(const auto& kind : kinds)
    if(o.signal_name == kind.first)
    {
      o.signal = kind.second;
      return;
    }
  o.signal = Signal_kind::PROPERTY;
  std::istringstream names(o.signal_name + ",");
  for(std::string name; std::getline(names, name, ',');)
  {
    if(name.empty())
      throw Usage_error("--signal '" + o.signal_name + "' has an empty name");
    if(std::find(o.signal_properties.begin(), o.signal_properties.end(), name) != o.signal_properties.end())
      throw Usage_error("--signal '" + o.signal_name + "' names " + name + " twice");
    o.signal_properties.push_back(name);
  }
}

// One or two numbers with a comma between them.
void read_wavelengths(const std::string& text, Options& o)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double x = 0;
  char comma = ',';
  while(comma == ',' && stream >> x)
  {
    o.wavelengths.push_back(x);
    comma = 0;
    stream >> comma;
  }
  if(!stream.eof() || comma == ',' || o.wavelengths.empty() || o.wavelengths.size() > 2)
    throw Usage_error("--wavelengths is one number, or two with a comma between them, not '" + text + "'");
}

void read_rest(const po::variables_map& given, Options& o)
{
  const auto number = [&](const char* option) {
    return given.count(option) ? std::optional<double>(given[option].as<double>()) : std::nullopt;
  };
  o.noise_level = number("noise-level");
  o.noise_scale = number("noise-scale");
  o.max_displacement = number("max-displacement");
  o.spectral_shift = number("shift");
  if(given.count("window"))
    o.window = choice<GDP::Spectral_window>(given, "window",
                                            {{"hamming", GDP::Spectral_window::HAMMING},
                                             {"hann", GDP::Spectral_window::HANN},
                                             {"blackman", GDP::Spectral_window::BLACKMAN},
                                             {"nuttall", GDP::Spectral_window::NUTTALL}});
  if(is_given(given, "value-weight"))
    o.denoising_value_weight = o.value_weight;
  if(given.count("passes"))
    o.passes = given["passes"].as<int>();
  if(given.count("weld-tolerance"))
    o.weld_tolerance = number("weld-tolerance");
  if(given.count("no-weld"))
    o.weld_tolerance = std::nullopt;
  if(given.count("axes"))
  {
    const std::string axes = given["axes"].as<std::string>();
    for(std::size_t i = 0; i < 3; ++i)
      o.moves_along[i] = axes.find("xyz"[i]) != std::string::npos;
    if(axes.empty() || axes.size() > 3 || axes.find_first_not_of("xyz") != std::string::npos
       || std::set<char>(axes.begin(), axes.end()).size() != axes.size())
      throw Usage_error("--axes is some of x, y and z, not '" + axes + "'");
  }
  if(given.count("wavelengths"))
    read_wavelengths(given["wavelengths"].as<std::string>(), o);
  // normals are fitted as they are, unless their filter is described
  if(o.signal == Signal_kind::NORMAL_TO_POSITION && !is_given(given, "gradient-scale")
     && !is_given(given, "gradient-weight") && !given.count("gradient-weight-property"))
    o.gradient_scale = 1;
  o.restores_volume = given.count("restore-volume") > 0;
  o.has_missing_values = given.count("missing-values") > 0;
  o.keeps_normals = given.count("keep-normals") > 0;
  o.encoding = given.count("ascii") ? Encoding::ASCII : given.count("binary") ? Encoding::BINARY : Encoding::DEFAULT;
  o.is_verbose = given.count("verbose") > 0;
  o.is_quiet = given.count("quiet") > 0;
}

} // namespace

bool parse_command_line(int argc, char* argv[], Options& o)
{
  const po::options_description visible = describe_options(o);
  po::options_description all;
  all.add(visible).add_options()("files", po::value<std::vector<std::string> >());
  po::variables_map given;
  store(argc, argv, all, given);
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
  read_files(given, o);
  read_choices(given, o);
  read_signal(given, o);
  read_rest(given, o);
  check_options(given, o);
  if(o.output_format)
    check_output_form(o, {*o.output_format, o.encoding, o.precision});
  return true;
}
