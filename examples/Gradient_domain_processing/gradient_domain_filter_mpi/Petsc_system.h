// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_PETSC_SYSTEM_H
#define GRADIENT_DOMAIN_FILTER_MPI_PETSC_SYSTEM_H

#include "Ranks.h"

#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>

#include <Eigen/Core>

#include <petscksp.h>

#include <string>
#include <vector>

// A symmetric positive definite system of which every rank has some rows, solved by PETSc's conjugate gradients. The
// environment variable PETSC_OPTIONS can change everything about them.
class Petsc_system
{
  const Ranks& m_ranks;
  Mat m_matrix = nullptr;
  KSP m_solver = nullptr;
  Vec m_right = nullptr, m_solution = nullptr;
  PetscInt m_size = 0; // of this rank
  int m_iterations = 0;

public:
  // The rows are the first `size` columns of the matrix; global_number says which row of the whole system every column
  // is. Throws Failure, as solve().
  Petsc_system(const Ranks& ranks, const CGAL::Gradient_domain_processing::internal::Sparse_matrix& columns, int size,
               const std::vector<Global>& global_number);
  ~Petsc_system();
  Petsc_system(const Petsc_system&) = delete;
  Petsc_system& operator=(const Petsc_system&) = delete;

  // Column by column; the solution takes the place of the right-hand side.
  void solve(Eigen::MatrixXd& values);

  int iterations() const { return m_iterations; } // all in all
  std::string preconditioner() const;

private:
  void choose_preconditioner();
};

#endif // GRADIENT_DOMAIN_FILTER_MPI_PETSC_SYSTEM_H
