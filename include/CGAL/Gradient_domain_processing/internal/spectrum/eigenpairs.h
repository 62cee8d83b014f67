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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_EIGENPAIRS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_EIGENPAIRS_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Block_lanczos.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectrum_slice.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The eigenpairs of A x = lambda B x nearest to a shift, with symmetric A, bounded from below, and positive definite B,
// slice by slice after Vallet and Levy 2008: those around a shift, then shifts farther away on both sides, two at a
// time on two threads. How many eigenvalues are between two shifts is known from their factors; what the two slices
// find has to add up to it, and to agree where both know an eigenvalue: none of a multiple one is missed.
class Nearest_eigenpairs
{
  static constexpr int slice_size = 60; // eigenvalues from shift to shift

  struct Slice
  {
    Spectrum_slice spectrum;
    int from_left = -1, from_right = -1; // what is taken of it; -1: not known yet
    std::vector<double> values;
    Eigen::MatrixXd vectors;

    Slice(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) : spectrum(a, b) {}
  };
  typedef std::unique_ptr<Slice> Slice_handle;

  const Eigen::SparseMatrix<double>& m_a;
  const Eigen::SparseMatrix<double>& m_b;
  const int m_size;
  const bool m_parallel;
  const double m_spacing;
  double m_sigma = 0;
  std::vector<Slice_handle> m_slices; // by shift

public:
  // The spacing is about what is between two eigenvalues; 0: not known.
  Nearest_eigenpairs(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b, bool parallel,
                     double spacing = 0)
    : m_a(a)
    , m_b(b)
    , m_size(int(a.rows()))
    , m_parallel(parallel)
    , m_spacing(spacing > 0 ? spacing : mean_spacing())
  {
  }

  // The lowest are those nearest to a shift below all.
  Error_code find_lowest(int count, Eigenpairs& result)
  {
    for(double sigma = -5 * m_spacing;; sigma *= 4)
    {
      if(const Error_code code = begin_at(sigma))
        return code;
      if(m_slices[0]->spectrum.below() == 0)
        return find(count, result);
      if(!std::isfinite(4 * sigma))
        return error_cannot_solve_linear_system;
    }
  }

  Error_code find_nearest(double sigma, int count, Eigenpairs& result)
  {
    if(const Error_code code = begin_at(sigma))
      return code;
    return find(count, result);
  }

private:
  Error_code begin_at(double sigma)
  {
    m_slices.clear();
    m_slices.push_back(std::make_unique<Slice>(m_a, m_b));
    const Error_code code = m_slices[0]->spectrum.factorize_near(sigma, m_spacing);
    m_sigma = m_slices[0]->spectrum.sigma();
    return code;
  }

  Error_code find(int count, Eigenpairs& result)
  {
    count = (std::min)(count, m_size);
    Spectrum_slice& first = m_slices[0]->spectrum;
    const int most = (std::min)(count + 2, slice_size);
    first.find(first.above() > 0 ? most / 2 + 1 : most, first.below() > 0 ? most / 2 + 1 : most);
    if(first.is_far())
      return find_around(first.lowest(), 2 * first.spread() / first.size(), count, result);
    while(number_within_reach() < count)
      if(const Error_code code = extend(count))
        return code;
    collect(count, result);
    return ok;
  }

  // What is narrow far away from zero is wide around it: the lowest of A - mu B, where mu is among them.
  Error_code find_around(double mu, double spacing, int count, Eigenpairs& result)
  {
    m_slices.clear();
    const Eigen::SparseMatrix<double> moved = m_a - mu * m_b;
    const Error_code code = Nearest_eigenpairs(moved, m_b, m_parallel, spacing).find_lowest(count, result);
    result.values.array() += mu;
    return code;
  }

  bool has_bottom() const { return m_slices.front()->spectrum.below() == 0; }
  bool has_top() const { return m_slices.back()->spectrum.above() == 0; }

