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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_BORROWED_NUMBER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_BORROWED_NUMBER_H

#include <map>
#include <mutex>
#include <thread>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A number of a library that several threads set for a while, each from enter() to leave(). Whether the library keeps
// one number for the process or one for every thread, all of them are in the end what they were: a number of the
// process is given back by the last who leaves, one of a thread by that thread.
class Borrowed_number
{
public:
  typedef int (*Getter)();
  typedef void (*Setter)(int);

private:
  struct User
  {
    int depth = 0;
    int before = 0;
  };

  const Getter m_get;
  const Setter m_set;
  const int m_number;
  std::mutex m_mutex;
  std::map<std::thread::id, User> m_users;
  int m_first = 0;                // before the first of those who overlap
  bool m_is_of_process = false;   // as one of them has noticed

public:
  // Nothing is set where the library is not there: where a function is null.
  Borrowed_number(Getter get, Setter set, int number) : m_get(get), m_set(set), m_number(number) {}

  void enter()
  {
    if(!m_get || !m_set)
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    User& user = m_users[std::this_thread::get_id()];
    if(user.depth++ > 0)
      return;
    user.before = m_get();
    if(m_users.size() == 1)
    {
      m_first = user.before;
      m_is_of_process = false;
    }
    else if(user.before == m_number)
      m_is_of_process = true;
    m_set(m_number);
  }

  void leave()
  {
    if(!m_get || !m_set)
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    const auto user = m_users.find(std::this_thread::get_id());
    if(--user->second.depth > 0)
      return;
    const int before = user->second.before;
    m_users.erase(user);
    if(m_users.empty())
      m_set(m_is_of_process ? m_first : before);
    else if(!m_is_of_process)
      m_set(before);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_BORROWED_NUMBER_H
