// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shows what the filters do to a mesh while their weights are moved.

#include "Script.h"
#include "Surface_view.h"
#include "Viewer_window.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QTimer>

#include <exception>
#include <fstream>
#include <iostream>
#include <clocale>
#include <string>

namespace {

constexpr const char* usage = "gradient_domain_viewer [MESH] [--script FILE]\n\n"
                              "Moves the weights of the filters and shows what they make of the mesh. The window has\n"
                              "the command line of gradient_domain_filter that does the same. A script works the\n"
                              "window, one command a line, and ends it: open, save, set, press, turn, drag, space,\n"
                              "screenshot, measure, expect.\n";

void run_script_file(const std::string& path, Viewer_window& window)
{
  std::ifstream file(path);
  if(!file)
    throw std::runtime_error(path + ": cannot be read");
  run_script(file, path, window);
}

int run(QApplication& application, const std::string& mesh, const std::string& script)
{
  Viewer_window window;
  window.show();
  try
  {
    if(!mesh.empty())
      window.open(mesh);
    if(script.empty())
      return application.exec();
    run_script_file(script, window);
    return 0;
  }
  catch(const std::exception& error)
  {
    std::cerr << "gradient_domain_viewer: " << error.what() << std::endl;
    return 1;
  }
}

} // namespace

int main(int argc, char* argv[])
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  std::string mesh, script;
  for(int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if(word == "--help")
    {
      std::cout << usage;
      return 0;
    }
    if(word == "--script" && i + 1 < argc)
      script = argv[++i];
    else if(mesh.empty() && !word.empty() && word[0] != '-')
      mesh = word;
    else
    {
      std::cerr << usage;
      return 2;
    }
  }
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C"); // Qt has taken over the user's, in which 0,5 is a half
  return run(application, mesh, script);
}
