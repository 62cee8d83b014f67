// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_BACKGROUND_TASK_H
#define GRADIENT_DOMAIN_FILTER_BACKGROUND_TASK_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

// Work that goes on beside the rest where a thread of TBB is free for it; otherwise it is done by whoever waits for it.
class Background_task
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::task_group m_group;

public:
  template <class Work>
  explicit Background_task(const Work& work)
  {
    m_group.run(work);
  }
  ~Background_task()
  {
    try { m_group.cancel(); m_group.wait(); }
    catch(...) {} // somebody else's exception is on its way
  }
  void wait() { m_group.wait(); }
#else
public:
  template <class Work>
  explicit Background_task(const Work& work)
  {
    work();
  }
  void wait() {}
#endif

  Background_task(const Background_task&) = delete;
  Background_task& operator=(const Background_task&) = delete;
};

#endif // GRADIENT_DOMAIN_FILTER_BACKGROUND_TASK_H
