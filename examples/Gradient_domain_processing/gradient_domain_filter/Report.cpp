// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Report.h"
#include "files/file_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace {

// In bytes; negative where the system does not tell.
double peak_memory()
{
#if defined(__unix__) || defined(__APPLE__)
  rusage usage;
  if(getrusage(RUSAGE_SELF, &usage) == 0)
#ifdef __APPLE__
    return double(usage.ru_maxrss);
#else
    return 1024. * double(usage.ru_maxrss);
#endif
#endif
  return -1;
}

std::string number(double x, const char* format = "%.17g")
{
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

std::string json_number(double x) { return std::isfinite(x) ? number(x) : "null"; }
std::string known(double x) { return x < 0 ? "null" : json_number(x); }

// How many bytes the UTF-8 character at `i` has; 0 if there is none.
std::size_t utf8_length(const std::string& s, std::size_t i)
{
  const unsigned char c = (unsigned char)s[i];
  const std::size_t length = c < 0x80                ? 1
                             : c >= 0xc2 && c < 0xe0 ? 2
                             : c >= 0xe0 && c < 0xf0 ? 3
                             : c >= 0xf0 && c < 0xf5 ? 4
                                                     : 0;
  for(std::size_t k = 1; k < length; ++k)
    if(i + k >= s.size() || ((unsigned char)s[i + k] & 0xc0) != 0x80)
      return 0;
  return length;
}

std::string json_string(const std::string& s)
{
  std::string quoted = "\"";
  for(std::size_t i = 0; i < s.size();)
  {
    const std::size_t length = utf8_length(s, i);
    if(length == 0)
      quoted += "\\ufffd";
    else if(s[i] == '"' || s[i] == '\\')
      quoted += std::string("\\") + s[i];
    else if((unsigned char)s[i] < 0x20)
    {
      char buffer[8];
      std::snprintf(buffer, sizeof buffer, "\\u%04x", (unsigned)s[i]);
      quoted += buffer;
    }
    else
      quoted.append(s, i, length);
    i += length == 0 ? 1 : length;
  }
  return quoted + "\"";
}

// Lines of "key": value between braces.
class Json_object
{
  std::string m_text;
  std::string m_indent;

public:
  explicit Json_object(const std::string& indent) : m_indent(indent) {}
  Json_object& add(const std::string& key, const std::string& value)
  {
    m_text += (m_text.empty() ? "{\n" : ",\n") + m_indent + "  \"" + key + "\": " + value;
    return *this;
  }
  std::string text() const { return m_text + "\n" + m_indent + "}"; }
};

struct Range
{
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double x)
  {
    low = x < low ? x : low; // NaN is not
    high = x > high ? x : high;
  }
  void add(const Range& range)
  {
    low = (std::min)(low, range.low);
    high = (std::max)(high, range.high);
  }
  double extent() const { return high > low ? high - low : 0; }
};

// The weights that the operation really used, with their names; a property in quotes where one gave them.
std::vector<std::pair<std::string, std::string> > used_weights(const Options& o)
{
  std::vector<std::pair<std::string, std::string> > used;
  const auto add = [&](const char* name, double x, const std::string& property = std::string()) {
    used.emplace_back(name, property.empty() ? json_number(x) : json_string(property));
  };
  if(o.signal == Signal_kind::CURVATURE)
    return used;
  if(o.operation == Operation::DENOISE)
  {
    if(o.denoising_value_weight)
      add("value_weight", *o.denoising_value_weight);
    return used;
  }
  for(std::size_t i = 0; i < o.wavelengths.size(); ++i)
    add(i == 0 ? "wavelength" : "other_wavelength", o.wavelengths[i]);
  if(o.is_band())
    add("order", o.filter_order);
  if(!o.is_of_paper())
    return used;
  add("value_weight", o.value_weight, o.value_weight_property);
  add("gradient_weight", o.gradient_weight, o.gradient_weight_property);
  add("gradient_scale", o.gradient_scale, o.gradient_scale_property);
  if(o.hessian_weight > 0)
    add("hessian_weight", o.hessian_weight);
  if(o.has_metric())
    add("curvature_weight", o.curvature_weight);
  if(o.operation == Operation::ENHANCE_DETAILS)
  {
    add("sharpening_weight", o.sharpening_weight);
    add("sharpening_scale", o.sharpening_scale);
  }
  else if(o.signal == Signal_kind::NORMAL_TO_POSITION)
    add("normal_projection_weight", o.normal_projection_weight);
  else
    add("iterations", o.iterations);
  if(o.non_shrinking > 1)
    add("non_shrinking", o.non_shrinking);
  return used;
}

std::string json_strings(const std::vector<std::string>& strings)
{
  std::string text;
  for(const std::string& s : strings)
    text += (text.empty() ? "" : ", ") + json_string(s);
  return "[" + text + "]";
}

void add_survey(const Survey& survey, Json_object& all)
{
  all.add("vertices", std::to_string(survey.vertices))
    .add("edges", std::to_string(survey.edges))
    .add("faces", std::to_string(survey.faces))
    .add("border_edges", std::to_string(survey.border_edges))
    .add("crowded_edges", std::to_string(survey.crowded_edges))
    .add("components", std::to_string(survey.components))
    .add("area", json_number(survey.area));
}

} // namespace

