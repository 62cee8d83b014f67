// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_RANKS_H
#define GRADIENT_DOMAIN_FILTER_MPI_RANKS_H

#include "../gradient_domain_filter/Failure.h"

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

typedef std::int64_t Global; // the number of a vertex or face of the whole mesh

// The processes that share the work. All functions are called by all of them.
class Ranks
{
  MPI_Comm m_comm;
  int m_rank = 0, m_size = 1;
  mutable std::int64_t m_sent_bytes = 0;

public:
  explicit Ranks(MPI_Comm comm) : m_comm(comm)
  {
    MPI_Comm_rank(comm, &m_rank);
    MPI_Comm_size(comm, &m_size);
  }

  MPI_Comm comm() const { return m_comm; }
  int rank() const { return m_rank; }
  int size() const { return m_size; }
  bool is_first() const { return m_rank == 0; }
  std::int64_t sent_bytes() const { return m_sent_bytes; }
  void count_sent(std::int64_t bytes) const { m_sent_bytes += bytes; }

  // What every rank does for itself, without a word to the others. If it fails on any of them, all throw the Failure
  // of the lowest.
  template <class Work>
  void together(const Work& work) const
  {
    std::string error;
    try
    {
      work();
    }
    catch(const std::bad_alloc&)
    {
      error = "rank " + std::to_string(m_rank) + " is out of memory";
    }
    catch(const std::exception& e)
    {
      error = e.what();
    }
    agree(error);
  }

  // Throws it on all ranks, if any has an error.
  void agree(const std::string& error) const
  {
    int mine = error.empty() ? m_size : m_rank, first;
    MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, m_comm);
    if(first == m_size)
      return;
    std::string shared = error;
    broadcast(shared, first);
    throw Failure(shared);
  }

  void broadcast(std::string& text, int root = 0) const
  {
    int length = int(text.size());
    MPI_Bcast(&length, 1, MPI_INT, root, m_comm);
    text.resize(std::size_t(length));
    MPI_Bcast(&text[0], length, MPI_CHAR, root, m_comm);
  }

  template <class T>
  std::vector<T> gathered(const T& mine) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "bytes travel");
    std::vector<T> all(std::size_t(m_size), mine);
    MPI_Allgather(&mine, int(sizeof(T)), MPI_BYTE, all.data(), int(sizeof(T)), MPI_BYTE, m_comm);
    return all;
  }

  // In the order of the ranks, so that it is the same number every time.
  template <class T>
  T sum(const T& mine) const
  {
    T total = T();
    for(const T& part : gathered(mine))
      total += part;
    return total;
  }
  template <class T>
  T largest(const T& mine) const
  {
    const std::vector<T> all = gathered(mine);
    return *std::max_element(all.begin(), all.end());
  }

  // Where the numbers of every rank begin, if each has `mine` of them; and the end.
  std::vector<Global> first_of_ranks(Global mine) const
  {
    std::vector<Global> first(1, 0);
    for(Global count : gathered(mine))
      first.push_back(first.back() + count);
    return first;
  }

  // Items for every rank, in its order; what comes back is in the order of the senders.
  template <class T>
  std::vector<T> exchange(const std::vector<T>& items, const std::vector<int>& counts,
                          std::vector<int>* received_counts = nullptr) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "bytes travel");
    std::vector<int> incoming(std::size_t(m_size), 0);
    MPI_Alltoall(counts.data(), 1, MPI_INT, incoming.data(), 1, MPI_INT, m_comm);
    const std::vector<int> first_out = offsets(counts), first_in = offsets(incoming);
    std::vector<T> received(std::size_t(first_in.back()));
    MPI_Datatype type; // counts are items, not bytes, which could be more than an int holds
    MPI_Type_contiguous(int(sizeof(T)), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Alltoallv(items.data(), counts.data(), first_out.data(), type, received.data(), incoming.data(),
                  first_in.data(), type, m_comm);
    MPI_Type_free(&type);
    for(int r = 0; r < m_size; ++r)
      count_sent(r == m_rank ? 0 : counts[std::size_t(r)] * std::int64_t(sizeof(T)));
    if(received_counts)
      received_counts->swap(incoming);
    return received;
  }

  static std::vector<int> offsets(const std::vector<int>& counts)
  {
    std::vector<int> first(1, 0);
    for(int count : counts)
      first.push_back(first.back() + count);
    return first;
  }
};

// Items on their way to ranks, in any order; afterwards sorted by rank, and within it in the order they came.
template <class T>
struct Outbox
{
  std::vector<T> items;
  std::vector<int> counts;
  std::vector<std::size_t> from; // which one every item was

  Outbox(const Ranks& ranks, const std::vector<int>& targets, const std::vector<T>& unsorted)
    : items(unsorted.size()), counts(std::size_t(ranks.size()), 0), from(unsorted.size())
  {
    for(int r : targets)
      ++counts[std::size_t(r)];
    std::vector<int> next = Ranks::offsets(counts);
    for(std::size_t i = 0; i < unsorted.size(); ++i)
    {
      const std::size_t at = std::size_t(next[std::size_t(targets[i])]++);
      items[at] = unsorted[i];
      from[at] = i;
    }
  }
};

#endif // GRADIENT_DOMAIN_FILTER_MPI_RANKS_H
