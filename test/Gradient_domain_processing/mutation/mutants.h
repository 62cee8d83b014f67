// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_MUTANTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_MUTANTS_H

#include <cmath>
#include <type_traits>
#include <utility>

// What mutate.py writes into the headers: every mutant has a number, and one of them, or none, is chosen at run time.
// An operator is mutated in its place, a + b to a + plus{7} + b, where precedence and associativity stay what they are.
namespace gdp_mutants {

extern int chosen;
extern unsigned char reached[];

#define GDP_MUTANTS_INLINE __attribute__((always_inline)) inline

GDP_MUTANTS_INLINE bool on(int i)
{
  reached[i] = 1;
  return chosen == i;
}

template <class A>
struct Operand
{
  A&& value;
  int i;
};

// Expressions of Eigen have a type for every operator.
#define GDP_MUTANTS_BINARY(name, op, other)                                                     \
  struct name { int i; };                                                                       \
  template <class A> struct name##_left : Operand<A> {};                                        \
  template <class A> GDP_MUTANTS_INLINE name##_left<A> operator op(A&& a, name n)               \
  { return {{std::forward<A>(a), n.i}}; }                                                       \
  template <class A, class B> GDP_MUTANTS_INLINE auto operator op(name##_left<A>&& a, B&& b)    \
  {                                                                                             \
    if constexpr(std::is_same_v<decltype(a.value op b), decltype(a.value other b)>)             \
      return on(a.i) ? a.value other b : a.value op b;                                          \
    else                                                                                        \
    {                                                                                           \
      if(on(a.i))                                                                               \
        return (a.value other b).eval();                                                        \
      return (a.value op b).eval();                                                             \
    }                                                                                           \
  }

GDP_MUTANTS_BINARY(plus, +, -)
GDP_MUTANTS_BINARY(minus, -, +)
GDP_MUTANTS_BINARY(times, *, /)
GDP_MUTANTS_BINARY(divided, /, *)
GDP_MUTANTS_BINARY(modulo, %, *)
GDP_MUTANTS_BINARY(less, <, <=)
GDP_MUTANTS_BINARY(less_equal, <=, <)
GDP_MUTANTS_BINARY(greater, >, >=)
GDP_MUTANTS_BINARY(greater_equal, >=, >)
GDP_MUTANTS_BINARY(equal, ==, !=)
GDP_MUTANTS_BINARY(not_equal, !=, ==)

// From right to left: a += (add{7} += b).
#define GDP_MUTANTS_ASSIGNMENT(name, op, other)                                                 \
  struct name { int i; };                                                                       \
  template <class B> struct name##_right : Operand<B> {};                                       \
  template <class B> GDP_MUTANTS_INLINE name##_right<B> operator op(name n, B&& b)              \
  { return {{std::forward<B>(b), n.i}}; }                                                       \
  template <class A, class B> GDP_MUTANTS_INLINE decltype(auto) operator op(A&& a, name##_right<B>&& b) \
  {                                                                                             \
    if(on(b.i))                                                                                 \
      a other b.value;                                                                          \
    else                                                                                        \
      a op b.value;                                                                             \
    return std::forward<A>(a);                                                                  \
  }

GDP_MUTANTS_ASSIGNMENT(add, +=, -=)
GDP_MUTANTS_ASSIGNMENT(subtract, -=, +=)
GDP_MUTANTS_ASSIGNMENT(multiply, *=, /=)
GDP_MUTANTS_ASSIGNMENT(divide, /=, *=)

// Unary ones, as no operator binds tighter than ->* but those of a postfix.
#define GDP_MUTANTS_PREFIX(name, result, is, otherwise)                                         \
  struct name { int i; };                                                                       \
  template <class A> GDP_MUTANTS_INLINE result operator->*(name n, A&& a)                       \
  {                                                                                             \
    if(on(n.i))                                                                                 \
      return otherwise;                                                                         \
    return is;                                                                                  \
  }

template <class A> GDP_MUTANTS_INLINE auto plain(A&& a) -> decltype(a.eval()) { return a.eval(); }
template <class A, class = std::enable_if_t<std::is_arithmetic_v<std::decay_t<A>>>>
GDP_MUTANTS_INLINE auto plain(A&& a) { return +a; }

GDP_MUTANTS_PREFIX(negation, bool, !a, bool(a))
GDP_MUTANTS_PREFIX(opposite, auto, plain(-a), plain(a))
GDP_MUTANTS_PREFIX(increment, A&, ++a, --a)
GDP_MUTANTS_PREFIX(decrement, A&, --a, ++a)

#define GDP_MUTANTS_POSTFIX(name, is, otherwise)                                                \
  struct name { int i; };                                                                       \
  template <class A> GDP_MUTANTS_INLINE auto operator->*(A& a, name n)                          \
  {                                                                                             \
    return on(n.i) ? otherwise : is;                                                            \
  }

GDP_MUTANTS_POSTFIX(post_increment, a++, a--)
GDP_MUTANTS_POSTFIX(post_decrement, a--, a++)

template <class T> GDP_MUTANTS_INLINE T literal(int i, T is, T otherwise) { return on(i) ? otherwise : is; }

struct min
{
  int i;
  template <class T> GDP_MUTANTS_INLINE const T& operator()(const T& a, const T& b) const
  { return on(i) ? (a < b ? b : a) : (b < a ? b : a); }
};

struct max
{
  int i;
  template <class T> GDP_MUTANTS_INLINE const T& operator()(const T& a, const T& b) const
  { return on(i) ? (b < a ? b : a) : (a < b ? b : a); }
};

struct sqrt
{
  int i;
  template <class T> GDP_MUTANTS_INLINE auto operator()(T x) const { return on(i) ? std::cbrt(x) : std::sqrt(x); }
};

struct sin
{
  int i;
  template <class T> GDP_MUTANTS_INLINE auto operator()(T x) const { return on(i) ? std::cos(x) : std::sin(x); }
};

} // namespace gdp_mutants

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_MUTANTS_H
