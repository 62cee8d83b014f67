// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_file.h"
#include "Failure.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <random>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace fs = std::filesystem;

namespace {

#if defined(__unix__) || defined(__APPLE__)
bool is_writable(const fs::path& path) { return ::access(path.c_str(), W_OK) == 0; }

// What a signal handler may know: the file to remove when the program is interrupted.
char unfinished[4096] = "";

void remove_unfinished(int signal)
{
  if(unfinished[0] != 0)
    ::unlink(unfinished);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void set_unfinished(const fs::path& path)
{
  static const bool has_handlers = [] {
    for(int signal : {SIGINT, SIGTERM, SIGHUP})
      if(std::signal(signal, remove_unfinished) == SIG_IGN)
        std::signal(signal, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN); // writing fails with a reason instead
    return true;
  }();
  (void)has_handlers;
  unfinished[0] = 0;
  if(path.native().size() < sizeof unfinished)
    std::strcpy(unfinished, path.c_str());
}
#else
bool is_writable(const fs::path&) { return true; }
void set_unfinished(const fs::path&) {}
#endif

} // namespace

Output_file::Output_file(const std::string& name) : m_name(name), m_path(name), m_is_standard_output(name == "-")
{
  if(m_is_standard_output)
  {
    m_name = "standard output";
    return;
  }
  std::error_code error;
  const auto status = fs::status(m_path, error);
  if(fs::is_directory(status))
    throw Failure(m_name, "is a directory");
  if(fs::exists(status))
  {
    if(!fs::is_regular_file(status))
      throw Failure(m_name, "not a regular file");
    m_path = fs::canonical(m_path); // a symbolic link stays one
    if(!is_writable(m_path))
      throw Failure(m_name, "no permission to write");
  }
  const fs::path folder = m_path.has_parent_path() ? m_path.parent_path() : fs::path(".");
  if(!fs::is_directory(folder, error))
    throw Failure(m_name, "no such folder: " + folder.string());
  if(!is_writable(folder))
    throw Failure(m_name, "no permission to write into " + folder.string());
}

void Output_file::write(std::string contents)
{
  if(m_is_standard_output)
  {
    m_contents = std::move(contents);
    return;
  }
  std::random_device random;
  m_temporary = m_path;
  m_temporary.replace_filename(".gradient_domain_filter." + std::to_string(random()) + ".tmp");
  set_unfinished(m_temporary);
  errno = 0;
  std::FILE* const file = std::fopen(m_temporary.string().c_str(), "wbx");
  if(!file)
  {
    const std::string reason = std::strerror(errno);
    m_temporary.clear();
    throw Failure(m_name, "cannot be written: " + reason);
  }
  const bool is_written =
    std::fwrite(contents.data(), 1, contents.size(), file) == contents.size() && std::fflush(file) == 0;
  const int reason = errno;
  if(std::fclose(file) != 0 || !is_written)
    throw Failure(m_name, std::string("cannot be written: ") + std::strerror(is_written ? errno : reason));
}

void Output_file::commit()
{
  if(m_is_standard_output)
  {
    if(std::fwrite(m_contents.data(), 1, m_contents.size(), stdout) != m_contents.size() || std::fflush(stdout) != 0)
      throw Failure(m_name, std::string("cannot be written: ") + std::strerror(errno));
    return;
  }
  std::error_code error;
  const auto before = fs::status(m_path, error);
  if(fs::exists(before))
    fs::permissions(m_temporary, before.permissions(), error);
  fs::rename(m_temporary, m_path, error);
  if(error)
    throw Failure(m_name, "cannot be written: " + error.message());
  m_temporary.clear();
  set_unfinished(fs::path());
}

void Output_file::discard()
{
  if(m_temporary.empty())
    return;
  std::error_code error;
  fs::remove(m_temporary, error);
  set_unfinished(fs::path());
}
