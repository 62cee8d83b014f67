// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_parts.h"

#include <iostream>

namespace po = boost::program_options;

namespace {

po::options_description filter_options(Options& o)
{
  po::options_description d("What is done", 100, 60);
  d.add_options()
    ("operation", po::value<std::string>()->default_value("filter"),
     "filter | enhance-details (smooth, then sharpen what is left) | denoise | fair (the vertices of "
     "--region-vertices go on smoothly from "
     "their surroundings) | low-pass | high-pass | band-pass | band-stop (waves by --wavelengths) | spectrum "
     "(harmonics are written as "
     "properties harmonic_0, ...)")
    ("wavelengths", po::value<std::string>()->value_name("A[,B]"),
     "cut-offs of low-pass and the like, in the unit of the file")
    ("order", po::value(&o.filter_order)->default_value(4), "how sharp these are")
    ("window", po::value<std::string>()->value_name("NAME"),
     "hamming | hann | blackman | nuttall: steeper filters, a step whose series is damped, in place of --order")
    ("degree", po::value(&o.filter_degree)->default_value(40), "how many terms such a series has")
    ("count", po::value(&o.number_of_harmonics)->default_value(10), "of the harmonics of spectrum")
    ("shift", po::value<double>()->value_name("X"),
     "spectrum finds those whose eigenvalues are nearest to X, (2 pi / wavelength)^2, not the lowest")
    ("eigenvalues", po::value(&o.eigenvalues)->value_name("FILE.csv"), "where spectrum writes the eigenvalues")
    ("hessian-weight", po::value(&o.hessian_weight)->default_value(0, "0"),
     "weight of second derivatives, a squared --gradient-weight: smooths without pulling borders in")
    ("signal", po::value<std::string>()->default_value("position"),
     "position | normal | color | normal-to-position (filter the normals, then fit the positions to them) | "
     "curvature (nothing is "
     "filtered: k1^2 + k2^2 is written as property 'curvature' and as color) | NAME[,NAME...]: properties of "
     "vertices or of faces")
    ("value-weight", po::value(&o.value_weight)->default_value(1, "1"), "alpha: how strongly values are kept")
    ("gradient-weight", po::value(&o.gradient_weight)->default_value(1e-4, "1e-4"),
     "beta: how strongly gradients are fitted, 1e-6 (fine noise) to 1e-2; in units of the area of the mesh")
    ("gradient-scale", po::value(&o.gradient_scale)->default_value(0, "0"),
     "lambda: below 1 smooths, above 1 sharpens; 1 for normal-to-position without a --gradient-weight")
    ("metric", po::value<std::string>()->default_value("embedding"),
     "embedding | edge-aware | anisotropic | preserve-convex | preserve-concave; edge-aware if a --curvature-weight "
     "is given")
    ("curvature-weight", po::value(&o.curvature_weight)->default_value(0.02, "0.02"),
     "epsilon: how strongly curvature stretches the metric")
    ("curvature", po::value<std::string>()->default_value("jets"), "jets | normals: how curvature is estimated")
    ("jet-degree", po::value(&o.jet_degree)->default_value(2), "2 to 4")
    ("presmoothing-weight", po::value(&o.presmoothing_weight)->default_value(1e-4, "1e-4"),
     "gamma: smoothing before curvature is estimated; 0 for none")
    ("non-shrinking", po::value(&o.non_shrinking)->implicit_value(2, "2"),
     "[K]: the filter is applied K times to what it has missed, which keeps large shapes; K is 2 if it is not said")
    ("normal-projection-weight", po::value(&o.normal_projection_weight)->default_value(100, "100"),
     "how strongly normal-to-position fits the normals")
    ("normal-fit", po::value<std::string>()->default_value("faces"),
     "faces | edges: what normal-to-position asks of the normals")
    ("iterations", po::value(&o.iterations)->default_value(1), "passes, each with a metric of its own")
    ("sharpening-weight", po::value(&o.sharpening_weight)->default_value(1e-5, "1e-5"),
     "beta of the second pass of enhance-details")
    ("sharpening-scale", po::value(&o.sharpening_scale)->default_value(4, "4"),
     "lambda of the second pass of enhance-details")
    ("passes", po::value<int>(), "passes of denoise; otherwise chosen from the data, as all of these")
    ("noise-level", po::value<double>(), "noise of the face normals in radians, for denoise")
    ("noise-scale", po::value<double>(), "over how many edges the noise goes, for denoise")
    ("area-normalization", po::value<std::string>()->default_value("on"),
     "on | off: weights are squared lengths in the unit of the file");
  return d;
}

po::options_description place_options(Options& o)
{
  po::options_description d("Where (PROPERTY: a number at every vertex of the file, as in PLY)", 100, 60);
  d.add_options()
    ("constrain", po::value(&o.constrained_property)->value_name("PROPERTY"), "vertices where it is not 0 are kept")
    ("region", po::value(&o.region_property)->value_name("PROPERTY"),
     "only faces all of whose vertices have another number than 0 are worked on; all other vertices are kept")
    ("region-vertices", po::value(&o.region_vertices_property)->value_name("PROPERTY"),
     "fair moves the vertices where it is not 0; without it those where that of --constrain is 0")
    ("value-weight-property", po::value(&o.value_weight_property)->value_name("PROPERTY"), "alpha at every vertex")
    ("gradient-weight-property", po::value(&o.gradient_weight_property)->value_name("PROPERTY"),
     "beta at every vertex; that of a face is the mean of its three")
    ("gradient-scale-property", po::value(&o.gradient_scale_property)->value_name("PROPERTY"), "lambda, likewise")
    ("border", po::value<std::string>()->default_value("free"),
     "free | fixed | along-border (the border is filtered as a curve of its own)")
    ("non-manifold", po::value<std::string>()->default_value("free"),
     "free | fixed | along-lines: what happens to edges with more than two faces, likewise; the sheets stay together")
    ("restore-volume", "scale every component so that it encloses the volume it enclosed before")
    ("axes", po::value<std::string>()->value_name("AXES"),
     "x, y, z, xy, xz or yz: vertices move along these only, as heights of terrain")
    ("max-displacement", po::value<double>()->value_name("D"), "no vertex moves further, in the unit of the file")
    ("missing-values",
     "NaN in a property that is the signal, or in a coordinate along the one axis of --axes, means that there is no "
     "value: it is filled in")
    ("weld-tolerance", po::value<double>()->value_name("T"),
     "border vertices so close are one, relative to the extent; without it those of the same place")
    ("no-weld", "border vertices of the same place are not one: seams open");
  return d;
}

po::options_description file_options(Options& o)
{
  po::options_description d("Files and machine", 100, 60);
  d.add_options()
    ("input-format", po::value<std::string>()->value_name("FORMAT"),
     "off | obj | ply | stl: not by the extension, or for INPUT -, not by its contents")
    ("output-format", po::value<std::string>()->value_name("FORMAT"),
     "likewise; for OUTPUT - it is that of the input otherwise")
    ("ascii", "write PLY or STL as text (otherwise as the input; PLY that was another format in binary)")
    ("binary",
     "write PLY or STL in binary (otherwise as the input; STL that was another format as text: its binary form is "
     "single precision)")
    ("precision", po::value<std::string>()->value_name("single|double"),
     "of what is written; otherwise the types of a PLY stay, and all else is double")
    ("keep-normals", "normals of the file stay when vertices move; otherwise they follow the surface")
    ("solver", po::value<std::string>()->default_value("auto"), "auto | eigen | cholmod | cg")
    ("threads", po::value(&o.threads), "at most so many threads (TBB)")
    ("report", po::value(&o.report)->value_name("FILE.json"), "write what was done, with times and memory")
    ("picture", po::value(&o.picture)->value_name("FILE.png"),
     "draw the surface before, after, and with its displacement (where the program was built with VTK)")
    ("verbose", "say what was done")
    ("quiet", "neither progress on the terminal nor remarks: nothing but errors")
    ("help", "this text")
    ("version", "the version");
  return d;
}

} // namespace

po::options_description describe_options(Options& o)
{
  po::options_description all;
  all.add(filter_options(o)).add(place_options(o)).add(file_options(o));
  return all;
}

void print_help(const po::options_description& described)
{
  std::cout << "gradient_domain_filter INPUT OUTPUT [options]\n\n"
               "Smooths, sharpens and otherwise filters a signal on a mesh by prescribing its gradients: finds the g\n"
               "that minimizes alpha |f - g|^2 + beta |lambda grad f - grad g|^2. Reads and writes OFF, OBJ, PLY\n"
               "and STL, also packed (.gz), by extension; - is standard input or output. Any polygons, connected\n"
               "in any way. What is not filtered comes out as it came in; what another format cannot hold is said.\n"
               "OUTPUT may be INPUT.\n"
            << described
            << "\nExit code: 0, or 1 if the work failed, or 2 if the command line makes no sense. On failure\n"
               "OUTPUT is as it was.\n\n"
               "  gradient_domain_filter scan.ply smooth.ply --gradient-weight 1e-4\n"
               "  gradient_domain_filter scan.ply sharp.ply --gradient-scale 2\n"
               "  gradient_domain_filter part.obj clean.obj --metric anisotropic --gradient-weight 1e-3\n";
}
