// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Everything that runs in parallel, on meshes large enough for it: results are the same to the bit with one thread and
// with several, and a visitor is called by one thread at a time. ThreadSanitizer watches it, see the preset tsan.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>
#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/aggregation.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Lists.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;

namespace {

// Without locks: it relies on being called by one thread at a time.
struct Counting_visitor : GDP::Default_visitor
{
  std::size_t calls = 0, cancel_at;

  explicit Counting_visitor(std::size_t cancel_at = std::size_t(-1)) : cancel_at(cancel_at) {}
  bool go_on(double) { return ++calls < cancel_at; }
};

template <class Operation>
std::vector<Coordinates> result(const Soup& soup, std::size_t threads, const Operation& operation)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#else
  (void)threads;
#endif
  Mesh mesh = built<Mesh>(soup);
  Counting_visitor visitor;
  GDP_CHECK(operation(mesh, visitor) == GDP::OK);
  GDP_CHECK(visitor.calls > 0);
  return coordinates(mesh);
}

template <class Operation>
void check(const Soup& soup, const Operation& operation)
{
  const std::vector<Coordinates> expected = result(soup, 1, operation);
  GDP_CHECK(distance(expected, soup.points) > 1e-5);
  GDP_CHECK(result(soup, 4, operation) == expected);
}

// Enough for several blocks and buckets.
void check_numbers_by_key()
{
  const int number_of_keys = 70001;
  std::vector<int> keys(200000), wanted(keys.size());
  for(std::size_t i = 0; i < keys.size(); ++i)
    keys[i] = int(i * 7919 % 104729) % (number_of_keys - 1); // the last has none
  std::iota(wanted.begin(), wanted.end(), 0);
  std::stable_sort(wanted.begin(), wanted.end(),
                   [&](int i, int j) { return keys[std::size_t(i)] < keys[std::size_t(j)]; });
  for(const std::size_t size : {std::size_t(0), std::size_t(7), keys.size()})
  {
    const auto lists =
      GDP::internal::numbers_by_key(true, number_of_keys, size, [&](std::size_t i) { return keys[i]; });
    GDP_CHECK(lists.size() == number_of_keys && lists.items.size() == size);
    GDP_CHECK(size < keys.size() || lists.items == wanted);
    for(int key = 0; key < number_of_keys; ++key)
      GDP_CHECK(std::all_of(lists.begin(key), lists.end(key), [&](int i) { return keys[std::size_t(i)] == key; }));
  }
}

// Aggregates are begun block by block: everyone with a strong coupling is in one, whichever side of an end of a block
// it is on, and in one with somebody it is coupled to.
void check_aggregates()
{
  const int width = 150, n = width * width;
  const auto is_alone = [&](int i) { return i % 1009 == 0; };
  const auto grid = GDP::internal::build_rows<double>(true, n, n, [&](std::size_t row_index, auto& row) {
    const int i = int(row_index);
    row.add(i, 4.1);
    for(int j : {i - width, i + width, i % width > 0 ? i - 1 : -1, i % width < width - 1 ? i + 1 : -1})
      if(j >= 0 && j < n && !is_alone(i) && !is_alone(j))
        row.add(j, -1);
  });
  std::vector<int> aggregate;
  const int count = GDP::internal::aggregate_unknowns(grid, GDP::internal::strong_couplings(grid, 0.08, true), true,
                                                      aggregate);
  GDP_CHECK(count > n / 8 && count < n / 3);
  std::vector<int> sizes(std::size_t(count), 0);
  for(int i = 0; i < n; ++i)
  {
    GDP_CHECK(is_alone(i) == (aggregate[std::size_t(i)] < 0) && aggregate[std::size_t(i)] < count);
    if(is_alone(i))
      continue;
    ++sizes[std::size_t(aggregate[std::size_t(i)])];
    bool is_connected = false;
    for(int e = grid.offset[std::size_t(i)]; e < grid.offset[std::size_t(i) + 1]; ++e)
    {
      const int j = grid.column[std::size_t(e)];
      is_connected = is_connected || (j != i && aggregate[std::size_t(j)] == aggregate[std::size_t(i)]);
    }
    GDP_CHECK(is_connected || std::abs(i % 16384 - 8192) > 8192 - width - 1); // alone only where a block ends
  }
  GDP_CHECK(*std::min_element(sizes.begin(), sizes.end()) >= 1);
  GDP_CHECK(*std::max_element(sizes.begin(), sizes.end()) <= 16);
}

} // namespace

int main()
{
  check_numbers_by_key();
  check_aggregates();
  const Soup soup = bumpy_patch(150, 115); // vertices and corners for several blocks

  for(const GDP::Curvature_estimator estimator : {GDP::Curvature_estimator::JETS, GDP::Curvature_estimator::NORMALS})
    check(soup, [&](Mesh& mesh, Counting_visitor& visitor) {
      return GDP::smooth(mesh, GDP::parameters::gradient_weight(1e-3)
                                 .curvature_metric_kind(GDP::Curvature_metric_kind::EDGE_AWARE)
                                 .curvature_estimator(estimator)
                                 .curvature_weight(0.01)
                                 .visitor(std::ref(visitor)));
    });
  check(soup, [&](Mesh& mesh, Counting_visitor& visitor) {
    GDP::Conjugate_gradient_solver_traits<> solver;
    return GDP::smooth(mesh,
                       GDP::parameters::gradient_weight(1e-3).sparse_linear_solver(solver).visitor(std::ref(visitor)));
  });
  check(soup, [&](Mesh& mesh, Counting_visitor& visitor) {
    return GDP::denoise(mesh, GDP::parameters::number_of_iterations(1).visitor(std::ref(visitor)));
  });

  // in the middle of the loop over the curvatures: there are calls at the beginnings of stages, then one for every part
  for(const std::size_t cancel_at : {8u, 10u, 12u})
  {
    Mesh mesh = built<Mesh>(soup);
    Counting_visitor visitor(cancel_at);
    GDP_CHECK(GDP::smooth(mesh, GDP::parameters::gradient_weight(1e-3)
                                  .curvature_metric_kind(GDP::Curvature_metric_kind::EDGE_AWARE)
                                  .curvature_estimator(GDP::Curvature_estimator::JETS)
                                  .curvature_weight(0.01)
                                  .visitor(std::ref(visitor)))
              == GDP::ERROR_CANCELLED);
    GDP_CHECK(visitor.calls == cancel_at); // and is not asked again
    GDP_CHECK(coordinates(mesh) == soup.points);
  }
  return GDP_TEST_RESULT();
}