namespace {

// What a block of vertices or faces has to say.
struct Block_changes
{
  std::size_t changed = 0;
  double largest = 0, sum = 0;
  bool is_filled = false;
  std::vector<Range> was, is; // of what has changed, by channel

  explicit Block_changes(std::size_t channels) : was(channels), is(channels) {}

  // How far a value has moved.
  double add(const std::vector<std::vector<double> >& before, const std::vector<std::vector<double> >& after,
             std::size_t i)
  {
    double change = 0;
    bool is_changed = false;
    for(std::size_t c = 0; c < after.size(); ++c)
    {
      is_changed =
        is_changed || !(before[c][i] == after[c][i] || (std::isnan(before[c][i]) && std::isnan(after[c][i])));
      if(const double x = after[c][i] - before[c][i]; std::isfinite(x))
        change = std::hypot(change, x);
      is_filled = is_filled || (std::isnan(before[c][i]) && !std::isnan(after[c][i]));
    }
    for(std::size_t c = 0; c < after.size() && is_changed; ++c)
    {
      was[c].add(before[c][i]);
      is[c].add(after[c][i]);
    }
    changed += is_changed;
    largest = (std::max)(largest, change);
    sum += change;
    return change;
  }

  void add(const Block_changes& block)
  {
    changed += block.changed;
    largest = (std::max)(largest, block.largest);
    sum += block.sum;
    is_filled = is_filled || block.is_filled;
    for(std::size_t c = 0; c < was.size(); ++c)
    {
      was[c].add(block.was[c]);
      is[c].add(block.is[c]);
    }
  }
};

} // namespace

bool Report::measure(const std::vector<std::vector<double> >& before, const std::vector<std::vector<double> >& after)
{
  const std::size_t n = after.empty() ? 0 : after[0].size();
  if(before.size() != after.size())
  {
    changed_values = n;
    return true;
  }
  std::vector<double> change(n);
  std::vector<Block_changes> blocks(n / records_of_block + 1, Block_changes(after.size()));
  for_each_block_of_records(n, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      change[i] = blocks[begin / records_of_block].add(before, after, i);
  });
  Block_changes all(after.size());
  for(const Block_changes& block : blocks)
    all.add(block);
  changed_values = all.changed;
  max_displacement = all.largest;
  mean_displacement = n > 0 ? all.sum / double(n) : 0;

  const bool has_parts = survey && survey->part_of_vertex.size() == n;
  displacement_of_part.assign(has_parts ? survey->parts.size() : 0, 0.);
  for(std::size_t i = 0; i < n && has_parts; ++i)
    if(survey->part_of_vertex[i] >= 0)
    {
      double& most = displacement_of_part[std::size_t(survey->part_of_vertex[i])];
      most = (std::max)(most, change[i]);
    }
  double rounding = 0, extent_before = 0, extent_after = 0;
  for(std::size_t c = 0; c < after.size() && changed_values > 0; ++c)
  {
    rounding = (std::max)({rounding, 1e-12 * all.is[c].extent(), 1e-15 * std::abs(all.is[c].high),
                           1e-15 * std::abs(all.is[c].low)});
    extent_before = (std::max)(extent_before, all.was[c].extent());
    extent_after = (std::max)(extent_after, all.is[c].extent());
  }
  if(extent_before > 0)
    extent_ratio = extent_after / extent_before;
  return all.is_filled || (changed_values > 0 && max_displacement > rounding);
}

namespace {

// Parts whose vertices move by less than a thousandth of an edge, while others do move.
std::string idle_parts(const Survey& survey, const std::vector<double>& displacements)
{
  std::size_t idle = 0, first = 0;
  for(std::size_t i = 0; i < displacements.size(); ++i)
    if(displacements[i] < 1e-3 * std::sqrt(survey.parts[i].area / double(survey.parts[i].faces)))
    {
      first = idle == 0 ? survey.parts[i].first_face : first;
      ++idle;
    }
  if(idle == 0)
    return std::string();
  return std::to_string(idle) + (idle == 1 ? " part hardly moves" : " parts hardly move") + ", "
         + (idle == 1 ? "that" : "first that") + " of face " + std::to_string(first)
         + ": the gradient weight is small for such large faces";
}

} // namespace

