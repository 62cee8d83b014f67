// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Filters a mesh file that is too large for one machine: gradient_domain_filter on many processes.

#include "Ranks.h"
#include "Shared_options.h"
#include "Surface_job.h"

#include <petscsys.h>

#include <sys/resource.h>

#include <cstring>
#include <iostream>
#include <sstream>

namespace {

double peak_gigabytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / (1 << 20);
}

std::string summary(const Ranks& ranks, const Job_report& report)
{
  std::ostringstream text;
  const double largest = ranks.largest(peak_gigabytes()), all = ranks.sum(peak_gigabytes());
  text << report.vertices << " vertices, " << report.faces << " faces, " << ranks.size() << " processes; "
       << report.iterations << " iterations for " << report.systems << " systems, preconditioner "
       << report.preconditioner << "\n";
  for(const Job_report::Stage& stage : report.stages)
    text << stage.name << ": " << stage.seconds << " s, " << stage.sent_bytes << " bytes sent\n";
  text << "memory: " << largest << " GiB at most in a process, " << all << " GiB in all\n";
  return text.str();
}

void run(const Ranks& ranks, const Options& options)
{
  const Job_report report = filter_file(ranks, options);
  const std::string text = summary(ranks, report);
  if(!ranks.is_first() || options.is_quiet)
    return;
  if(report.welded_vertices > 0)
    std::cerr << "gradient_domain_filter_mpi: " << report.welded_vertices
              << " vertices at seams were welded to others" << std::endl;
  if(options.is_verbose)
    std::cout << text << std::flush;
}

// 0 to go on, otherwise what main() returns, plus one.
int parse(const Ranks& ranks, int argc, char* argv[], Options& options)
{
  for(int i = 1; i < argc; ++i)
    if(std::strcmp(argv[i], "--help") == 0)
    {
      if(ranks.is_first())
        std::cout << shared_options_help << std::flush;
      return 1;
    }
  std::string error;
  int is_done = 0;
  if(ranks.is_first()) // which alone may see the files
    try
    {
      is_done = !parse_command_line(argc, argv, options);
      if(!is_done)
        check_shared_options(argc, argv, options);
    }
    catch(const Usage_error& e)
    {
      error = e.what();
    }
  if(!error.empty())
    std::cerr << "gradient_domain_filter_mpi: " << error << std::endl;
  int code = error.empty() ? is_done : 3;
  MPI_Bcast(&code, 1, MPI_INT, 0, ranks.comm());
  if(code == 0 && !ranks.is_first())
    parse_command_line(argc, argv, options);
  return code;
}

int filter(int argc, char* argv[])
{
  const Ranks ranks(PETSC_COMM_WORLD);
  Options options;
  if(const int code = parse(ranks, argc, argv, options))
    return code - 1;
  try
  {
    run(ranks, options);
    return 0;
  }
  catch(const Failure& failure) // the same on all ranks
  {
    if(ranks.is_first())
      std::cerr << "gradient_domain_filter_mpi: " << failure.what() << std::endl;
    return 1;
  }
  catch(const std::exception& error) // on this one only: the others may wait for it
  {
    std::cerr << "gradient_domain_filter_mpi: rank " << ranks.rank() << ": " << error.what() << std::endl;
    MPI_Abort(PETSC_COMM_WORLD, 1);
    return 1;
  }
}

} // namespace

int main(int argc, char* argv[])
{
  if(PetscInitializeNoArguments() != 0)
    return 1;
  PetscPopSignalHandler();
  PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
  const int code = filter(argc, argv);
  PetscFinalize();
  return code;
}
