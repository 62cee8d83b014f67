// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shared_output.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <random>

#include <unistd.h>

namespace fs = std::filesystem;

namespace {

// What a signal handler may know. mpirun sends SIGTERM to those that are left when a process dies.
char unfinished[4096] = "";

void remove_unfinished(int signal)
{
  if(unfinished[0] != 0)
    ::unlink(unfinished);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void set_unfinished(const std::string& path)
{
  for(int signal : {SIGINT, SIGTERM, SIGHUP})
    std::signal(signal, remove_unfinished);
  unfinished[0] = 0;
  if(path.size() < sizeof unfinished)
    std::strcpy(unfinished, path.c_str());
}

} // namespace

Shared_output::Shared_output(const Ranks& ranks, const std::string& name) : m_ranks(ranks), m_name(name)
{
  std::signal(SIGXFSZ, SIG_IGN); // writing fails with a reason instead
  ranks.together([&] {
    if(ranks.is_first())
      m_check = std::make_unique<Output_file>(name);
  });
}

void Shared_output::open()
{
  std::string temporary;
  if(m_ranks.is_first())
  {
    std::random_device random;
    fs::path path(m_name);
    if(fs::exists(path))
      path = fs::canonical(path); // a symbolic link stays one
    m_name = path.string();
    path.replace_filename(".gradient_domain_filter." + std::to_string(random()) + ".tmp");
    temporary = path.string();
    set_unfinished(temporary);
  }
  m_ranks.broadcast(temporary);
  m_temporary = temporary;
  const int code = MPI_File_open(m_ranks.comm(), m_temporary.c_str(), MPI_MODE_CREATE | MPI_MODE_EXCL | MPI_MODE_WRONLY,
                                 MPI_INFO_NULL, &m_file);
  if(code != MPI_SUCCESS)
    m_file = MPI_FILE_NULL;
  m_ranks.agree(code == MPI_SUCCESS ? "" : m_name + ": cannot be written");
}

void Shared_output::put(MPI_Offset first, const std::vector<char>& bytes)
{
  MPI_Status status;
  int written = 0;
  const int code = MPI_File_write_at_all(m_file, first, bytes.data(), int(bytes.size()), MPI_BYTE, &status);
  if(code == MPI_SUCCESS && !bytes.empty())
    MPI_Get_count(&status, MPI_BYTE, &written);
  m_ranks.agree(code == MPI_SUCCESS && written == int(bytes.size())
                  ? "" : m_name + ": cannot be written to its end (no room on the disk?)");
}

// Every rank some of it, a part at a time.
void Shared_output::copy(const Ply_slices& input, MPI_Offset begin, MPI_Offset end)
{
  constexpr MPI_Offset part = 1 << 24;
  for(MPI_Offset at = begin; at < end; at += part * m_ranks.size())
  {
    const MPI_Offset first = (std::min)(end, at + part * m_ranks.rank()), last = (std::min)(end, first + part);
    put(first, input.read(first, last - first));
  }
}

void Shared_output::write_vertices(const Ply_slices& input, const New_values& values)
{
  const Ply_slices::Element& vertices = input.vertices();
  std::vector<int> targets;
  for(Global v : values.file_vertices)
    targets.push_back(vertices.rank_of(v, m_ranks.size()));
  const Outbox<Global> out(m_ranks, targets, values.file_vertices);
  const std::vector<Global> changed = m_ranks.exchange(out.items, out.counts);
  std::vector<Ply_slices::Place> places;
  std::vector<std::vector<double> > columns;
  for(std::size_t i = 0; i < values.properties.size(); ++i)
  {
    places.push_back(input.place(values.properties[i]));
    columns.push_back(m_ranks.exchange(Outbox<double>(m_ranks, targets, values.columns[i]).items, out.counts));
  }
  std::vector<std::size_t> order(changed.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return changed[a] < changed[b]; });

  const Global begin = vertices.slice_begin(m_ranks.rank(), m_ranks.size()),
               end = vertices.slice_begin(m_ranks.rank() + 1, m_ranks.size());
  const Global part = (std::max)(Global(1), (Global(1) << 26) / vertices.stride);
  const Global rounds = m_ranks.largest((end - begin + part - 1) / part);
  std::size_t next = 0;
  for(Global round = 0; round < rounds; ++round)
  {
    const Global from = (std::min)(end, begin + round * part), to = (std::min)(end, from + part);
    std::vector<char> bytes = input.read(vertices.first + from * vertices.stride, (to - from) * vertices.stride);
    for(; next < order.size() && changed[order[next]] < to; ++next)
      for(std::size_t i = 0; i < places.size(); ++i)
        put_binary_number(&bytes[std::size_t((changed[order[next]] - from) * vertices.stride) + places[i].offset],
                          in_range(columns[i][order[next]], places[i].type), places[i].type, input.order());
    put(vertices.first + from * vertices.stride, bytes);
  }
}

void Shared_output::write(const Ply_slices& input, const New_values& values)
{
  open();
  const Ply_slices::Element& vertices = input.vertices();
  copy(input, 0, vertices.first);
  write_vertices(input, values);
  copy(input, vertices.first + vertices.count * vertices.stride, input.size());
  const int code = MPI_File_close(&m_file);
  m_ranks.agree(code == MPI_SUCCESS ? "" : m_name + ": cannot be written to its end");
  commit();
}

void Shared_output::commit()
{
  m_ranks.together([&] {
    if(!m_ranks.is_first())
      return;
    std::error_code error;
    const auto before = fs::status(m_name, error);
    if(fs::exists(before))
      fs::permissions(m_temporary, before.permissions(), error);
    fs::rename(m_temporary, m_name, error);
    if(error)
      throw Failure(m_name, "cannot be written: " + error.message());
    set_unfinished("");
  });
  m_temporary.clear();
}

void Shared_output::discard()
{
  if(m_file != MPI_FILE_NULL)
    MPI_File_close(&m_file);
  if(m_temporary.empty() || !m_ranks.is_first())
    return;
  std::error_code error;
  fs::remove(m_temporary, error);
  set_unfinished("");
}
