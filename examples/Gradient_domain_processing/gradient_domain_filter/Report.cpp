// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Report.h"

#include <cmath>
#include <cstdio>

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
  const std::size_t length = c < 0x80 ? 1 : c >= 0xc2 && c < 0xe0 ? 2 : c >= 0xe0 && c < 0xf0 ? 3 : c >= 0xf0 && c < 0xf5 ? 4 : 0;
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

} // namespace

void Report::count(const Mesh& mesh)
{
  vertices = mesh.number_of_vertices();
  edges = mesh.number_of_edges();
  faces = mesh.number_of_faces();
  for(Mesh::Edge_index e : mesh.edges())
    border_edges += mesh.is_border(e);
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
    area += std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
  }
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
    .add("signal", json_string(o.signal_name))
    .add("metric", json_string(o.metric_name))
    .add("value_weight", json_number(o.value_weight))
    .add("gradient_weight", json_number(o.gradient_weight))
    .add("gradient_scale", json_number(o.gradient_scale))
    .add("curvature_weight", json_number(o.curvature_weight))
    .add("iterations", std::to_string(o.iterations))
    .add("vertices", std::to_string(vertices))
    .add("edges", std::to_string(edges))
    .add("faces", std::to_string(faces))
    .add("border_edges", std::to_string(border_edges))
    .add("area", json_number(area))
    .add("solver", json_string(solver.name))
    .add("matrix_non_zeros", known(solver.matrix_non_zeros))
    .add("factor_non_zeros", known(solver.factor_non_zeros))
    .add("solver_iterations", known(solver.iterations))
    .add("max_displacement", json_number(max_displacement))
    .add("mean_displacement", json_number(mean_displacement))
    .add("seconds", seconds.text())
    .add("peak_memory_bytes", known(peak_memory()));
  return all.text() + "\n";
}

std::string Report::summary(const Options& o, const Stage_clock& clock, const std::vector<std::string>& notes) const
{
  std::string text = "read " + o.input + ": " + std::to_string(vertices) + " vertices, " + std::to_string(faces) + " faces, "
                     + (border_edges == 0 ? std::string("closed") : std::to_string(border_edges) + " border edges") + ", area "
                     + number(area, "%.6g") + "\n";
  for(const std::string& note : notes)
    text += "  " + note + "\n";
  if(o.signal == Signal_kind::CURVATURE)
    text += "curvature estimated\n";
  else
  {
    const auto weight = [](double constant, const std::string& property) {
      return property.empty() ? number(constant, "%g") : "from '" + property + "'";
    };
    text += o.operation_name + " " + o.signal_name + ": value weight " + weight(o.value_weight, o.value_weight_property)
            + ", gradient weight " + weight(o.gradient_weight, o.gradient_weight_property) + ", gradient scale "
            + weight(o.gradient_scale, o.gradient_scale_property) + ", metric " + o.metric_name
            + (o.metric_name == "embedding" ? "" : " (curvature weight " + number(o.curvature_weight, "%g") + ")") + ", solver "
            + solver.name + "\n";
    text += o.moves_vertices() ? "vertices moved by " : "values changed by ";
    text += number(mean_displacement, "%.4g") + " on average, " + number(max_displacement, "%.4g") + " at most\n";
  }
  text += "seconds:";
  for(const auto& stage : clock.seconds())
    if(stage.second >= 0.0005)
      text += " " + stage.first + " " + number(stage.second, "%.3f") + ",";
  return text + " total " + number(clock.total(), "%.3f") + "\nwrote " + o.output + "\n";
}
