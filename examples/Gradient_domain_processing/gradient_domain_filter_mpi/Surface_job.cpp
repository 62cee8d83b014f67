// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface_job.h"

#include "Follow_normals.h"
#include "Mesh_piece.h"
#include "Piece_filter.h"
#include "Shared_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace {

typedef Piece_filter::Signal Signal;

const std::vector<std::string> normal_names = {"nx", "ny", "nz"};

// Which properties of the file are read, and where they have come.
class Columns_of_file
{
  std::vector<std::string> m_names;

public:
  Partition* partition = nullptr;

  const std::vector<std::string>& names() const { return m_names; }
  void add(const std::string& name)
  {
    if(!name.empty() && std::find(m_names.begin(), m_names.end(), name) == m_names.end())
      m_names.push_back(name);
  }
  const std::vector<double>& of(const std::string& name) const
  {
    return partition->columns[std::size_t(std::find(m_names.begin(), m_names.end(), name) - m_names.begin())];
  }
};

class Job
{
  const Ranks& m_ranks;
  const Options& m_options;
  Job_report m_report;
  double m_stage_begin;
  std::int64_t m_bytes_before = 0;
  Columns_of_file m_columns;
  std::vector<std::string> m_signal; // its properties; none: the positions

public:
  Job(const Ranks& ranks, const Options& options) : m_ranks(ranks), m_options(options), m_stage_begin(MPI_Wtime()) {}

  Job_report run()
  {
    Shared_output output(m_ranks, m_options.output);
    const Ply_slices file(m_ranks, m_options.input);
    choose_columns(file);
    Partition partition = read_partition(m_ranks, file, m_columns.names());
    m_columns.partition = &partition;
    m_report.vertices = file.vertices().count;
    m_report.faces = file.faces().count;
    end_stage("read");

    const bool has_jets =
      m_options.has_metric() && m_options.curvature == CGAL::Gradient_domain_processing::Curvature_estimator::JETS;
    Mesh_piece piece = make_piece(m_ranks, partition, bool(m_options.weld_tolerance), has_jets ? jet_layers() : 1);
    m_report.welded_vertices = piece.number_of_welded_rows;
    end_stage("exchange");
    const New_values values = filtered(file, partition, piece);
    end_stage("filter");
    output.write(file, values);
    end_stage("write");
    return std::move(m_report);
  }

private:
  // As many rings as a neighborhood of jets may have (see Jet_curvature_estimator), and one for the triangles.
  int jet_layers() const { return (m_options.jet_degree <= 3 ? 2 : 3) + 4 + 1; }

  void end_stage(const char* name)
  {
    const double now = MPI_Wtime();
    m_report.stages.push_back({name, m_ranks.largest(now - m_stage_begin),
                               m_ranks.sum(m_ranks.sent_bytes() - m_bytes_before)});
    m_stage_begin = MPI_Wtime();
    m_bytes_before = m_ranks.sent_bytes();
  }

  void choose_columns(const Ply_slices& file)
  {
    const Options& o = m_options;
    if(o.signal == Signal_kind::NORMAL)
      m_signal = normal_names;
    else if(o.signal == Signal_kind::PROPERTY)
      m_signal = o.signal_properties;
    else if(o.signal == Signal_kind::COLOR)
    {
      m_signal = {"red", "green", "blue"};
      if(file.has_property("alpha"))
        m_signal.push_back("alpha");
    }
    for(const std::string& name : m_signal)
      m_columns.add(name);
    for(const std::string* name : {&o.constrained_property, &o.value_weight_property, &o.gradient_weight_property,
                                   &o.gradient_scale_property})
      m_columns.add(*name);
    if(has_normals(file) && (follows_normals(file) || o.has_metric()))
      for(const std::string& name : normal_names)
        m_columns.add(name);
    for(const std::string& name : m_columns.names())
      file.place(name); // which throws if there is none
  }

  static bool has_normals(const Ply_slices& file)
  {
    return std::all_of(normal_names.begin(), normal_names.end(),
                       [&](const std::string& name) { return file.has_property(name); });
  }
  bool follows_normals(const Ply_slices& file) const
  {
    return m_signal.empty() && !m_options.keeps_normals && has_normals(file);
  }

  // By local row; every number is finite.
  std::vector<double> by_row(const std::string& name, const Mesh_piece& piece) const
  {
    std::vector<double> values;
    m_ranks.together([&] {
      if(name.empty())
        return;
      values = m_columns.of(name);
      for(std::size_t row = 0; row < values.size(); ++row)
        if(!std::isfinite(values[row]))
          throw Failure(m_options.input, "the property '" + name + "' of vertex "
                          + std::to_string(m_columns.partition->file_vertices[row]) + " is NaN or infinite");
      values.resize(std::size_t(piece.rows.size()));
    });
    if(!name.empty())
      piece.rows.update(values);
    return values;
  }

  Signal signal_by_row(const std::vector<std::string>& names, const Mesh_piece& piece) const
  {
    Signal signal(piece.rows.size(), Eigen::Index(names.size()));
    for(std::size_t channel = 0; channel < names.size(); ++channel)
    {
      const std::vector<double> values = by_row(names[channel], piece);
      for(std::size_t row = 0; row < values.size(); ++row)
        signal(Eigen::Index(row), Eigen::Index(channel)) = values[row];
    }
    return signal;
  }

