// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_REFERENCE_DATA_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_REFERENCE_DATA_H

#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/enum.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// The cases of data/references.txt; data/README.md says what is in them.
namespace gdp_test {

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;
typedef K::Vector_3 Vector;
namespace GDP = CGAL::Gradient_domain_processing;

typedef std::vector<std::vector<double> > Table;

struct Case
{
  std::string name, mesh, kind;
  int rows = 0, columns = 0;
  std::map<std::string, std::string> keys;

  bool has(const std::string& key) const { return keys.count(key) != 0; }
  std::string text(const std::string& key) const { return has(key) ? keys.at(key) : std::string(); }
  double number(const std::string& key, double fallback) const { return has(key) ? std::stod(keys.at(key)) : fallback; }
  bool is_relative() const { return text("weights") == "relative"; }

  // the numbers of m:a:b
  std::array<double, 3> triple(const std::string& key) const
  {
    std::array<double, 3> result{{1, 0, 0}};
    char colon;
    std::istringstream(text(key)) >> result[0] >> colon >> result[1] >> colon >> result[2];
    return result;
  }

  GDP::Curvature_metric_kind metric_kind() const
  {
    const std::string metric = text("metric");
    if(metric == "edge_aware") return GDP::Curvature_metric_kind::EDGE_AWARE;
    if(metric == "anisotropic") return GDP::Curvature_metric_kind::ANISOTROPIC;
    if(metric == "preserve_convex") return GDP::Curvature_metric_kind::PRESERVE_CONVEX;
    if(metric == "preserve_concave") return GDP::Curvature_metric_kind::PRESERVE_CONCAVE;
    return GDP::Curvature_metric_kind::EMBEDDING;
  }
};

inline Table read_table(const std::string& name)
{
  std::ifstream file("data/" + name + ".txt");
  GDP_CHECK(file.is_open());
  Table table;
  for(std::string line; std::getline(file, line);)
  {
    if(line.empty() || line[0] == '#')
      continue;
    std::istringstream stream(line);
    table.emplace_back();
    for(double x; stream >> x;)
      table.back().push_back(x);
  }
  return table;
}

inline std::vector<Case> read_cases()
{
  std::ifstream file("data/references.txt");
  GDP_CHECK(file.is_open());
  std::vector<Case> cases;
  for(std::string line; std::getline(file, line);)
  {
    if(line.empty() || line[0] == '#')
      continue;
    std::istringstream stream(line);
    Case c;
    stream >> c.name >> c.mesh >> c.kind >> c.rows >> c.columns;
    for(std::string word; stream >> word;)
      c.keys[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    cases.push_back(c);
  }
  return cases;
}

inline Mesh read_mesh(const std::string& name)
{
  Mesh tm;
  GDP_CHECK(CGAL::IO::read_OFF("data/" + name + ".off", tm));
  return tm;
}

inline Eigen::Vector3d eigen(const K::Point_3& p) { return Eigen::Vector3d(p.x(), p.y(), p.z()); }

// The corners of a face in the order of Triangle_metric, which need not be that of the file.
inline std::array<Eigen::Vector3d, 3> corners(const Mesh& tm, Face f)
{
  const auto h = tm.halfedge(f);
  return {{eigen(tm.point(tm.source(h))), eigen(tm.point(tm.target(h))), eigen(tm.point(tm.target(tm.next(h))))}};
}

// The metrics of the embedding, or, for metric=user, those of the file.
inline void face_metrics(const std::string& mesh, bool of_user, Mesh& tm,
                         Mesh::Property_map<Face, GDP::Triangle_metric>& metrics)
{
  metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  const Table tensors = of_user ? read_table(mesh + "_input_tensors") : Table();
  for(Face f : faces(tm))
  {
    const auto p = corners(tm, f);
    if(!of_user)
    {
      metrics[f] = GDP::Triangle_metric::embedding(p[0], p[1], p[2]);
      continue;
    }
    const std::vector<double>& row = tensors.at(f);
    Eigen::Matrix3d t;
    t << row[3], row[4], row[5], row[4], row[6], row[7], row[5], row[7], row[8];
    const Eigen::Vector3d t1 = p[1] - p[0], t2 = p[2] - p[0];
    metrics[f] = GDP::Triangle_metric(t1.dot(t * t1), t1.dot(t * t2), t2.dot(t * t2));
  }
}

inline std::vector<Vector> as_vectors(const Table& table)
{
  std::vector<Vector> vectors;
  for(const auto& row : table)
    vectors.emplace_back(row.at(0), row.at(1), row.at(2));
  return vectors;
}

// The largest difference to the answer, relative to the answer's extent.
template <class Values, class Get>
double relative_error(const Values& values, const Table& answer, const Get& get_channel)
{
  if(values.size() != answer.size() || answer.empty())
    return HUGE_VAL;
  double extent = 0, error = 0;
  for(std::size_t channel = 0; channel < answer[0].size(); ++channel)
  {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for(std::size_t i = 0; i < answer.size(); ++i)
    {
      const double expected = answer[i].at(channel),
                   difference = std::abs(get_channel(values[i], int(channel)) - expected);
      low = (std::min)(low, expected);
      high = (std::max)(high, expected);
      error = difference <= error ? error : std::isnan(difference) ? HUGE_VAL : difference;
    }
    extent = (std::max)(extent, high - low);
  }
  return error / extent;
}

inline double relative_error(const std::vector<Vector>& values, const Table& answer)
{
  return relative_error(values, answer, [](const Vector& v, int i) { return v[i]; });
}

inline double relative_error(const std::vector<double>& values, const Table& answer)
{
  return relative_error(values, answer, [](double v, int) { return v; });
}

inline double relative_error(const Mesh& tm, const Table& answer)
{
  std::vector<Vector> values;
  for(Vertex v : vertices(tm))
    values.push_back(tm.point(v) - CGAL::ORIGIN);
  return relative_error(values, answer);
}

// Keeps the worst error of all cases, for the log.
class Error_log
{
  std::map<std::string, std::pair<int, double> > m_worst;

public:
  void check(const Case& c, double error, double tolerance)
  {
    auto& entry = m_worst[c.kind];
    ++entry.first;
    entry.second = (std::max)(entry.second, error);
    if(!GDP_CHECK(error <= tolerance))
      std::cerr << "  " << c.name << ": relative error " << error << std::endl;
  }

  int count(const std::string& kind) const { return m_worst.count(kind) ? m_worst.at(kind).first : 0; }

  void print() const
  {
    for(const auto& entry : m_worst)
      std::cout << entry.first << ": " << entry.second.first << " checks, largest relative error "
                << entry.second.second << std::endl;
  }
};

} // namespace gdp_test

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_REFERENCE_DATA_H
