// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A noisy sphere of any size, for gradient_domain_filter_mpi: written and checked a row at a time, never as a whole in
// memory.
//
//   benchmark_sliced_sphere write N FILE.ply     6 (N+1)^2 vertices on the faces of a cube, blown up to a sphere;
//                                                copies at the edges of the cube are in the same place
//   benchmark_sliced_sphere check FILE.ply BETA  of that file, filtered with --gradient-weight BETA: the radius, or
//                                                with --signal harmonic the amplitude, against what is known of spheres
//
// The coordinates of a sphere are harmonics of degree 1, and the property `harmonic` is one of degree 6, both with
// noise. A filter multiplies harmonics of degree l by 1 / (1 + 4 pi beta l (l + 1)).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

constexpr double pi = 3.14159265358979323846, noise_of_radius = 1e-4, noise_of_harmonic = 0.2;

// Between -1 and 1, the same for the same place.
double noise(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed)
{
  std::uint64_t h = seed;
  for(std::int64_t i : {x, y, z})
  {
    h = (h ^ std::uint64_t(i)) * 0x9E3779B97F4A7C15u;
    h ^= h >> 29;
  }
  h *= 0xBF58476D1CE4E5B9u;
  return double(h >> 11) / double(std::uint64_t(1) << 52) - 1;
}

// Re (x + i y)^6: a harmonic polynomial.
double harmonic(double x, double y) { return std::pow(x * x + y * y, 3) * std::cos(6 * std::atan2(y, x)); }

struct Record
{
  double point[3], harmonic;
};

// The place i, j on a face of the cube whose edges have n pieces.
Record vertex(int face, std::int64_t i, std::int64_t j, std::int64_t n)
{
  const std::int64_t u = 2 * i - n, v = 2 * j - n, w = face % 2 ? n : -n;
  const int axis = face / 2;
  std::array<std::int64_t, 3> at;
  at[std::size_t(axis)] = w;
  at[std::size_t((axis + 1) % 3)] = u;
  at[std::size_t((axis + 2) % 3)] = v;
  double p[3];
  for(std::size_t k = 0; k < 3; ++k)
    p[k] = std::tan(pi / 4 * double(at[k]) / double(n)); // about equal areas
  const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  const double factor = (1 + noise_of_radius * noise(at[0], at[1], at[2], 1)) / length;
  Record record{{factor * p[0], factor * p[1], factor * p[2]}, 0};
  record.harmonic = harmonic(p[0] / length, p[1] / length) + noise_of_harmonic * noise(at[0], at[1], at[2], 2);
  return record;
}

void write_vertices(std::int64_t n, std::ofstream& file)
{
  std::vector<Record> row(std::size_t(n + 1));
  for(int face = 0; face < 6; ++face)
    for(std::int64_t i = 0; i <= n; ++i)
    {
      for(std::int64_t j = 0; j <= n; ++j)
        row[std::size_t(j)] = vertex(face, i, j, n);
      file.write(reinterpret_cast<const char*>(row.data()), std::streamsize(row.size() * sizeof(Record)));
    }
}

void write_faces(std::int64_t n, std::ofstream& file)
{
  std::vector<char> row(std::size_t(2 * n * 13));
  for(int face = 0; face < 6; ++face)
    for(std::int64_t i = 0; i < n; ++i)
    {
      char* at = row.data();
      const auto put = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
        *at++ = 3;
        for(std::int64_t v : {a, face % 2 ? b : c, face % 2 ? c : b})
        {
          const std::uint32_t index = std::uint32_t(v);
          std::memcpy(at, &index, sizeof index);
          at += sizeof index;
        }
      };
      for(std::int64_t j = 0; j < n; ++j)
      {
        const std::int64_t a = (face * (n + 1) + i) * (n + 1) + j, b = a + n + 1;
        put(a, b, b + 1);
        put(a, b + 1, a + 1);
      }
      file.write(row.data(), std::streamsize(row.size()));
    }
}

int write(std::int64_t n, const std::string& name)
{
  const std::int64_t vertices = 6 * (n + 1) * (n + 1);
  if(n < 1 || vertices > std::int64_t(UINT32_MAX))
    throw std::string("N is at least 1 and at most 26752");
  std::ofstream file(name, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << vertices
       << "\nproperty double x\nproperty double y\nproperty double z\nproperty double harmonic\nelement face "
       << 12 * n * n << "\nproperty list uchar uint vertex_indices\nend_header\n";
  write_vertices(n, file);
  write_faces(n, file);
  file.close();
  if(!file)
    throw name + ": cannot be written";
  std::cout << vertices << " vertices, " << 12 * n * n << " triangles\n";
  return 0;
}

int check(const std::string& name, double beta)
{
  std::ifstream file(name, std::ios::binary);
  std::int64_t vertices = 0;
  for(std::string line; std::getline(file, line) && line != "end_header";)
    if(line.compare(0, 15, "element vertex ") == 0)
      vertices = std::atoll(line.c_str() + 15);
  double sum = 0, squares = 0, product = 0, norm = 0, off = 0;
  Record record;
  for(std::int64_t v = 0; v < vertices && file.read(reinterpret_cast<char*>(&record), sizeof record); ++v)
  {
    const double* const p = record.point;
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), h = harmonic(p[0] / r, p[1] / r);
    sum += r;
    squares += r * r;
    product += record.harmonic * h;
    norm += h * h;
    off += record.harmonic * record.harmonic;
  }
  if(!file || vertices == 0)
    throw name + ": not what was written";
  const double count = double(vertices), mean = sum / count, amplitude = product / norm;
  std::cout << "radius " << mean << " (before 1, after a filter of positions " << 1 / (1 + 8 * pi * beta)
            << "), deviation " << std::sqrt((std::max)(0., squares / count - mean * mean)) << " (before "
            << noise_of_radius / std::sqrt(3.) << ")\nharmonic " << amplitude
            << " (before 1, after a filter of the property " << 1 / (1 + 4 * pi * beta * 42) << "), deviation "
            << std::sqrt((std::max)(0., (off - amplitude * product) / count)) << " (before "
            << noise_of_harmonic / std::sqrt(3.) << ")\n";
  return 0;
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    std::cout.precision(10);
    if(argc == 4 && std::strcmp(argv[1], "write") == 0)
      return write(std::atoll(argv[2]), argv[3]);
    if(argc == 4 && std::strcmp(argv[1], "check") == 0)
      return check(argv[2], std::atof(argv[3]));
    std::cerr << "benchmark_sliced_sphere write N FILE.ply | check FILE.ply BETA\n";
    return 2;
  }
  catch(const std::string& error)
  {
    std::cerr << "benchmark_sliced_sphere: " << error << "\n";
    return 1;
  }
}
