// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_VALUE_INDEX_H
#define GRADIENT_DOMAIN_FILTER_FILES_VALUE_INDEX_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

// Numbers tuples of doubles in the order of their first appearance; equal ones have the same number.
template <std::size_t N>
class Value_index
{
  std::vector<std::array<double, N> > m_values;
  std::vector<int> m_table; // a power of two, at most half full
  std::size_t m_mask = 0;

public:
  explicit Value_index(std::size_t expected)
  {
    m_values.reserve(expected);
    resize(2 * expected);
  }

  const std::vector<std::array<double, N> >& values() const { return m_values; }

  int find_or_add(std::array<double, N> value)
  {
    for(double& x : value)
      x += 0.; // -0 is 0
    int& at = place(value);
    if(at >= 0)
      return at;
    at = int(m_values.size());
    m_values.push_back(value);
    if(2 * m_values.size() > m_table.size())
      resize(2 * m_table.size());
    return int(m_values.size()) - 1;
  }

private:
  static std::size_t hash(const std::array<double, N>& value)
  {
    std::uint64_t h = 0;
    for(double x : value)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      h = (h ^ bits) * 0x9e3779b97f4a7c15ull;
      h ^= h >> 29;
    }
    return std::size_t(h);
  }

  int& place(const std::array<double, N>& value)
  {
    std::size_t i = hash(value) & m_mask;
    // NaN equals itself
    while(m_table[i] >= 0 && std::memcmp(&m_values[std::size_t(m_table[i])], &value, sizeof value) != 0)
      i = (i + 1) & m_mask;
    return m_table[i];
  }

  void resize(std::size_t size)
  {
    std::size_t power = 16;
    while(power < size)
      power *= 2;
    m_table.assign(power, -1);
    m_mask = power - 1;
    for(std::size_t i = 0; i < m_values.size(); ++i)
      place(m_values[i]) = int(i);
  }
};

#endif // GRADIENT_DOMAIN_FILTER_FILES_VALUE_INDEX_H