  Piece_filter::Given given(const Ply_slices& file, const Mesh_piece& piece) const
  {
    const Options& o = m_options;
    Piece_filter::Given given;
    given.is_constrained = by_row(o.constrained_property, piece);
    given.value_weights = by_row(o.value_weight_property, piece);
    given.gradient_weights = by_row(o.gradient_weight_property, piece);
    given.gradient_scales = by_row(o.gradient_scale_property, piece);
    check_weights(o.value_weight_property, given.value_weights, true);
    check_weights(o.gradient_weight_property, given.gradient_weights, false);
    if(o.has_metric() && has_normals(file))
      given.normals = signal_by_row(normal_names, piece);
    return given;
  }

  void check_weights(const std::string& name, const std::vector<double>& weights, bool is_positive) const
  {
    m_ranks.together([&] {
      for(double weight : weights)
        if(weight < 0 || (is_positive && weight == 0))
          throw Failure(m_options.input, "the property '" + name + "' holds weights that are not positive"
                          + (is_positive ? ", as here all must be" : " or zero"));
    });
  }

  New_values filtered(const Ply_slices& file, const Partition& partition, Mesh_piece& piece)
  {
    const Piece_filter::Given of_file = given(file, piece);
    Piece_filter filter(m_ranks, m_options, piece, of_file);
    New_values values = m_signal.empty() ? moved(file, partition, piece, filter)
                                         : changed(file, partition, piece, filter);
    m_report.iterations = filter.iterations;
    m_report.systems = filter.systems;
    m_report.preconditioner = filter.preconditioner;
    return values;
  }

  New_values moved(const Ply_slices& file, const Partition& partition, Mesh_piece& piece, Piece_filter& filter) const
  {
    const std::vector<Piece_filter::Vec3> before = piece.mesh.points;
    filter.filter_positions();
    New_values values{{"x", "y", "z"}, {}, std::vector<std::vector<double> >(3)};
    std::vector<int> rows;
    for(int row = 0; row < piece.rows.owned(); ++row)
    {
      const int v = piece.vertex_of_row[std::size_t(row)];
      if(v >= 0 && piece.mesh.points[std::size_t(v)] != before[std::size_t(v)])
        rows.push_back(row);
    }
    if(follows_normals(file))
    {
      // those of vertices that stay follow their faces, too
      rows.clear();
      for(int row = 0; row < piece.rows.owned(); ++row)
        if(piece.vertex_of_row[std::size_t(row)] >= 0)
          rows.push_back(row);
      values.properties.insert(values.properties.end(), normal_names.begin(), normal_names.end());
      values.columns.resize(6);
    }
    for(int row : rows)
    {
      const int v = piece.vertex_of_row[std::size_t(row)];
      values.file_vertices.push_back(partition.file_vertices[std::size_t(row)]);
      const bool is_moved = piece.mesh.points[std::size_t(v)] != before[std::size_t(v)];
      for(int i = 0; i < 3; ++i)
        values.columns[std::size_t(i)].push_back(is_moved ? piece.unit() * piece.mesh.points[std::size_t(v)][i]
                                                          : partition.points[std::size_t(row)][i]);
    }
    if(follows_normals(file))
    {
      const Signal normals =
        followed_normals(m_ranks, piece, before, partition.points, signal_by_row(normal_names, piece));
      for(int row : rows)
        for(int i = 0; i < 3; ++i)
          values.columns[std::size_t(3 + i)].push_back(normals(row, i));
    }
    return values;
  }

  New_values changed(const Ply_slices& file, const Partition& partition, Mesh_piece& piece, Piece_filter& filter) const
  {
    Signal signal = signal_by_row(m_signal, piece);
    const Eigen::RowVectorXd most = full_colors(file, signal);
    filter.filter_signal(signal);
    New_values values{m_signal, {}, std::vector<std::vector<double> >(m_signal.size())};
    for(int row = 0; row < piece.rows.owned(); ++row)
    {
      if(piece.vertex_of_row[std::size_t(row)] < 0)
        continue;
      values.file_vertices.push_back(partition.file_vertices[std::size_t(row)]);
      for(Eigen::Index i = 0; i < signal.cols(); ++i)
      {
        const double x = signal(row, i);
        values.columns[std::size_t(i)].push_back(
          m_options.signal == Signal_kind::COLOR ? (std::min)((std::max)(x, 0.), most[i]) : x);
      }
    }
    return values;
  }

  // What white is in the file: by the type of its numbers, or by the largest.
  Eigen::RowVectorXd full_colors(const Ply_slices& file, const Signal& signal) const
  {
    double largest = signal.rows() > 0 ? signal.maxCoeff() : 0;
    largest = m_ranks.largest(largest);
    double white = largest <= 1 ? 1. : 255.;
    if(m_options.signal == Signal_kind::COLOR)
      for(const std::string& name : m_signal)
        if(is_integer(file.place(name).type))
        {
          white = file.place(name).type == Number_type::UINT16 ? 65535. : 255.;
          break;
        }
    return Eigen::RowVectorXd::Constant(signal.cols(), white);
  }
};

} // namespace

Job_report filter_file(const Ranks& ranks, const Options& options) { return Job(ranks, options).run(); }
