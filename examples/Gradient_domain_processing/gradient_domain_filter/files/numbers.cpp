// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>

bool is_little_endian_machine()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

double in_range(double x, Number_type type)
{
  static const double range[][2] = {
    {-128., 127.}, {0., 255.}, {-32768., 32767.}, {0., 65535.}, {-2147483648., 2147483647.}, {0., 4294967295.}};
  if(!is_integer(type))
    return x;
  if(!(x >= range[int(type)][0])) // and NaN
    return range[int(type)][0];
  return (std::min)(std::round(x), range[int(type)][1]);
}

bool fits(double x, Number_type type)
{
  return type == Number_type::DOUBLE || !std::isfinite(x) || std::abs(x) <= double((std::numeric_limits<float>::max)());
}

namespace {

template <class T>
double load(const char* at, Order order)
{
  T value;
  if(order == Order::SAME)
    std::memcpy(&value, at, sizeof(T));
  else
  {
    char bytes[sizeof(T)];
    std::reverse_copy(at, at + sizeof(T), bytes);
    std::memcpy(&value, bytes, sizeof(T));
  }
  return double(value);
}

template <class T>
void store(char* at, T value, Order order)
{
  std::memcpy(at, &value, sizeof(T));
  if(order == Order::SWAPPED)
    std::reverse(at, at + sizeof(T));
}

template <class T>
void append_shortest(std::string& text, T x)
{
  char buffer[40];
#ifdef __cpp_lib_to_chars
  text.append(buffer, std::size_t(std::to_chars(buffer, buffer + sizeof buffer, x).ptr - buffer));
#else
  text.append(buffer, std::size_t(std::snprintf(buffer, sizeof buffer, sizeof(T) == 4 ? "%.9g" : "%.17g", double(x))));
#endif
}

} // namespace

double binary_number(const char* at, Number_type type, Order order)
{
  switch(type)
  {
    case Number_type::INT8: return load<std::int8_t>(at, order);
    case Number_type::UINT8: return load<std::uint8_t>(at, order);
    case Number_type::INT16: return load<std::int16_t>(at, order);
    case Number_type::UINT16: return load<std::uint16_t>(at, order);
    case Number_type::INT32: return load<std::int32_t>(at, order);
    case Number_type::UINT32: return load<std::uint32_t>(at, order);
    case Number_type::FLOAT: return load<float>(at, order);
    case Number_type::DOUBLE: return load<double>(at, order);
  }
  return 0;
}

void put_binary_number(char* at, double x, Number_type type, Order order)
{
  x = in_range(x, type);
  switch(type)
  {
    case Number_type::INT8: return store(at, std::int8_t(x), order);
    case Number_type::UINT8: return store(at, std::uint8_t(x), order);
    case Number_type::INT16: return store(at, std::int16_t(x), order);
    case Number_type::UINT16: return store(at, std::uint16_t(x), order);
    case Number_type::INT32: return store(at, std::int32_t(x), order);
    case Number_type::UINT32: return store(at, std::uint32_t(x), order);
    case Number_type::FLOAT: return store(at, float(x), order);
    case Number_type::DOUBLE: return store(at, x, order);
  }
}

void append_binary_number(std::string& text, double x, Number_type type, Order order)
{
  char bytes[8];
  put_binary_number(bytes, x, type, order);
  text.append(bytes, size_of(type));
}

void append_number(std::string& text, double x, Number_type type)
{
  if(type == Number_type::DOUBLE)
    return append_shortest(text, x);
  if(type == Number_type::FLOAT)
    return append_shortest(text, float(x));
  x = in_range(x, type);
  if(x < 0)
    text += '-';
  append_integer(text, std::size_t(std::abs(x)));
}

void append_integer(std::string& text, std::size_t i)
{
  char buffer[24];
  text.append(buffer, std::size_t(std::to_chars(buffer, buffer + sizeof buffer, i).ptr - buffer));
}
