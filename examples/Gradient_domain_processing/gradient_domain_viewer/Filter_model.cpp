// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Filter_model.h"
#include "Failure.h"
#include "Output_file.h"
#include "Prepared_filter.h"
#include "filter_mesh.h"
#include "normals.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace GDP = CGAL::Gradient_domain_processing;

namespace {

constexpr const char* program = "gradient_domain_filter";
constexpr const char* metric_names[] = {"embedding", "edge-aware", "anisotropic", "preserve-convex",
                                        "preserve-concave"};
constexpr const char* property_names[number_of_brushes] = {"region", "constrained", "gradient_scale"};

Mesh_file read_file(const std::string& path)
{
  std::string text = read_bytes(path);
  const File_format format = file_format(path);
  return parse_mesh_file(path, format, std::move(text));
}

// The shortest text that is this number again.
std::string shortest(double x)
{
  char text[40];
  for(int digits = 1; digits < 18; ++digits)
  {
    std::snprintf(text, sizeof text, "%.*g", digits, x);
    if(std::strtod(text, nullptr) == x)
      break;
  }
  return text;
}

Options parsed(std::vector<std::string> words)
{
  words.insert(words.begin(), program);
  std::vector<char*> pointers;
  for(std::string& word : words)
    pointers.push_back(word.data());
  Options options;
  parse_command_line(int(pointers.size()), pointers.data(), options);
  return options;
}

// As a shell wants it.
std::string quoted(const std::string& word)
{
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:";
  if(!word.empty() && word.find_first_not_of(plain) == std::string::npos)
    return word;
  std::string text = "'";
  for(char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void throw_unless_ok(GDP::Error_code code, const std::string& name, const Stage_clock& clock)
{
  if(code != GDP::ok)
    throw Failure(name, (clock.invalid().empty() ? "" : clock.invalid() + ": ") + GDP::get_error_message(code));
}

} // namespace

Filter_model::Filter_model(const std::string& path)
  : m_file(read_file(path)), m_wavelengths(m_file.points, m_file.polygons), m_painting(m_file.points, m_file.polygons),
    m_normals(vertex_normals(m_file.points, m_file.polygons)), m_smoothed(m_file.points), m_points(m_file.points)
{}

Filter_model::~Filter_model() = default;

void Filter_model::set(const Filter_settings& settings)
{
  const Filter_settings before = std::exchange(m_settings, settings);
  try
  {
    filter();
  }
  catch(...)
  {
    m_settings = before;
    m_prepared.reset();
    throw;
  }
  // The file of the paint has the scale in it.
  if(m_painting.has(Brush::MASK) && before.gradient_scale != settings.gradient_scale)
    m_is_painting_saved = false;
}

void Filter_model::filter()
{
  if(m_settings.operation != Operation::FILTER)
    return run_command();
  solve();
  const double scale = m_settings.gradient_scale;
  m_points = m_smoothed;
  // The solution is linear in lambda, and the original for 1.
  if(scale != 0)
    for(std::size_t v = 0; v < m_points.size(); ++v)
      m_points[v] = m_file.points[v] + (1 - scale) * (m_smoothed[v] - m_file.points[v]);
}

void Filter_model::solve()
{
  std::unique_ptr<Prepared_filter> prepared = std::move(m_prepared); // it is kept only if all goes well
  const std::vector<std::string> words = command_words("result.ply");
  if(!prepared)
    prepared = std::make_unique<Prepared_filter>(parsed(words), painted_file(0));
  const int solutions = prepared->number_of_solutions();
  throw_unless_ok(prepared->set(m_settings, m_smoothed), m_file.name, prepared->clock());
  m_number_of_solutions += prepared->number_of_solutions() - solutions;
  m_why_unchanged = prepared->why_unchanged();
  m_prepared = std::move(prepared);
}

void Filter_model::run_command()
{
  Mesh_file file = painted_file(m_settings.gradient_scale);
  Stage_clock clock(false);
  Filter_facts facts;
  throw_unless_ok(filter_mesh(parsed(command_words("result.ply")), file, clock, facts), m_file.name, clock);
  m_points = std::move(file.points);
  m_why_unchanged = facts.why_unchanged;
  ++m_number_of_solutions;
}

bool Filter_model::paint(Brush brush, const Point& center, double radius, bool is_painted)
{
  if(!m_painting.dab(brush, m_points, center, radius, is_painted))
    return false;
  m_prepared.reset();
  m_is_painting_saved = !m_painting.has_any();
  return true;
}

void Filter_model::wipe_off()
{
  m_painting.wipe_off();
  m_prepared.reset();
  m_is_painting_saved = true;
}

std::vector<double> Filter_model::displacements() const
{
  std::vector<double> displacements(m_points.size());
  for(std::size_t v = 0; v < m_points.size(); ++v)
    displacements[v] = (m_points[v] - m_file.points[v]) * m_normals[v];
  return displacements;
}

std::vector<double> Filter_model::curvatures(const std::vector<Point>& points) const
{
  Mesh_file file;
  file.points = points;
  file.polygons = m_file.polygons;
  Stage_clock clock(false);
  Filter_facts facts;
  const Options options = parsed({"points.ply", "curvature.ply", "--signal", "curvature"});
  throw_unless_ok(filter_mesh(options, file, clock, facts), m_file.name, clock);
  return file.vertex_columns.find("curvature")->values;
}

// A name that the file does not have.
std::string Filter_model::property(Brush brush) const
{
  std::string name = property_names[std::size_t(brush)];
  while(m_file.vertex_columns.find(name))
    name = "painted_" + name;
  return name;
}

std::vector<std::string> Filter_model::command_words(const std::string& output) const
{
  const Filter_settings& s = m_settings;
  std::vector<std::string> words = {m_painting.has_any() ? painting_path() : m_file.name, output};
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back("--" + option);
    words.push_back(value);
  };
  if(m_painting.has(Brush::REGION))
    add("region", property(Brush::REGION));
  if(m_painting.has(Brush::CONSTRAINED))
    add("constrain", property(Brush::CONSTRAINED));
  if(s.operation == Operation::DENOISE)
  {
    add("operation", "denoise");
    return words;
  }
  if(s.operation == Operation::ENHANCE_DETAILS)
    add("operation", "enhance-details");
  add("gradient-weight", shortest(s.gradient_weight));
  if(s.operation == Operation::FILTER && m_painting.has(Brush::MASK))
    add("gradient-scale-property", property(Brush::MASK));
  else if(s.operation == Operation::FILTER)
    add("gradient-scale", shortest(s.gradient_scale));
  if(s.metric == GDP::Curvature_metric_kind::EMBEDDING)
    return words;
  add("metric", metric_names[std::size_t(s.metric)]);
  add("curvature-weight", shortest(s.curvature_weight));
  add("presmoothing-weight", shortest(s.presmoothing_weight));
  return words;
}

std::string Filter_model::command(const std::string& output) const
{
  const std::vector<std::string> words = command_words(output);
  std::string text = program;
  for(std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 || words[i].compare(0, 2, "--") == 0 ? " \\\n  " : " ") + quoted(words[i]);
  return text;
}

std::string Filter_model::painting_path() const
{
  const std::filesystem::path path(m_file.name);
  return (path.parent_path() / (path.stem().string() + "_painted.ply")).string();
}

// Outside of the mask gradients are those of the original.
Mesh_file Filter_model::painted_file(double gradient_scale) const
{
  Mesh_file file = m_file;
  for(Brush brush : {Brush::REGION, Brush::CONSTRAINED, Brush::MASK})
  {
    if(!m_painting.has(brush))
      continue;
    Column column{property(brush), Number_type::DOUBLE, {}};
    for(char x : m_painting.painted(brush))
      column.values.push_back(brush == Brush::MASK ? (x ? gradient_scale : 1.) : double(x != 0));
    file.vertex_columns.push_back(std::move(column));
  }
  return file;
}

void Filter_model::save_painting()
{
  Output_file output(painting_path());
  Mesh_file file = painted_file(m_settings.gradient_scale);
  output.write(mesh_file_contents(file, {File_format::PLY, Encoding::DEFAULT, Precision::DEFAULT}));
  output.commit();
  m_is_painting_saved = true;
}

std::vector<std::string> Filter_model::save(const std::string& path) const
{
  const Options options = parsed(command_words(path));
  const Output_form form{options.output_format.value_or(m_file.format), options.encoding, options.precision};
  check_output_form(options, form);
  check_form(m_file, form, path);
  Output_file output(path);
  Mesh_file file = painted_file(m_settings.gradient_scale);
  Stage_clock clock(false);
  Filter_facts facts;
  throw_unless_ok(filter_mesh(options, file, clock, facts), m_file.name, clock);
  file.vertex_columns.resize(m_file.vertex_columns.size()); // without the paint
  update_normals(m_file.points, file);
  std::vector<std::string> sentences;
  for(const std::string& lost : not_kept(file, form))
    sentences.push_back("not kept: " + lost);
  if(!facts.why_unchanged.empty())
    sentences.push_back("nothing has changed: " + facts.why_unchanged);
  std::string contents = mesh_file_contents(file, form);
  output.write(is_compressed_name(path) ? packed(contents) : std::move(contents));
  output.commit();
  return sentences;
}
