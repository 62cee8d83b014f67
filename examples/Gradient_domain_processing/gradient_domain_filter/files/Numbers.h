// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_NUMBERS_H
#define GRADIENT_DOMAIN_FILTER_FILES_NUMBERS_H

#include <cstddef>
#include <string>
#include <string_view>

enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE };

inline bool is_integer(Number_type type) { return type != Number_type::FLOAT && type != Number_type::DOUBLE; }

inline std::size_t size_of(Number_type type)
{
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[int(type)];
}

// How a file spells its numbers: as text, in the byte order of this machine, or in the other one.
enum class Order { ASCII, SAME, SWAPPED };

bool is_little_endian_machine();
inline Order little_endian() { return is_little_endian_machine() ? Order::SAME : Order::SWAPPED; }

// What the type can hold of a number: integers are rounded and clamped, never wrapped, and NaN becomes the least.
double in_range(double x, Number_type type);

// Whether the number stays finite in the type.
bool fits(double x, Number_type type);

double binary_number(const char* at, Number_type type, Order order);
void put_binary_number(char* at, double x, Number_type type, Order order);
void append_binary_number(std::string& text, double x, Number_type type, Order order);

// So many digits that reading into the type gives the same number again; no locale.
void append_number(std::string& text, double x, Number_type type);
void append_integer(std::string& text, std::size_t i);

#endif // GRADIENT_DOMAIN_FILTER_FILES_NUMBERS_H