std::vector<std::string> Report::remarks(const Options& o) const
{
  std::vector<std::string> remarks = notices;
  if(!survey)
    return remarks;
  const bool has_one_weight =
    o.is_of_paper() && o.signal != Signal_kind::CURVATURE && o.gradient_weight_property.empty();
  const bool near_ones_are_welded =
    o.weld_tolerance.value_or(0) > 0
    && std::any_of(notices.begin(), notices.end(),
                   [](const std::string& s) { return s.find("welded") != std::string::npos; });
  for(const std::string& remark : survey->remarks(o.weld_tolerance.has_value(), near_ones_are_welded, has_one_weight))
    remarks.push_back(remark);
  const bool is_everywhere = o.moves_vertices() && o.region_property.empty() && o.constrained_property.empty();
  const auto free = CGAL::Gradient_domain_processing::Border_condition::FREE;
  const bool nothing_else_holds = !o.max_displacement && o.border == free && o.non_manifold == free;
  if(has_one_weight && !near_ones_are_welded && is_everywhere && nothing_else_holds)
    if(const std::string idle = idle_parts(*survey, displacement_of_part); !idle.empty())
      remarks.push_back(idle);
  const bool keeps_extent = o.operation != Operation::HIGH_PASS && o.operation != Operation::BAND_PASS
                            && o.operation != Operation::FAIR;
  if(is_everywhere && keeps_extent && !(extent_ratio > 0.2 && extent_ratio < 5))
    remarks.push_back("what has changed is " + number(extent_ratio, "%.2g")
                      + " times as large as before: are the weights, or wavelengths, those that were meant?");
  if(o.operation == Operation::FILTER && o.moves_vertices() && o.value_weight == 0 && o.value_weight_property.empty()
     && o.hessian_weight == 0 && !o.constrained_property.empty())
    remarks.push_back(
      "without a value weight the surface is spanned like a soap film; --operation fair goes on smoothly");
  if(o.has_metric() && o.curvature == CGAL::Gradient_domain_processing::Curvature_estimator::JETS
     && 20 * survey->needles > survey->faces)
    remarks.push_back(
      std::to_string(survey->needles)
      + " faces are needles, on which the curvature of "
        "fitted jets may be far off: --curvature normals --presmoothing-weight 0 keeps closer to the surface");
  return remarks;
}

std::string Report::json(const Options& o, const Stage_clock& clock) const
{
  Json_object seconds("  "), all("");
  for(const auto& stage : clock.seconds())
    seconds.add(stage.first, json_number(stage.second));
  seconds.add("total", json_number(clock.total()));
  all.add("input", json_string(o.input))
    .add("output", json_string(o.output))
    .add("operation", json_string(o.operation_name))
    .add("signal", json_string(o.signal_name));
  if(o.is_of_paper() || o.is_band())
    all.add("metric", json_string(o.metric_name));
  for(const auto& weight : used_weights(o))
    all.add(weight.first, weight.second);
  for(const auto& fact : facts.found)
    all.add(fact.first, json_number(fact.second));
  if(survey)
    add_survey(*survey, all);
  all.add("solver", json_string(facts.solver))
    .add("matrix_non_zeros", known(facts.matrix_non_zeros))
    .add("factor_non_zeros", known(facts.factor_non_zeros))
    .add("solver_iterations", known(facts.iterations))
    .add("max_displacement", json_number(max_displacement))
    .add("mean_displacement", json_number(mean_displacement))
    .add("changed", std::to_string(changed_values))
    .add("why_unchanged", why_unchanged.empty() ? "null" : json_string(why_unchanged))
    .add("updated_normals", std::to_string(updated_normals))
    .add("remarks", json_strings(remarks(o)))
    .add("not_kept", json_strings(not_kept))
    .add("seconds", seconds.text())
    .add("peak_memory_bytes", known(peak_memory()));
  return all.text() + "\n";
}

std::string Report::summary(const Options& o, const Stage_clock& clock) const
{
  std::string text = "read " + o.input_name();
  if(survey)
    text +=
      ": " + std::to_string(survey->vertices) + " vertices, " + std::to_string(survey->faces) + " faces, "
      + (survey->border_edges == 0 ? std::string("closed") : std::to_string(survey->border_edges) + " border edges")
      + ", area " + number(survey->area, "%.6g");
  text += "\n";
  for(const std::string& remark : remarks(o))
    text += "  " + remark + "\n";
  if(o.only_adds())
    text += o.operation == Operation::SPECTRUM ? std::to_string(facts.eigenvalues.size()) + " harmonics found\n"
                                               : "curvature estimated\n";
  else
  {
    text += o.operation_name + " " + o.signal_name + ":";
    for(auto weight : used_weights(o))
    {
      std::replace(weight.first.begin(), weight.first.end(), '_', ' ');
      char* end = nullptr;
      const double x = std::strtod(weight.second.c_str(), &end);
      text += " " + weight.first + " " + (*end == 0 ? number(x, "%g") : "from " + weight.second) + ",";
    }
    for(const auto& fact : facts.found)
    {
      std::string name = fact.first;
      std::replace(name.begin(), name.end(), '_', ' ');
      text += " " + name + " " + number(fact.second, "%.4g") + ",";
    }
    text += (!o.is_of_paper() && !o.is_band() ? "" : " metric " + o.metric_name + ",") + std::string(" solver ")
            + facts.solver + "\n";
    text += o.moves_vertices() ? "vertices moved by " : "values changed by ";
    text += number(mean_displacement, "%.4g") + " on average, " + number(max_displacement, "%.4g") + " at most\n";
  }
  text += "seconds:";
  for(const auto& stage : clock.seconds())
    if(stage.second >= 0.0005)
      text += " " + stage.first + " " + number(stage.second, "%.3f") + ",";
  return text + " total " + number(clock.total(), "%.3f") + "\nwrote " + o.output_name() + "\n";
}