  // How far from the shift all eigenvalues are known, on either side.
  double reach() const
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return (std::min)(has_bottom() ? infinity : m_sigma - m_slices.front()->spectrum.sigma(),
                      has_top() ? infinity : m_slices.back()->spectrum.sigma() - m_sigma);
  }

  int number_within_reach() const
  {
    const double most = reach();
    int count = 0;
    for(const double value : values())
      if(std::abs(value - m_sigma) <= most)
        ++count;
    return count;
  }

  // Of all slices, increasing.
  std::vector<double> values() const
  {
    std::vector<double> all;
    for(const Slice_handle& slice : m_slices)
      if(!slice->values.empty())
        all.insert(all.end(), slice->values.begin(), slice->values.end());
      else
      {
        for(int i = slice->from_left; i > 0; --i)
          all.push_back(slice->spectrum.on_left(i));
        for(int i = 1; i <= slice->from_right; ++i)
          all.push_back(slice->spectrum.on_right(i));
      }
    return all;
  }

  // Two slices more: one on both sides, where there is more on both.
  Error_code extend(int count)
  {
    const int missing = count - number_within_reach();
    std::vector<double> left, right;
    if(!has_bottom())
      left = next_shifts(m_slices.front()->spectrum, -1, missing, has_top() ? 2 : 1);
    if(!has_top())
      right = next_shifts(m_slices.back()->spectrum, 1, missing, has_bottom() ? 2 : 1);
    std::vector<double> shifts(left.rbegin(), left.rend());
    shifts.insert(shifts.end(), right.begin(), right.end());
    std::vector<Slice_handle> added;
    if(const Error_code code = factorize(shifts, added))
      return code;
    const int outer = (std::min)(missing, slice_size / 2); // to know how dense they are
    std::vector<Slice*> fresh;
    for(Slice_handle& slice : added)
    {
      fresh.push_back(slice.get());
      const auto at = std::upper_bound(
        m_slices.begin(), m_slices.end(), slice->spectrum.sigma(),
        [](double sigma, const Slice_handle& other) { return sigma < other->spectrum.sigma(); });
      m_slices.insert(at, std::move(slice));
    }
    if(const Error_code code = fill_gaps(fresh))
      return code;
    std::vector<std::pair<int, int> > wanted; // before any of them finds something
    for(const Slice* slice : fresh)
      wanted.push_back(wanted_at(*slice, outer));
    for_each(fresh, [&](Slice& slice) {
      const auto& of_slice = wanted[std::size_t(std::find(fresh.begin(), fresh.end(), &slice) - fresh.begin())];
      slice.spectrum.find(of_slice.first, of_slice.second);
    });
    return join();
  }

  template <class Body>
  void for_each(const std::vector<Slice*>& slices, const Body& body) const
  {
    const Ldlt::Thread_scope scope{}; // not on every thread
    (void)scope;
    for_each_block(m_parallel, slices.size(), 1, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        body(*slices[i]);
    });
  }

  Error_code factorize(const std::vector<double>& shifts, std::vector<Slice_handle>& slices) const
  {
    std::vector<Slice*> list;
    for(std::size_t i = 0; i < shifts.size(); ++i)
    {
      slices.push_back(std::make_unique<Slice>(m_a, m_b));
      list.push_back(slices.back().get());
    }
    std::vector<Error_code> codes(shifts.size(), ok);
    for_each(list, [&](Slice& slice) {
      const std::size_t i = std::size_t(std::find(list.begin(), list.end(), &slice) - list.begin());
      codes[i] = slice.spectrum.factorize_near(shifts[i], m_spacing);
    });
    for(const Error_code code : codes)
      if(code != ok)
        return code;
    return ok;
  }

  // Where the density was estimated badly, one more in the middle.
  Error_code fill_gaps(std::vector<Slice*>& fresh)
  {
    for(std::size_t i = 0; i + 1 < m_slices.size(); ++i)
      while(m_slices[i]->from_right < 0 && number_between(i) > 2 * slice_size && is_wide(i))
        if(const Error_code code = insert_after(i, fresh))
          return code;
    return ok;
  }

  int number_between(std::size_t i) const
  {
    return m_slices[i + 1]->spectrum.below() - m_slices[i]->spectrum.below();
  }

  bool is_wide(std::size_t i) const
  {
    const double a = m_slices[i]->spectrum.sigma(), b = m_slices[i + 1]->spectrum.sigma();
    return b - a > 1e-4 * ((std::max)(std::abs(a), std::abs(b)) + m_spacing);
  }

  Error_code insert_after(std::size_t i, std::vector<Slice*>& fresh)
  {
    const double a = m_slices[i]->spectrum.sigma(), b = m_slices[i + 1]->spectrum.sigma();
    std::vector<Slice_handle> added;
    if(const Error_code code = factorize({a + 0.4871 * (b - a)}, added))
      return code;
    fresh.push_back(added[0].get());
    m_slices.insert(m_slices.begin() + std::ptrdiff_t(i) + 1, std::move(added[0]));
    return ok;
  }

  // How many a new slice has to find on its left and right: half of what is between it and another new one, the rest
  // where the other is known already, and some that both know.
  std::pair<int, int> wanted_at(const Slice& slice, int outer) const
  {
    std::size_t i = 0;
    while(m_slices[i].get() != &slice)
      ++i;
    std::pair<int, int> wanted(i == 0 ? outer : 0, i + 1 == m_slices.size() ? outer : 0);
    const auto share = [&](int between, int known) {
      const int rest = known > 0 ? between - known : between / 2;
      return (std::min)(between + 1, (std::max)(rest, 0) + 3);
    };
    if(i > 0)
      wanted.first = share(number_between(i - 1), m_slices[i - 1]->spectrum.number_on_right());
    if(i + 1 < m_slices.size())
      wanted.second = share(number_between(i), m_slices[i + 1]->spectrum.number_on_left());
    return wanted;
  }

  // Decides what is taken from which slice.
  Error_code join()
  {
    for(std::size_t i = 0; i + 1 < m_slices.size();)
    {
      if(m_slices[i]->from_right >= 0)
      {
        ++i;
        continue;
      }
      Spectrum_slice &left = m_slices[i]->spectrum, &right = m_slices[i + 1]->spectrum;
      const int number = number_between(i), split = split_between(left, right);
      const int size_before = left.size() + right.size();
      if(split >= 0)
      {
        m_slices[i]->from_right = split;
        m_slices[i + 1]->from_left = number - split;
        ++i;
      }
      else if(number < 0)
        return error_not_converged;
      else
      {
        for_each({m_slices[i].get(), m_slices[i + 1].get()}, [&](Slice& slice) {
          const bool is_left = &slice == m_slices[i].get();
          const int known_left = slice.spectrum.number_on_left(), known_right = slice.spectrum.number_on_right();
          slice.spectrum.find(is_left ? known_left : known_left + (std::max)(8, known_left / 4),
                              is_left ? known_right + (std::max)(8, known_right / 4) : known_right);
        });
        if(left.size() + right.size() > size_before)
          continue;
        std::vector<Slice*> fresh;
        if(!is_wide(i))
          return error_not_converged;
        if(const Error_code code = insert_after(i, fresh))
          return code;
        const std::pair<int, int> wanted = wanted_at(*fresh[0], 0);
        fresh[0]->spectrum.find(wanted.first, wanted.second);
      }
    }
    take_what_is_done();
    return ok;
  }

  // How many of those between two shifts are taken from the left one: up to the widest gap where both agree. -1: cannot
  // be said yet.
  int split_between(const Spectrum_slice& left, const Spectrum_slice& right) const
  {
    const int number = right.below() - left.below();
    const int known_left = left.number_on_right(), known_right = right.number_on_left();
    const double width = right.sigma() - left.sigma();
    // the k-th between the two, as either knows it
    const auto of_left = [&](int k) { return k <= known_left ? left.on_right(k) : HUGE_VAL; };
    const auto of_right = [&](int k) {
      const int from_right = number - k + 1;
      return from_right <= known_right ? right.on_left(from_right) : -HUGE_VAL;
    };
    if(number == 0)
      return 0;
    int best = -1;
    double widest = 1e-7 * ((std::max)(std::abs(left.sigma()), std::abs(right.sigma())) + m_spacing);
    for(int k = (std::max)(0, number - known_right); k <= (std::min)(number, known_left); ++k)
    {
      const double low = k > 0 ? of_left(k) : left.sigma(), high = k < number ? of_right(k + 1) : right.sigma();
      bool agrees = (k == number && (known_left > number ? of_left(number + 1) > right.sigma()
                                                         : known_left == left.above()))
                 || (k == 0 && (known_right > number ? of_right(0) < left.sigma() : known_right == right.below()));
      bool differs = false;
      for(int other : {k, k + 1})
        if(other >= 1 && other <= number && std::isfinite(of_left(other)) && std::isfinite(of_right(other)))
        {
          const bool is_same = std::abs(of_left(other) - of_right(other)) <= 1e-6 * width;
          agrees = agrees || is_same;
          differs = differs || !is_same;
        }
      if(agrees && !differs && low > left.sigma() - 1e-9 * width && high - low > widest)
      {
        widest = high - low;
        best = k;
      }
    }
    return best;
  }

  // Factors and bases of inner slices are no longer needed.
  void take_what_is_done()
  {
    std::vector<Slice*> done;
    for(const Slice_handle& slice : m_slices)
    {
      if(&slice == &m_slices.front() && has_bottom())
        slice->from_left = 0;
      if(&slice == &m_slices.back() && has_top())
        slice->from_right = 0;
      if(slice->from_left >= 0 && slice->from_right >= 0 && slice->vectors.size() == 0)
        done.push_back(slice.get());
    }
    for_each(done, [](Slice& slice) {
      slice.spectrum.take(slice.from_left, slice.from_right, slice.values, slice.vectors);
      slice.spectrum.release();
    });
  }

  // The outer slices give what they have inside of their shifts.
  void collect(int count, Eigenpairs& result)
  {
    for(const Slice_handle& slice : m_slices)
    {
      slice->from_left = (std::max)(0, slice->from_left);
      slice->from_right = (std::max)(0, slice->from_right);
    }
    take_what_is_done();
    std::vector<double> all = values();
    std::size_t first = 0;
    while(first + std::size_t(count) < all.size()
          && all[first + std::size_t(count)] - m_sigma < m_sigma - all[first])
      ++first;
    result.values = Eigen::Map<const Eigen::VectorXd>(all.data() + first, count);
    result.vectors.resize(m_size, count);
    int at = -int(first), begin_of_last = 0;
    for(const Slice_handle& slice : m_slices)
    {
      const int size = int(slice->vectors.cols());
      const int begin = (std::max)(0, at), end = (std::min)(count, at + size);
      if(begin < end)
      {
        result.vectors.middleCols(begin, end - begin) = slice->vectors.middleCols(begin - at, end - begin);
        make_orthogonal(begin_of_last, begin, end, result.vectors);
        begin_of_last = begin;
      }
      slice->vectors.resize(0, 0);
      at += size;
    }
  }

  // Those of two slices are orthogonal up to their residuals only.
  void make_orthogonal(int first, int begin, int end, Eigen::MatrixXd& vectors) const
  {
    Eigen::MatrixXd own = vectors.middleCols(begin, end - begin);
    const auto others = vectors.middleCols(first, begin - first);
    if(begin > first)
      own -= others * (others.transpose() * (m_b * own));
    const Eigen::MatrixXd image = m_b * own;
    for(Eigen::Index j = 0; j < own.cols(); ++j)
      own.col(j) /= std::sqrt(own.col(j).dot(image.col(j)));
    vectors.middleCols(begin, end - begin) = own;
  }

  // Where the next slices go, away from one on the given side: into the widest gap above what is missing, to see
  // whether there is any more; or half a slice beyond what is known, and a slice from there.
  std::vector<double> next_shifts(const Spectrum_slice& slice, int side, int missing, int number) const
  {
    std::vector<double> known(1, 0.); // distances
    for(int i = 1; i <= (side > 0 ? slice.number_on_right() : slice.number_on_left()); ++i)
      known.push_back(side * ((side > 0 ? slice.on_right(i) : slice.on_left(i)) - slice.sigma()));
    const int size = int(known.size()) - 1;
    if(size == (side > 0 ? slice.above() : slice.below()))
      return {slice.sigma() + side * (known.back() + (std::max)(1e-6 * std::abs(slice.sigma()), m_spacing))};
    if(size > missing)
    {
      const auto gap = [&](int i) { return known[std::size_t(i)] - known[std::size_t(i) - 1]; };
      int widest = missing + 1;
      for(int i = widest; i <= size; ++i)
        if(gap(i) > gap(widest))
          widest = i;
      if(gap(widest) > 1e-6 * (std::abs(slice.sigma()) + known.back()))
        return {slice.sigma() + side * (known[std::size_t(widest)] + known[std::size_t(widest) - 1]) / 2};
    }
    const int back = (std::min)(slice_size / 2, size);
    const double span = back > 0 ? known.back() - known[std::size_t(size - back)] : 0;
    // no simple number: not onto an eigenvalue of a regular mesh
    const double step = 0.9371 * (span > 0 ? span / back : m_spacing);
    const int near_by = (std::max)(2, (std::min)(missing - size + 2, slice_size / 2));
    std::vector<double> shifts(1, slice.sigma() + side * (known.back() + near_by * step));
    const int rest = (std::min)(missing - size - near_by + 2, slice_size);
    if(number > 1 && rest > 2)
      shifts.push_back(shifts[0] + side * rest * step);
    return shifts;
  }

  // Roughly, by Weyl's law: the mean of all eigenvalues, over their number.
  double mean_spacing() const
  {
    double a = 0, b = 0;
    for(int i = 0; i < int(m_a.rows()); ++i)
    {
      a += std::abs(m_a.coeff(i, i));
      b += m_b.coeff(i, i);
    }
    return a > 0 && b > 0 ? a / b / double(m_a.rows()) : 1;
  }
};

inline Error_code lowest_eigenpairs(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b,
                                    int count, Eigenpairs& result, bool parallel = true)
{
  result.values.resize(0);
  result.vectors.resize(a.rows(), 0);
  return count > 0 && a.rows() > 0 ? Nearest_eigenpairs(a, b, parallel).find_lowest(count, result) : ok;
}

// Around zero, whatever the shift: what is near is told apart by how near it is.
inline Error_code nearest_eigenpairs(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b,
                                     double shift, int count, Eigenpairs& result, bool parallel = true)
{
  result.values.resize(0);
  result.vectors.resize(a.rows(), 0);
  if(count <= 0 || a.rows() == 0)
    return ok;
  const Eigen::SparseMatrix<double> moved = a - shift * b;
  const Error_code code = Nearest_eigenpairs(moved, b, parallel).find_nearest(0, count, result);
  result.values.array() += shift;
  return code;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_EIGENPAIRS_H
