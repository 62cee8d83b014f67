// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What several have in common who solve: a solver that copies of its traits share, and the threads of the libraries
// beneath it.

#include "minimal_solver.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Borrowed_number.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Sequential_blas_scope.h>

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#ifdef __unix__
#include <dlfcn.h>
#endif

#include <atomic>
#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;
namespace internal = GDP::internal;

typedef Eigen::SparseMatrix<double> Sparse;

namespace {

// A positive definite matrix whose pattern depends on the stride.
Sparse matrix(int n, int stride, double diagonal)
{
  Sparse a(n, n);
  for(int i = 0; i < n; ++i)
  {
    a.insert(i, i) = diagonal + i % 3;
    if(i + stride < n)
      a.insert(i, i + stride) = a.insert(i + stride, i) = -1;
  }
  a.makeCompressed();
  return a;
}

template <class Solver>
Sparse as_read(const Sparse& a)
{
  return Solver::reads_lower_triangle ? Sparse(a.triangularView<Eigen::Lower>()) : a;
}

template <class Solver>
bool solves(Solver& solver, const Sparse& a)
{
  Eigen::MatrixXd right(a.rows(), 2), x;
  for(int i = 0; i < int(a.rows()); ++i)
    right.row(i) << 1 + i, i * i % 7;
  return solver.solve(right, x) == GDP::OK && (a * x - right).norm() <= 1e-8 * right.norm();
}

// Two who were given copies of the same traits. Whoever comes second takes the factor from the first, who notices.
template <class Traits>
void check_sharing(const Traits& traits, bool is_llt = false)
{
  typedef internal::Linear_solver<Traits> Solver;
  static_assert(!std::is_copy_constructible<Solver>::value && std::is_move_constructible<Solver>::value, "");
  const Sparse mine = matrix(60, 1, 3), same_pattern = matrix(60, 1, 4), other_pattern = matrix(60, 7, 3),
               larger = matrix(90, 2, 3);

  Solver a(traits);
  GDP_CHECK(!a.has_factor());
  Eigen::MatrixXd right = Eigen::MatrixXd::Ones(60, 1), x;
  GDP_CHECK(a.solve(right, x) != GDP::OK);
  GDP_CHECK(a.analyze(as_read<Solver>(mine)) == GDP::OK);
  GDP_CHECK(a.factorize(as_read<Solver>(mine)) == GDP::OK);
  GDP_CHECK(a.has_factor() && solves(a, mine));
  for(const Sparse& others : {same_pattern, other_pattern, larger})
  {
    Solver b(traits);
    GDP_CHECK(a.has_factor() && !b.has_factor());
    GDP_CHECK(b.factorize(as_read<Solver>(others)) == GDP::OK); // not analyzed by itself
    GDP_CHECK(b.has_factor() && solves(b, others));
    GDP_CHECK(!a.has_factor() && !solves(a, mine));
    GDP_CHECK(a.factorize(as_read<Solver>(mine)) == GDP::OK);
    GDP_CHECK(a.has_factor() && solves(a, mine) && !b.has_factor() && !solves(b, others));

    GDP_CHECK(b.factorize(as_read<Solver>(others)) == GDP::OK && solves(b, others));
    Solver moved(std::move(b)), assigned(traits);
    GDP_CHECK(moved.has_factor() && solves(moved, others));
    assigned = std::move(moved);
    GDP_CHECK(assigned.has_factor() && solves(assigned, others));
    GDP_CHECK(a.factorize(as_read<Solver>(mine)) == GDP::OK);
  }
  GDP_CHECK(a.has_factor() && solves(a, mine)); // those who are gone take nothing with them

  Sparse indefinite = mine;
  indefinite.coeffRef(0, 0) = -1;
  if(is_llt)
  {
    GDP_CHECK(a.factorize(as_read<Solver>(indefinite)) != GDP::OK);
    GDP_CHECK(!a.has_factor() && !solves(a, mine));
  }
}

// Another's analysis alone is enough to lose analysis and factor.
template <class Traits>
void check_analysis(const Traits& traits)
{
  typedef internal::Linear_solver<Traits> Solver;
  const Sparse mine = matrix(60, 1, 3), others = matrix(60, 7, 3);
  Solver a(traits), b(traits);
  GDP_CHECK(a.factorize(as_read<Solver>(mine)) == GDP::OK);
  GDP_CHECK(b.analyze(as_read<Solver>(others)) == GDP::OK);
  GDP_CHECK(!a.has_factor());
  GDP_CHECK(a.factorize(as_read<Solver>(mine)) == GDP::OK);
  GDP_CHECK(a.has_factor() && solves(a, mine));
  GDP_CHECK(b.factorize(as_read<Solver>(others)) == GDP::OK && solves(b, others));
}

// Solvers of their own do not disturb each other, wherever they lie in memory.
template <class Traits>
void check_independence()
{
  typedef internal::Linear_solver<Traits> Solver;
  const Sparse mine = matrix(60, 1, 3), others = matrix(60, 7, 3);
  Solver a{Traits()};
  GDP_CHECK(a.factorize(as_read<Solver>(mine)) == GDP::OK);
  for(int round = 0; round < 10; ++round)
  {
    Solver b{Traits()};
    GDP_CHECK(!b.has_factor());
    GDP_CHECK(b.factorize(as_read<Solver>(others)) == GDP::OK);
    GDP_CHECK(a.has_factor() && solves(a, mine) && solves(b, others));
  }
}

template <class Traits>
void check_cancelling(const Traits& traits)
{
  internal::Linear_solver<Traits> solver(traits);
  const Sparse a = as_read<internal::Linear_solver<Traits> >(matrix(60, 1, 3));
  const auto never = [] { return false; };
  GDP_CHECK(solver.factorize(a, never) == GDP::ERROR_CANCELLED && !solver.has_factor());
  GDP_CHECK(solver.factorize(a) == GDP::OK);
  Eigen::MatrixXd right = Eigen::MatrixXd::Ones(60, 1), x;
  GDP_CHECK(solver.solve(right, x, never) == GDP::ERROR_CANCELLED);
  GDP_CHECK(solver.has_factor());
  GDP_CHECK(solver.solve(right, x, [] { return true; }) == GDP::OK);
}

std::atomic<int> number_of_process(4);
thread_local int number_of_thread = 4;

int get_of_process() { return number_of_process; }
void set_of_process(int number) { number_of_process = number; }
int get_of_thread() { return number_of_thread; }
void set_of_thread(int number) { number_of_thread = number; }

// Threads that do as they are told, one step at a time.
class Told_thread
{
  std::atomic<int> m_told{0}, m_done{0};
  std::atomic<bool> m_ends{false};
  std::atomic<void (*)(void*)> m_work{nullptr};
  std::atomic<void*> m_data{nullptr};
  std::thread m_thread{[this] {
    for(int step = 1; ; ++step)
    {
      while(m_told < step && !m_ends)
        std::this_thread::sleep_for(std::chrono::microseconds(10));
      if(m_ends)
        return;
      (*m_work.load())(m_data);
      m_done = step;
    }
  }};

public:
  template <class Work>
  void operator()(Work&& work)
  {
    m_data = &work;
    m_work = [](void* data) { (*static_cast<typename std::remove_reference<Work>::type*>(data))(); };
    const int step = ++m_told;
    while(m_done < step)
      std::this_thread::sleep_for(std::chrono::microseconds(10));
  }
  ~Told_thread()
  {
    m_ends = true;
    m_thread.join();
  }
};

// All orders in which three threads come, one of them twice, and go: while one is in, it has the number it wants, and
// in the end all is as it was.
void check_borrowing(int (*get)(), void (*set)(int))
{
  const int failures = number_of_failures();
  Told_thread threads[3];
  for(int order = 0; order < 64 * 64; ++order)
  {
    internal::Borrowed_number number(get, set, 1);
    int inside[3] = {0, 0, 0}, code = order;
    const auto turn = [&](int t) {
      threads[t]([&] {
        if(inside[t] < (t == 0 ? 2 : 1))
          number.enter(), ++inside[t];
        else
          for(; inside[t] > 0; --inside[t])
            number.leave();
      });
      for(int u = 0; u < 3; ++u)
        threads[u]([&] { GDP_CHECK(inside[u] == 0 || get() == 1); });
    };
    for(int step = 0; step < 6; ++step, code /= 4)
      if(code % 4 < 3)
        turn(code % 4);
    for(int t = 0; t < 3; ++t)
      threads[t]([&] {
        for(; inside[t] > 0; --inside[t])
          number.leave();
      });
    for(int t = 0; t < 3; ++t)
      threads[t]([&] { GDP_CHECK(get() == 4); });
    if(number_of_failures() > failures)
    {
      std::cerr << "  in order " << order << std::endl;
      return;
    }
  }
}

int ask(const char* name)
{
#ifdef __unix__
  const auto function = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, name));
  return function ? function() : -1;
