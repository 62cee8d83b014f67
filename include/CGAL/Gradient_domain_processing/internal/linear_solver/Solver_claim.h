// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SOLVER_CLAIM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SOLVER_CLAIM_H

#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Copies of a solver's traits share one solver, and so its factor, which nobody sees. A claim tells whether it was the
// last to take the solver: what it has left there is still there. The solver is known by an address and must outlive
// the claim.
class Solver_claim
{
  struct Solver
  {
    int claims = 0;
    std::uint64_t taken_by = 0;
  };

  struct Registry
  {
    std::mutex mutex;
    std::map<const void*, Solver> solvers;
    std::uint64_t claims = 0; // ever made: each has a number of its own
  };

  const void* m_address = nullptr;
  std::uint64_t m_number = 0;

public:
  explicit Solver_claim(const void* address) : m_address(address)
  {
    const std::lock_guard<std::mutex> lock(registry().mutex);
    m_number = ++registry().claims;
    ++registry().solvers[m_address].claims;
  }

  Solver_claim(Solver_claim&& other) noexcept { swap(other); }
  Solver_claim& operator=(Solver_claim&& other) noexcept
  {
    Solver_claim(std::move(other)).swap(*this);
    return *this;
  }

  ~Solver_claim()
  {
    if(!m_address)
      return;
    const std::lock_guard<std::mutex> lock(registry().mutex);
    const auto solver = registry().solvers.find(m_address);
    if(--solver->second.claims == 0)
      registry().solvers.erase(solver);
  }

  void take()
  {
    const std::lock_guard<std::mutex> lock(registry().mutex);
    registry().solvers[m_address].taken_by = m_number;
  }

  bool is_last() const
  {
    const std::lock_guard<std::mutex> lock(registry().mutex);
    const auto solver = registry().solvers.find(m_address);
    return solver != registry().solvers.end() && solver->second.taken_by == m_number;
  }

private:
  void swap(Solver_claim& other) noexcept
  {
    std::swap(m_address, other.m_address);
    std::swap(m_number, other.m_number);
  }

  static Registry& registry()
  {
    static Registry registry;
    return registry;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SOLVER_CLAIM_H
