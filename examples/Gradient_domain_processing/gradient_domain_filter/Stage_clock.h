// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_STAGE_CLOCK_H
#define GRADIENT_DOMAIN_FILTER_STAGE_CLOCK_H

#include <CGAL/Gradient_domain_processing/visitor.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

// A visitor that measures the stages, each without those inside of it, shows the current one on a terminal, and keeps
// what an error is about.
class Stage_clock
{
  typedef std::chrono::steady_clock Clock;

  bool m_is_shown;
  std::vector<std::pair<std::string, double> > m_seconds; // in the order of their first appearance
  std::vector<std::string> m_open;
  Clock::time_point m_start = Clock::now(), m_last = m_start;
  int m_shown_percent = -1;
  std::string m_invalid;
  std::vector<std::string> m_notices;

public:
  explicit Stage_clock(bool is_shown) : m_is_shown(is_shown)
  {
    for(const char* name :
        {"read", "validate", "curvature", "metric", "analyze", "assemble", "factor", "solve", "write"})
      m_seconds.emplace_back(name, 0.);
  }
  ~Stage_clock() { clear(); }
  Stage_clock(const Stage_clock&) = delete;
  Stage_clock& operator=(const Stage_clock&) = delete;

  const std::vector<std::pair<std::string, double> >& seconds() const { return m_seconds; }
  double total() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  void begin(const std::string& name)
  {
    lap();
    m_open.push_back(name);
    show(0);
  }

  void end()
  {
    lap();
    m_open.pop_back();
  }

  // The model of GradientDomainVisitor. What the library calls reading is for the program checking.
  void stage_begins(CGAL::Gradient_domain_processing::Stage stage)
  {
    begin(stage == CGAL::Gradient_domain_processing::Stage::READ
            ? "validate"
            : CGAL::Gradient_domain_processing::get_stage_name(stage));
  }
  void stage_ends(CGAL::Gradient_domain_processing::Stage) { end(); }
  bool go_on(double done)
  {
    if(!m_open.empty())
      show(int(100 * done));
    return true;
  }

  template <class Vertex>
  void invalid_vertex(CGAL::Gradient_domain_processing::Error_code, Vertex v)
  {
    m_invalid = "vertex " + std::to_string(std::size_t(v));
  }
  template <class Face>
  void invalid_face(CGAL::Gradient_domain_processing::Error_code, Face f)
  {
    m_invalid = "face " + std::to_string(std::size_t(f));
  }

  void notice(const std::string& sentence) { m_notices.push_back(sentence); }
  const std::vector<std::string>& notices() const { return m_notices; }
  // What was told of a run that is begun again.
  void forget_notices_after(std::size_t number) { m_notices.resize(number); }

  // What the error is about; empty if it is about no vertex or face.
  const std::string& invalid() const { return m_invalid; }

  void clear()
  {
    if(m_is_shown && m_shown_percent >= 0)
      std::fputs("\r\033[K", stderr);
    m_shown_percent = -1;
  }

private:
  void lap()
  {
    const Clock::time_point now = Clock::now();
    if(!m_open.empty())
      for(auto& stage : m_seconds)
        if(stage.first == m_open.back())
          stage.second += std::chrono::duration<double>(now - m_last).count();
    m_last = now;
    m_shown_percent = m_shown_percent < 0 ? -1 : 1000; // another stage: show it
  }

  void show(int percent)
  {
    if(!m_is_shown || percent == m_shown_percent)
      return;
    m_shown_percent = percent;
    if(percent > 0)
      std::fprintf(stderr, "\r\033[K%s %d %%", m_open.back().c_str(), percent);
    else
      std::fprintf(stderr, "\r\033[K%s ...", m_open.back().c_str());
    std::fflush(stderr);
  }
};

// A stage for as long as it lives.
class Timed_stage
{
  Stage_clock& m_clock;

public:
  Timed_stage(Stage_clock& clock, const char* name) : m_clock(clock) { m_clock.begin(name); }
  ~Timed_stage() { m_clock.end(); }
  Timed_stage(const Timed_stage&) = delete;
  Timed_stage& operator=(const Timed_stage&) = delete;
};

#endif // GRADIENT_DOMAIN_FILTER_STAGE_CLOCK_H