#else
  (void)name;
  return -1;
#endif
}

struct Thread_numbers
{
  int openblas = ask("openblas_get_num_threads"), openmp = ask("omp_get_max_threads"),
      levels = ask("omp_get_max_active_levels");
  bool is_sequential() const { return (openblas < 0 || openblas == 1) && (openmp < 0 || openmp == 1) && levels <= 0; }
  bool operator==(const Thread_numbers& other) const
  {
    return openblas == other.openblas && openmp == other.openmp && levels == other.levels;
  }
};

// The true numbers, where there are any.
void check_libraries()
{
#ifdef __unix__
  // more than one, whatever the machine
  if(const auto set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set(2);
#endif
  const Thread_numbers before;
  std::cout << "threads of OpenBLAS " << before.openblas << ", of OpenMP " << before.openmp << ", its levels "
            << before.levels << std::endl;
  Told_thread first, second;
  std::unique_ptr<internal::Sequential_blas_scope> of_first, of_second;
  first([&] { of_first = std::make_unique<internal::Sequential_blas_scope>(); });
  second([&] { of_second = std::make_unique<internal::Sequential_blas_scope>(); });
  first([&] { of_first.reset(); });
  second([&] { GDP_CHECK(Thread_numbers().is_sequential()); });
  second([&] { of_second.reset(); });
  first([&] { GDP_CHECK(Thread_numbers() == before); });
  second([&] { GDP_CHECK(Thread_numbers() == before); });
  GDP_CHECK(Thread_numbers() == before);
}

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
typedef CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Sparse> > Cholmod;

Sparse grid(int n)
{
  Sparse a(n * n, n * n);
  for(int i = 0; i < n * n; ++i)
  {
    a.insert(i, i) = 5;
    if(i % n + 1 < n)
      a.insert(i, i + 1) = a.insert(i + 1, i) = -1;
    if(i + n < n * n)
      a.insert(i, i + n) = a.insert(i + n, i) = -1;
  }
  a.makeCompressed();
  return a;
}

bool was_called = false, was_sequential = false;

void look(int, const char*, int, const char*)
{
  was_called = true;
  was_sequential = Thread_numbers().is_sequential();
}

// CHOLMOD calls us back as it works, to say that a matrix is not positive definite: it is on one thread then.
void check_cholmod_is_sequential()
{
  const Thread_numbers before;
  if(before.is_sequential())
    std::cout << "neither OpenBLAS nor OpenMP here: CHOLMOD's threads are not tested" << std::endl;
  Cholmod traits;
  traits.solver().cholmod().error_handler = look;
  Sparse a = matrix(60, 1, 3);
  a.coeffRef(30, 30) = -1;
  internal::Linear_solver<Cholmod> solver(traits);
  GDP_CHECK(solver.factorize(as_read<internal::Linear_solver<Cholmod> >(a)) != GDP::OK);
  GDP_CHECK(was_called && was_sequential);
  GDP_CHECK(Thread_numbers() == before);
}

bool same_settings(const cholmod_common& a, const cholmod_common& b)
{
  return a.print == b.print && a.nmethods == b.nmethods && a.method[0].ordering == b.method[0].ordering
         && a.postorder == b.postorder && a.nrelax[0] == b.nrelax[0] && a.nrelax[1] == b.nrelax[1]
         && a.nrelax[2] == b.nrelax[2];
}

// Settings are afterwards what they were. What the caller has set holds; what not, suits the graphs at hand.
void check_cholmod_settings()
{
  const auto memory = [](bool merges, std::size_t columns, int ordering) {
    Cholmod traits, untouched;
    for(Cholmod* t : {&traits, &untouched})
    {
      t->solver().cholmod().nrelax[0] = columns;
      if(ordering >= 0)
      {
        t->solver().cholmod().nmethods = 1;
        t->solver().cholmod().method[0].ordering = ordering;
      }
    }
    internal::Linear_solver<Cholmod> solver(traits);
    if(merges)
      solver.merge_small_fronts();
    const Sparse a = grid(40);
    GDP_CHECK(solver.factorize(as_read<internal::Linear_solver<Cholmod> >(a)) == GDP::OK);
    GDP_CHECK(solves(solver, a));
    GDP_CHECK(same_settings(traits.solver().cholmod(), untouched.solver().cholmod()));
    return traits.solver().cholmod().memory_inuse;
  };
  GDP_CHECK(memory(true, 4, -1) > memory(false, 4, -1)); // larger fronts
  GDP_CHECK(memory(true, 5, -1) == memory(false, 5, -1));
  GDP_CHECK(memory(false, 4, CHOLMOD_AMD) != memory(false, 4, -1));
}
#endif

} // namespace

int main()
{
  check_sharing(CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse> >(), true);
  check_sharing(CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Sparse, Eigen::Upper> >());
  check_sharing(CGAL::Eigen_solver_traits<Eigen::ConjugateGradient<Sparse> >());
  check_sharing(GDP::Conjugate_gradient_solver_traits<>());
  check_sharing(Minimal_solver());
  check_analysis(CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse> >());
  check_independence<CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse> > >();
  check_independence<GDP::Conjugate_gradient_solver_traits<> >();
  check_cancelling(CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Sparse> >());
  check_cancelling(GDP::Conjugate_gradient_solver_traits<>());
  check_cancelling(Minimal_solver());
  check_borrowing(get_of_process, set_of_process);
  check_borrowing(get_of_thread, set_of_thread);
  check_libraries();
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  check_sharing(Cholmod(), true);
  check_analysis(Cholmod());
  check_independence<Cholmod>();
  check_cancelling(Cholmod());
  check_cholmod_is_sequential();
  check_cholmod_settings();
#endif
  return GDP_TEST_RESULT();
}
