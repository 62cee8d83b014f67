// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CONSTRAINED_MINIMUM_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CONSTRAINED_MINIMUM_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/constrained_minimum.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Cholesky_factor.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Eigen::SparseMatrix<double> free_block(const Eigen::SparseMatrix<double>& matrix,
                                                       const std::vector<int>& free_index, int count)
{
  Eigen::SparseMatrix<double> block(count, count);
  Eigen::VectorXi sizes = Eigen::VectorXi::Zero(count);
  const auto for_each_entry = [&](int column, const auto& visit) {
    for(int at = matrix.outerIndexPtr()[column]; at < matrix.outerIndexPtr()[column + 1]; ++at)
      if(const int row = free_index[std::size_t(matrix.innerIndexPtr()[at])]; row >= free_index[std::size_t(column)])
        visit(row, matrix.valuePtr()[at]);
  };
  for(int j = 0; j < int(free_index.size()); ++j)
    if(free_index[std::size_t(j)] >= 0)
      for_each_entry(j, [&](int, double) { ++sizes[free_index[std::size_t(j)]]; });
  block.reserve(sizes);
  for(int j = 0; j < int(free_index.size()); ++j)
    if(free_index[std::size_t(j)] >= 0)
      for_each_entry(j, [&](int row, double value) { block.insert(row, free_index[std::size_t(j)]) = value; });
  block.makeCompressed();
  return block;
}

// Factorizes the matrix; if rounding takes its definiteness, as degenerate triangles let it, with a little more on its
// diagonal.
CGAL_GDP_INLINE Error_code factorize_or_shift(Eigen::SparseMatrix<double> matrix, Cholesky_factor& factor)
{
  Error_code code = factor.factorize(matrix);
  for(double shift = 1e-12; code != ok && shift < 1e-5; shift *= 1000)
  {
    for(int j = 0; j < int(matrix.cols()); ++j)
      matrix.coeffRef(j, j) *= 1 + shift;
    code = factor.factorize(matrix);
  }
  return code;
}

CGAL_GDP_INLINE Error_code constrained_minimum(const Eigen::SparseMatrix<double>& matrix,
                                               const std::vector<char>& is_free, Eigen::MatrixXd& x)
{
  std::vector<int> free_index(is_free.size(), -1);
  int count = 0;
  for(std::size_t i = 0; i < is_free.size(); ++i)
    if(is_free[i])
      free_index[i] = count++;
  if(count == 0)
    return ok;

  const Eigen::MatrixXd gradient = matrix * x;
  Eigen::MatrixXd right(count, x.cols());
  for(std::size_t i = 0; i < is_free.size(); ++i)
    if(is_free[i])
      right.row(free_index[i]) = -gradient.row(Eigen::Index(i));
  Cholesky_factor factor;
  if(const Error_code code = factorize_or_shift(free_block(matrix, free_index, count), factor))
    return code;
  const Eigen::MatrixXd change = factor.solve(right);
  if(!change.allFinite())
    return error_cannot_solve_linear_system;
  for(std::size_t i = 0; i < is_free.size(); ++i)
    if(is_free[i])
      x.row(Eigen::Index(i)) += change.row(free_index[i]);
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CONSTRAINED_MINIMUM_IMPL_H
