// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Filters the positions, normals or colors of a mesh file: the package on the command line.

#include "gradient_domain_filter/Failure.h"
#include "gradient_domain_filter/Mesh_file.h"
#include "gradient_domain_filter/Options.h"
#include "gradient_domain_filter/Output_file.h"
#include "gradient_domain_filter/Report.h"
#include "gradient_domain_filter/Stage_clock.h"
#include "gradient_domain_filter/filter_mesh.h"

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace GDP = CGAL::Gradient_domain_processing;

namespace {

bool is_terminal()
{
#if defined(__unix__) || defined(__APPLE__)
  return ::isatty(2) == 1;
#else
  return false;
#endif
}

// The signal as columns, to see how far it moved.
std::vector<std::vector<double> > signal_columns(const Options& options, const Mesh_file& file)
{
  std::vector<std::vector<double> > columns;
  if(options.moves_vertices())
    for(int i = 0; i < 3; ++i)
    {
      columns.emplace_back();
      columns.back().reserve(file.mesh.number_of_vertices());
      for(const Point& p : file.mesh.points())
        columns.back().push_back(p[i]);
    }
  else
    for(const char* name : {"nx", "ny", "nz", "red", "green", "blue", "alpha"})
      if((options.signal == Signal_kind::NORMAL) == (name[0] == 'n') && options.signal != Signal_kind::CURVATURE)
        if(const Column* column = file.vertex_columns.find(name))
          columns.push_back(column->values);
  return columns;
}

void measure_change(const std::vector<std::vector<double> >& before, const std::vector<std::vector<double> >& after, Report& report)
{
  if(before.empty() || before.size() != after.size())
    return;
  const std::size_t n = before[0].size();
  for(std::size_t v = 0; v < n; ++v)
  {
    double change = 0;
    for(std::size_t c = 0; c < before.size(); ++c)
      change = std::hypot(change, after[c][v] - before[c][v]);
    report.max_displacement = (std::max)(report.max_displacement, change);
    report.mean_displacement += change / double(n);
  }
}

void run(const Options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  std::unique_ptr<tbb::global_control> limit;
  if(options.threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
#endif
  Stage_clock clock(!options.is_quiet && is_terminal());
  Output_file output(options.output);
  std::unique_ptr<Output_file> report_file;
  if(!options.report.empty())
    report_file = std::make_unique<Output_file>(options.report);

  Mesh_file file;
  Report report;
  {
    Timed_stage stage(clock, "read");
    file = read_mesh_file(options.input, options.read);
    report.count(file.mesh);
  }
  const bool is_measured = options.is_verbose || report_file;
  const auto before = is_measured ? signal_columns(options, file) : std::vector<std::vector<double> >();
  const GDP::Error_code code = filter_mesh(options, file, clock, report.solver);
  if(code != GDP::OK)
    throw Failure(options.input, (clock.invalid().empty() ? "" : clock.invalid() + ": ") + GDP::get_error_message(code));
  if(is_measured)
    measure_change(before, signal_columns(options, file), report);
  {
    Timed_stage stage(clock, "write");
    output.write(mesh_file_contents(file, options.output_format, options.encoding));
  }
  if(report_file)
    report_file->write(report.json(options, clock));
  output.commit();
  if(report_file)
    report_file->commit();
  clock.clear();
  if(options.is_verbose)
    std::cout << report.summary(options, clock, file.notes) << std::flush;
}

} // namespace

int main(int argc, char* argv[])
{
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 17); // large arrays go back to the system as they are freed: a tenth of the memory
#endif
  Options options;
  try
  {
    if(parse_command_line(argc, argv, options))
      run(options);
    return 0;
  }
  catch(const Usage_error& error)
  {
    std::cerr << "gradient_domain_filter: " << error.what() << std::endl;
    return 2;
  }
  catch(const Failure& failure)
  {
    std::cerr << "gradient_domain_filter: " << failure.what() << std::endl;
  }
  catch(const std::bad_alloc&)
  {
    std::cerr << "gradient_domain_filter: " << options.input << ": out of memory" << std::endl;
  }
  catch(const std::exception& error)
  {
    std::cerr << "gradient_domain_filter: " << options.input << ": " << error.what() << std::endl;
  }
  return 1;
}
