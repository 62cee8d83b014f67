// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs every file of the given folder through the fuzz target, with any compiler and without libFuzzer.

#include "../test_utils.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char* argv[])
{
  if(!GDP_CHECK(argc == 2))
    return GDP_TEST_RESULT();
  std::size_t files = 0;
  for(const auto& entry : std::filesystem::directory_iterator(argv[1]))
  {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    std::cerr << entry.path().filename().string() << std::endl; // the last one is to blame
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++files;
  }
  GDP_CHECK(files >= 40);
  return GDP_TEST_RESULT();
}
