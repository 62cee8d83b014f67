// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_SCRIPT_H
#define GRADIENT_DOMAIN_VIEWER_SCRIPT_H

#include <iosfwd>
#include <string>

class Viewer_window;

// Works the window as hands do, a command a line; what follows # is for people.
//   open FILE                 set NAME VALUE           a slider or a choice, by its name
//   save FILE                 press NAME               a button
//   turn AZIMUTH ELEVATION ZOOM                        degrees
//   drag X Y X2 Y2            the left button, in parts of the view's width and height from its upper left corner
//   space down|up             before and after
//   screenshot FILE.png       measure NAME N           N values of a slider, with the frames a second
//   expect TEXT               the command line or the status line has this text
// Throws Failure where a line fails.
void run_script(std::istream& lines, const std::string& name, Viewer_window& window);

#endif // GRADIENT_DOMAIN_VIEWER_SCRIPT_H
