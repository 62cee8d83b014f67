// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Script.h"
#include "Failure.h"
#include "Surface_view.h"
#include "Value_slider.h"
#include "Viewer_window.h"

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPixmap>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStatusBar>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <vector>

namespace {

class Script
{
  Viewer_window& m_window;

public:
  explicit Script(Viewer_window& window) : m_window(window) {}

  void run(const std::string& line)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string verb;
    if(!(words >> verb))
      return;
    if(verb == "open")
      m_window.open(rest(words));
    else if(verb == "save")
      m_window.save(rest(words));
    else if(verb == "set")
      set(words);
    else if(verb == "press")
      find<QPushButton>(word(words)).click();
    else if(verb == "turn")
      turn(words);
    else if(verb == "drag")
      drag(words);
    else if(verb == "space")
      space(word(words) == "down");
    else if(verb == "screenshot")
      screenshot(rest(words));
    else if(verb == "measure")
      measure(words);
    else if(verb == "expect")
      expect(rest(words));
    else
      throw Failure("there is no command '" + verb + "'");
    settle();
  }

  // Until nothing is left to be done.
  void settle()
  {
    do
      QApplication::processEvents();
    while(m_window.is_busy());
    QApplication::processEvents();
  }

private:
  static std::string word(std::istream& words)
  {
    std::string word;
    if(!(words >> word))
      throw Failure("a word is missing");
    return word;
  }
  static std::string rest(std::istream& words)
  {
    std::string rest;
    std::getline(words >> std::ws, rest);
    while(!rest.empty() && rest.back() == ' ')
      rest.pop_back();
    if(rest.empty())
      throw Failure("a word is missing");
    return rest;
  }
  static double number(std::istream& words)
  {
    double x;
    if(!(words >> x))
      throw Failure("a number is missing");
    return x;
  }

  template <class Widget>
  Widget& find(const std::string& name)
  {
    for(QWidget* child : m_window.findChildren<QWidget*>(QString::fromStdString(name)))
      if(Widget* const widget = dynamic_cast<Widget*>(child))
        return *widget;
    throw Failure("there is no '" + name + "'");
  }

  void set(std::istream& words)
  {
    const std::string name = word(words), value = rest(words);
    const auto children = m_window.findChildren<QComboBox*>(QString::fromStdString(name));
    if(children.isEmpty())
    {
      std::istringstream text(value);
      find<Value_slider>(name).set_value(number(text));
      return;
    }
    const int choice = children[0]->findText(QString::fromStdString(value), Qt::MatchStartsWith);
    if(choice < 0)
      throw Failure("there is no choice '" + value + "'");
    children[0]->setCurrentIndex(choice);
  }

  void turn(std::istream& words)
  {
    const double azimuth = number(words), elevation = number(words), zoom = number(words);
    m_window.view().turn(azimuth, elevation, zoom);
    m_window.view().draw();
  }

  void mouse(QEvent::Type type, const QPointF& place, Qt::MouseButton button, Qt::MouseButtons buttons)
  {
    QMouseEvent event(type, place, button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&m_window.view(), &event);
    QApplication::processEvents();
  }
  void drag(std::istream& words)
  {
    const QSize size = m_window.view().size();
    const auto place = [&] {
      const double x = number(words), y = number(words);
      return QPointF(x * size.width(), y * size.height());
    };
    const QPointF from = place(), to = place();
    mouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for(int i = 1; i <= 8; ++i)
      mouse(QEvent::MouseMove, from + (to - from) * i / 8, Qt::NoButton, Qt::LeftButton);
    mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  }

  void space(bool is_down)
  {
    m_window.activateWindow();
    settle();
    QKeyEvent event(is_down ? QEvent::KeyPress : QEvent::KeyRelease, Qt::Key_Space, Qt::NoModifier, " ");
    QApplication::sendEvent(&m_window, &event);
  }

  void screenshot(const std::string& path)
  {
    settle();
    if(!m_window.grab().save(QString::fromStdString(path)))
      throw Failure(path, "cannot be written");
  }

  void measure(std::istream& words)
  {
    const std::string name = word(words);
    const int times = int(number(words));
    Value_slider& slider = find<Value_slider>(name);
    const double before = slider.value();
    std::vector<double> milliseconds;
    for(int i = 1; i <= times; ++i)
    {
      QElapsedTimer clock;
      clock.start();
      slider.set_value(before * (1 + 0.5 * i / times) + 0.01 * i);
      settle();
      milliseconds.push_back(double(clock.nsecsElapsed()) * 1e-6);
    }
    std::nth_element(milliseconds.begin(), milliseconds.begin() + times / 2, milliseconds.end());
    std::cout << name << ": " << milliseconds[std::size_t(times / 2)] << " ms from slider to screen (median of "
              << times << "); " << m_window.statusBar()->currentMessage().toStdString() << std::endl;
  }

  void expect(const std::string& text)
  {
    const std::string command = find<QPlainTextEdit>("command").toPlainText().toStdString(),
                      status = m_window.statusBar()->currentMessage().toStdString();
    if(command.find(text) == std::string::npos && status.find(text) == std::string::npos)
      throw Failure("'" + text + "' is neither in '" + command + "' nor in '" + status + "'");
  }
};

} // namespace

void run_script(std::istream& lines, const std::string& name, Viewer_window& window)
{
  Script script(window);
  script.settle();
  std::string line;
  for(int n = 1; std::getline(lines, line); ++n)
    try
    {
      script.run(line);
    }
    catch(const std::exception& error)
    {
      throw Failure(name + ":" + std::to_string(n), error.what());
    }
}
