// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_OUTPUT_FILE_H
#define GRADIENT_DOMAIN_FILTER_OUTPUT_FILE_H

#include <filesystem>
#include <string>

// A file that is there completely or not at all: written under another name in the same folder, then renamed. "-" is
// the standard output, written at the end.
class Output_file
{
  std::string m_name; // as the user said it
  std::filesystem::path m_path, m_temporary;
  bool m_is_standard_output;
  std::string m_contents; // for the standard output

public:
  // Throws Failure if the file surely cannot be written, before any work is done for it.
  explicit Output_file(const std::string& name);
  ~Output_file() { discard(); }
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  // Both throw Failure.
  void write(std::string contents);
  void commit();

private:
  void discard();
};

#endif // GRADIENT_DOMAIN_FILTER_OUTPUT_FILE_H
