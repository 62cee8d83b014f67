// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_MINIMAL_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_MINIMAL_SOLVER_H

#include <cmath>
#include <utility>
#include <vector>

namespace gdp_test {

// A model of SparseLinearAlgebraWithFactorTraits_d that has what the concept asks for and nothing more: a dense matrix,
// inverted by Gauss-Jordan elimination. Answers come as (1/D) X with a D that is not one, as the concept allows.
class Minimal_solver
{
public:
  typedef double NT;

  class Vector
  {
    std::vector<double> m_values;

  public:
    typedef double NT;
    explicit Vector(int rows) : m_values(rows, 0.) {}
    int dimension() const { return int(m_values.size()); }
    double operator[](int row) const { return m_values[row]; }
    double& operator[](int row) { return m_values[row]; }
  };

  class Matrix
  {
    int m_rows, m_columns;
    std::vector<double> m_values;

    Matrix(const Matrix&) = delete;
    Matrix& operator=(const Matrix&) = delete;

  public:
    typedef double NT;
    explicit Matrix(int dimension) : Matrix(dimension, dimension) {}
    Matrix(int rows, int columns) : m_rows(rows), m_columns(columns), m_values(std::size_t(rows) * columns, 0.) {}
    int row_dimension() const { return m_rows; }
    int column_dimension() const { return m_columns; }
    double get_coef(int row, int column) const { return m_values[std::size_t(row) * m_columns + column]; }
    void add_coef(int row, int column, double value) { m_values[std::size_t(row) * m_columns + column] += value; }
    void set_coef(int row, int column, double value, bool = false)
    {
      m_values[std::size_t(row) * m_columns + column] = value;
    }
  };

private:
  const Matrix* m_matrix = nullptr; // as Eigen_solver_traits: it must outlive the solutions
  std::vector<double> m_inverse;

public:
  Minimal_solver() {}

  bool factor(const Matrix& a, double& d)
  {
    const int n = a.row_dimension();
    d = denominator();
    m_matrix = &a;
    std::vector<double> left(std::size_t(n) * n);
    m_inverse.assign(std::size_t(n) * n, 0.);
    for(int i = 0; i < n; ++i)
    {
      m_inverse[i * n + i] = 1;
      for(int j = 0; j < n; ++j)
        left[i * n + j] = a.get_coef(i, j);
    }
    for(int k = 0; k < n; ++k)
    {
      int pivot = k;
      for(int i = k + 1; i < n; ++i)
        if(std::abs(left[i * n + k]) > std::abs(left[pivot * n + k]))
          pivot = i;
      if(left[pivot * n + k] == 0)
        return false;
      for(int j = 0; j < n; ++j)
      {
        std::swap(left[k * n + j], left[pivot * n + j]);
        std::swap(m_inverse[k * n + j], m_inverse[pivot * n + j]);
      }
      const double factor = 1 / left[k * n + k];
      for(int j = 0; j < n; ++j)
      {
        left[k * n + j] *= factor;
        m_inverse[k * n + j] *= factor;
      }
      for(int i = 0; i < n; ++i)
        if(i != k && left[i * n + k] != 0)
        {
          const double f = left[i * n + k];
          for(int j = 0; j < n; ++j)
          {
            left[i * n + j] -= f * left[k * n + j];
            m_inverse[i * n + j] -= f * m_inverse[k * n + j];
          }
        }
    }
    return true;
  }

  bool linear_solver(const Vector& b, Vector& x)
  {
    const int n = m_matrix->row_dimension();
    if(b.dimension() != n || x.dimension() != n)
      return false;
    for(int i = 0; i < n; ++i)
    {
      x[i] = 0;
      for(int j = 0; j < n; ++j)
        x[i] += denominator() * m_inverse[i * n + j] * b[j];
    }
    return true;
  }

  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, double& d)
  {
    return factor(a, d) && linear_solver(b, x);
  }

  static double denominator() { return 4; }
};

} // namespace gdp_test

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_MINIMAL_SOLVER_H
