// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// gradient_domain_filter from outside: exit codes, messages, files. The program is named by the environment variable
// GRADIENT_DOMAIN_FILTER or the first argument.

#include "test_utils.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace fs = std::filesystem;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace {

std::string program;
fs::path folder; // of our own, removed at the end

std::string contents(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

void write(const fs::path& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

std::size_t number_of_files()
{
  return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

struct Outcome
{
  int code;
  std::string out, err;
};

// Arguments are words without quotes; files are in our folder. `before` is shell text before the program.
Outcome run(const std::string& arguments, const std::string& before = std::string())
{
  const fs::path out = folder / "stdout", err = folder / "stderr";
  const std::string command = "cd \"" + folder.string() + "\" && { " + before + " \"" + program + "\" " + arguments + "; } >stdout 2>stderr";
  int code = std::system(command.c_str());
#if defined(__unix__) || defined(__APPLE__)
  code = WIFEXITED(code) ? WEXITSTATUS(code) : -1;
#endif
  const Outcome outcome{code, contents(out), contents(err)};
  fs::remove(out);
  fs::remove(err);
  return outcome;
}

bool is_one_line(const std::string& text)
{
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n' && text.compare(0, 24, "gradient_domain_filter: ") == 0;
}

// One line that names `what`, the right code, and no trace in the folder.
void check_fails(const std::string& arguments, int code, const std::string& what, const std::string& before = std::string())
{
  const std::size_t files = number_of_files();
  const Outcome outcome = run(arguments, before);
  const bool holds = outcome.code == code && is_one_line(outcome.err) && outcome.err.find(what) != std::string::npos
                     && outcome.out.empty() && number_of_files() == files;
  if(!GDP_CHECK(holds))
    std::cerr << "  " << arguments << ": exit " << outcome.code << ", " << outcome.err << std::endl;
}

void check_succeeds(const std::string& arguments)
{
  const Outcome outcome = run(arguments);
  if(!GDP_CHECK(outcome.code == 0 && outcome.err.empty()))
    std::cerr << "  " << arguments << ": exit " << outcome.code << ", " << outcome.err << std::endl;
}

Mesh read_off(const fs::path& path)
{
  Mesh mesh;
  std::ifstream in(path);
  GDP_CHECK(CGAL::IO::read_OFF(in, mesh));
  return mesh;
}

Mesh read_ply(const std::string& name)
{
  Mesh mesh;
  std::ifstream in(folder / name, std::ios::binary);
  std::string comments;
  GDP_CHECK(CGAL::IO::read_PLY(in, mesh, comments));
  return mesh;
}

// The mesh as PLY text with colors, normals, a mask and other properties.
std::string ply_with_properties(const Mesh& mesh)
{
  std::ostringstream out;
  out.precision(17);
  out << "ply\nformat ascii 1.0\ncomment a mesh\nelement vertex " << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float ny\nproperty float nz\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int selected\nproperty float quality\nproperty double alpha_weight\n"
         "element face " << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n";
  int i = 0;
  for(auto v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    out << p.x() << " " << p.y() << " " << p.z() << " 0 0.5 0.25 " << (i % 3 == 0 ? 255 : 0) << " " << (i * 7) % 256 << " 128 "
        << (p.x() > 0) << " " << i * 0.5 << " " << 1 + i % 2 << "\n";
    ++i;
  }
  i = 0;
  for(auto f : mesh.faces())
  {
    out << 3;
    for(auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << " " << std::size_t(v);
    out << " " << i++ << "\n";
  }
  return out.str();
}

void test_usage()
{
  check_fails("", 2, "two files");
  check_fails("mesh.off", 2, "two files");
  check_fails("mesh.off a.ply b.ply", 2, "two files");
  check_fails("mesh.off out.xyz", 2, "out.xyz");
  check_fails("mesh out.ply", 2, "extension");
  check_fails("mesh.off out.ply --no-such-option", 2, "no-such-option");
  check_fails("mesh.off out.ply -x", 2, "-x");
  check_fails("mesh.off out.ply --value-weight %value%", 2, "%value%");
  check_fails("mesh.off out.ply --metric", 2, "metric");
  check_fails("mesh.off out.ply --metric round", 2, "edge-aware");
  check_fails("mesh.off out.ply --gradient-weight much", 2, "gradient-weight");
  check_fails("mesh.off out.ply --gradient-weight -1", 2, "gradient-weight");
  check_fails("mesh.off out.ply --gradient-weight nan", 2, "gradient-weight");
  check_fails("mesh.off out.ply --value-weight inf", 2, "value-weight");
  check_fails("mesh.off out.ply --iterations 0", 2, "iterations");
  check_fails("mesh.off out.ply --metric edge-aware --jet-degree 7", 2, "jet-degree");
  check_fails("mesh.off out.ply --jet-degree 3", 2, "--metric");
  check_fails("mesh.off out.ply --metric embedding --curvature-weight 1", 2, "curvature-weight");
  check_fails("mesh.off out.ply --value-weight 1 --value-weight-property w", 2, "contradicts");
  check_fails("mesh.off out.ply --verbose --quiet", 2, "contradicts");
  check_fails("mesh.off out.ply --ascii --binary", 2, "contradicts");
  check_fails("mesh.off out.off --binary", 2, "binary");
  check_fails("mesh.off out.stl --signal normal", 2, "STL");
  check_fails("mesh.off out.off --signal curvature", 2, "PLY");
  check_fails("mesh.off out.ply --signal curvature --gradient-weight 1", 2, "gradient-weight");
  check_fails("mesh.off out.ply --signal normal --restore-volume", 2, "restore-volume");
  check_fails("mesh.off out.ply --operation enhance-details --signal color", 2, "contradicts");
  check_fails("mesh.off out.ply --sharpening-scale 2", 2, "enhance-details");
  check_fails("mesh.off out.ply --report out.ply", 2, "report");
  check_fails("mesh.off out.ply --report ./mesh.off", 2, "report");
  check_fails("mesh.off out.ply --report ./out.ply", 2, "report");
  GDP_CHECK(run("--help").code == 0);
  GDP_CHECK(run("--help").out.find("--gradient-weight") != std::string::npos);
  GDP_CHECK(run("--version").out.find("gradient_domain_filter") == 0);
}

void test_bad_files(const Mesh& mesh)
{
  const std::string off = contents(folder / "mesh.off");
  write(folder / "out.ply", "as it was");
  const auto fails = [&](const std::string& name, const std::string& text, const std::string& what) {
    write(folder / name, text);
    check_fails(name + " out.ply", 1, what);
    GDP_CHECK(contents(folder / name) == text);
    fs::remove(folder / name);
  };
  check_fails("missing.off out.ply", 1, "missing.off: no such file");
  fs::create_directory(folder / "folder.ply");
  check_fails("folder.ply out.ply", 1, "folder.ply: is a directory");
  check_fails("mesh.off folder.ply", 1, "folder.ply: is a directory");
  check_fails("mesh.off nowhere/out.ply", 1, "no such folder");
  check_fails("mesh.off out.ply --report nowhere/report.json", 1, "no such folder");
  fs::remove(folder / "folder.ply");

  fails("bad.ply", "", "empty");
  fails("bad.ply", off, "not a PLY file");
  fails("bad.stl", off, "STL");
  fails("bad.obj", "nothing here\n", "OBJ");
  fails("bad.off", "solid\n", "not an OFF file");
  fails("bad.off", "OFF\n4000000000 9 0\n0 0 0\n", "4000000000");
  fails("bad.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "4000000000");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "face 0");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "vertex 1");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1e151 0\n3 0 1 2\n", "vertex 2: ");
  write(folder / "normals.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 nan 1\n0 1 0 0 0 1\n3 0 1 2\n");
  check_fails("normals.off out.ply --signal normal", 1, "normals.off: vertex 1: ");
  check_fails("normals.off out.ply --metric edge-aware", 1, "normals.off: vertex 1: ");
  fs::remove(folder / "normals.off");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "vertex 1");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "does not exist");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "does not exist");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n", "twice");
  fails("bad.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no faces");
  fails("bad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "--triangulate");
  fails("bad.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n3 0 1 2\n3 1 0 3\n3 0 1 4\n", "--repair");
  fails("bad.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n3 0 1 2\n3 0 3 4\n", "vertex 0");
  fails("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4");
  fails("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4");
  fails("bad.stl", std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(50, ' '), "STL");

  const std::string head = "ply\nformat binary_little_endian 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  fails("bad.ply", head + "element vertex 99999999999\n" + xyz + "end_header\n", "do not fit");
  fails("bad.ply", head + "element vertex 99999999999\nend_header\n", "without a property");
  fails("bad.ply", head + "element vertex -1\n" + xyz + "end_header\n", "header");
  fails("bad.ply", head + "element vertex 1\nproperty quad x\nend_header\n", "quad");
  fails("bad.ply", head + "element vertex 1\n" + xyz + "element face 1\nproperty list uchar float vertex_indices\nend_header\n"
                   + std::string(30, '\0'), "list of integers");
  fails("bad.ply", head + "element vertex 1\n" + xyz + "element face 1\nproperty list uint int vertex_indices\nend_header\n"
                   + std::string(12, '\0') + "\xff\xff\xff\xff", "ends");

  // truncated at every kilobyte
  for(const char* arguments : {"whole.ply --binary", "whole.ply --ascii", "whole.stl --binary", "whole.stl --ascii", "whole.off"})
  {
    const std::string words(arguments), name = words.substr(0, words.find(' ')), extension = name.substr(name.find('.'));
    check_succeeds("mesh.off " + words);
    const std::string whole = contents(folder / name);
    fs::remove(folder / name);
    GDP_CHECK(whole.size() > 5000);
    for(std::size_t size = 0; size < whole.size() - 1; size += 1024)
      fails("cut" + extension, whole.substr(0, size), "cut" + extension + ": ");
  }
  check_succeeds("mesh.off whole.obj"); // does not say how long it is: what is there is taken, if it makes a mesh
  const std::string obj = contents(folder / "whole.obj");
  fs::remove(folder / "whole.obj");
  for(std::size_t size = 0; size < obj.size(); size += 1024)
  {
    write(folder / "cut.obj", obj.substr(0, size));
    const Outcome outcome = run("cut.obj cut.ply");
    GDP_CHECK(outcome.code == 0 ? outcome.err.empty() : outcome.code == 1 && is_one_line(outcome.err));
    fs::remove(folder / "cut.obj");
    fs::remove(folder / "cut.ply");
  }
  GDP_CHECK(contents(folder / "out.ply") == "as it was");
  fs::remove(folder / "out.ply");
  check_fails("properties.ply out.ply --constrain nothing", 1, "'nothing'");
  check_fails("mesh.off out.ply --signal color", 1, "color");
  check_fails("mesh.off out.ply --value-weight 0", 1, "mesh.off: ");
  GDP_CHECK(mesh.number_of_faces() > 0);
}

// Nothing can be written, or not all of it.
void test_no_room()
{
#if defined(__unix__) || defined(__APPLE__)
  const std::string off = contents(folder / "mesh.off");
  const auto unwritable = [&](const std::string& arguments, const std::string& what, const std::string& before) {
    check_fails(arguments, 1, what, before);
    GDP_CHECK(contents(folder / "mesh.off") == off);
  };
  // as on a full disk, writing fails in the middle
  write(folder / "out.ply", "as it was");
  unwritable("mesh.off out.ply", "out.ply: cannot be written", "ulimit -f 8;");
  GDP_CHECK(contents(folder / "out.ply") == "as it was");
  unwritable("mesh.off mesh.off", "mesh.off: cannot be written", "ulimit -f 8;");
  unwritable("mesh.off new.stl", "new.stl: cannot be written", "ulimit -f 8;");
  if(fs::exists("/dev/full"))
  {
    fs::create_symlink("/dev/full", folder / "full.ply");
    unwritable("mesh.off full.ply", "full.ply: not a regular file", "");
    unwritable("mesh.off out.ply --report full.ply", "full.ply: not a regular file", "");
    unwritable("full.ply out.ply", "full.ply: not a regular file", "");
    fs::remove(folder / "full.ply");
  }
  fs::remove(folder / "out.ply");

  // the superuser may do everything, so be somebody else
  const std::string nobody = ::geteuid() == 0 ? "setpriv --reuid 65534 --regid 65534 --clear-groups" : "";
  fs::permissions(folder, fs::perms::all);
  if(run("--version", nobody).code == 0)
  {
    fs::create_directory(folder / "closed");
    write(folder / "closed" / "out.ply", "as it was");
    write(folder / "secret.off", off);
    fs::permissions(folder / "closed" / "out.ply", fs::perms::owner_read);
    fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
    fs::permissions(folder / "secret.off", fs::perms::none);
    unwritable("mesh.off closed/new.ply", "closed/new.ply: no permission to write into closed", nobody);
    unwritable("mesh.off closed/out.ply", "closed/out.ply: no permission to write", nobody);
    unwritable("secret.off out.ply", "secret.off: cannot be opened", nobody);
    fs::permissions(folder / "closed", fs::perms::owner_all);
    GDP_CHECK(contents(folder / "closed" / "out.ply") == "as it was");
    GDP_CHECK(std::distance(fs::directory_iterator(folder / "closed"), fs::directory_iterator()) == 1);
    fs::remove_all(folder / "closed");
    fs::remove(folder / "secret.off");
  }
  else
    std::cerr << "missing permissions are not tested: the program cannot be run by another user" << std::endl;
#endif
}

double largest_difference(const Mesh& a, const Mesh& b)
{
  if(a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces())
    throw std::runtime_error("meshes of different size");
  double largest = 0;
  for(auto v : a.vertices())
    largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(a.point(v), b.point(v))));
  return largest;
}

void test_result(const Mesh& mesh)
{
  Mesh expected = mesh;
  GDP_CHECK(GDP::smooth(expected, GDP::parameters::gradient_weight(1e-3).gradient_scale(0.5)) == GDP::OK);
  const std::string options = " --gradient-weight 1e-3 --gradient-scale 0.5";
  GDP_CHECK(largest_difference(mesh, expected) > 1e-3);
  for(const char* solver : {"auto", "eigen", "cg"})
  {
    check_succeeds("mesh.off out.ply --solver " + std::string(solver) + options);
    GDP_CHECK_NEAR(largest_difference(read_ply("out.ply"), expected), 0, 1e-11);
  }
  check_succeeds("mesh.off out.off" + options);
  GDP_CHECK_NEAR(largest_difference(read_off(folder / "out.off"), expected), 0, 1e-12);

  // every format takes the result through, to the bit
  const Mesh written = read_off(folder / "out.off");
  for(const char* name : {"a.obj", "b.ply", "c.off", "d.ply --ascii"})
  {
    const std::string arguments(name), file = arguments.substr(0, arguments.find(' '));
    check_succeeds("out.off " + arguments + " --gradient-weight 0");
    check_succeeds(file + " back.off --gradient-weight 0");
    GDP_CHECK(largest_difference(read_off(folder / "back.off"), written) == 0);
    fs::remove(folder / file);
  }
  check_succeeds("out.off a.stl --gradient-weight 0"); // orders the vertices anew
  check_succeeds("a.stl b.stl --binary --gradient-weight 0");
  check_succeeds("b.stl back.off --gradient-weight 0");
  const Mesh back = read_off(folder / "back.off");
  GDP_CHECK(back.number_of_vertices() == mesh.number_of_vertices() && back.number_of_faces() == mesh.number_of_faces());

  // the output may be the input
  fs::copy_file(folder / "mesh.off", folder / "same.off");
  check_succeeds("same.off same.off" + options);
  GDP_CHECK(contents(folder / "same.off") == contents(folder / "out.off"));
  fs::copy_file(folder / "mesh.off", folder / "same.off", fs::copy_options::overwrite_existing);
  fs::create_symlink("same.off", folder / "link.off");
  check_succeeds("same.off link.off" + options);
  GDP_CHECK(fs::is_symlink(folder / "link.off") && contents(folder / "same.off") == contents(folder / "out.off"));
  for(const char* name : {"link.off", "same.off", "out.off", "out.ply", "back.off", "a.stl", "b.stl"})
    fs::remove(folder / name);
}

// A property map that should be there; CGAL 6 answers with an optional, older ones with a pair.
template <class Key, class Value>
auto existing_map(const Mesh& mesh, const std::string& name)
{
  const auto found = mesh.property_map<Key, Value>(name);
#if CGAL_VERSION_NR < 1060000000
  const bool exists = found.second;
#else
  const bool exists = found.has_value();
#endif
  if(!exists)
    throw std::runtime_error("no property " + name);
#if CGAL_VERSION_NR < 1060000000
  return found.first;
#else
  return *found;
#endif
}

void test_properties(const Mesh& mesh)
{
  check_succeeds("properties.ply out.ply --ascii --constrain selected --gradient-weight 1e-2");
  const std::string text = contents(folder / "out.ply");
  for(const char* line : {"property double x\n", "property float nx\n", "property uchar red\n", "property int selected\n",
                          "property float quality\n", "property int part\n"})
    GDP_CHECK(text.find(line) != std::string::npos);
  const Mesh out = read_ply("out.ply");
  const auto selected = existing_map<Mesh::Vertex_index, std::int32_t>(out, "v:selected");
  const auto quality = existing_map<Mesh::Vertex_index, float>(out, "v:quality");
  const auto part = existing_map<Mesh::Face_index, std::int32_t>(out, "f:part");
  const auto color = existing_map<Mesh::Vertex_index, CGAL::IO::Color>(out, "v:color");
  std::size_t kept = 0, moved = 0;
  for(auto v : mesh.vertices())
  {
    const bool is_selected = mesh.point(v).x() > 0, is_moved = mesh.point(v) != out.point(v);
    GDP_CHECK(get(selected, v) == int(is_selected));
    GDP_CHECK(get(quality, v) == float(std::size_t(v)) / 2);
    GDP_CHECK(get(color, v) == CGAL::IO::Color(std::size_t(v) % 3 == 0 ? 255 : 0, (unsigned char)((std::size_t(v) * 7) % 256), 128));
    GDP_CHECK(!(is_selected && is_moved)); // to the bit
    kept += is_selected;
    moved += is_moved;
  }
  for(auto f : mesh.faces())
    GDP_CHECK(get(part, f) == int(std::size_t(f)));
  GDP_CHECK(kept > 0 && kept + moved == mesh.number_of_vertices());

  // a region moves inside of itself only
  check_succeeds("properties.ply out.ply --region selected --gradient-weight 1e-2");
  const Mesh region = read_ply("out.ply");
  moved = 0;
  for(auto v : mesh.vertices())
  {
    GDP_CHECK(mesh.point(v).x() > 0 || mesh.point(v) == region.point(v));
    moved += mesh.point(v) != region.point(v);
  }
  GDP_CHECK(moved > 0);

  // masks: a constant one is the number itself
  check_succeeds("properties.ply out.ply --value-weight-property alpha_weight");
  const Mesh masked = read_ply("out.ply");
  check_succeeds("properties.ply out.ply");
  GDP_CHECK(largest_difference(masked, read_ply("out.ply")) > 1e-6);

  // colors are rounded and clamped; the positions stay
  check_succeeds("properties.ply out.ply --signal color --gradient-scale 6 --gradient-weight 1e-2");
  const Mesh sharp = read_ply("out.ply");
  GDP_CHECK(largest_difference(sharp, mesh) == 0);
  const auto sharp_color = existing_map<Mesh::Vertex_index, CGAL::IO::Color>(sharp, "v:color");
  std::size_t clamped = 0;
  for(auto v : mesh.vertices())
  {
    const int red = get(sharp_color, v).red();
    GDP_CHECK(get(sharp_color, v).blue() == 128);
    GDP_CHECK((std::size_t(v) % 3 == 0) == (red > 127)); // wrapped ones would be anywhere
    clamped += red == 0 || red == 255;
  }
  GDP_CHECK(clamped > 0);

  // constant normals stay as they are, without being normalized
  check_succeeds("properties.ply out.ply --signal normal");
  const Mesh normals = read_ply("out.ply");
  const auto normal = existing_map<Mesh::Vertex_index, Kernel::Vector_3>(normals, "v:normal");
  for(auto v : mesh.vertices())
    GDP_CHECK(get(normal, v) == Kernel::Vector_3(0, 0.5, 0.25));

  // normals and colors go through the formats that can hold them
  for(const char* file : {"a.off", "a.obj"})
  {
    check_succeeds("properties.ply " + std::string(file) + " --gradient-weight 0");
    check_succeeds(std::string(file) + " out.ply --signal color --gradient-scale 1");
    const Mesh back = read_ply("out.ply");
    const auto back_normal = existing_map<Mesh::Vertex_index, Kernel::Vector_3>(back, "v:normal");
    for(auto v : back.vertices())
      GDP_CHECK(get(back_normal, v) == Kernel::Vector_3(0, 0.5, 0.25));
    GDP_CHECK(contents(folder / "out.ply").find("red") != std::string::npos);
    fs::remove(folder / file);
  }

  check_succeeds("mesh.off out.ply --signal curvature");
  GDP_CHECK(contents(folder / "out.ply").find("property double curvature\n") != std::string::npos);
  fs::remove(folder / "out.ply");
}

void test_other_operations(const Mesh& mesh)
{
  for(const char* options : {"--operation enhance-details", "--operation enhance-details --metric edge-aware", "--signal normal-to-position",
                             "--metric anisotropic --curvature normals", "--metric preserve-convex --jet-degree 3 --iterations 2",
                             "--metric preserve-concave", "--curvature-weight 0.1", "--border fixed", "--border along-border",
                             "--area-normalization off", "--threads 1", "--restore-volume"})
  {
    check_succeeds("mesh.off out.ply " + std::string(options));
    GDP_CHECK(largest_difference(read_ply("out.ply"), mesh) > 1e-9);
  }
  write(folder / "quad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  check_succeeds("quad.off out.ply --triangulate");
  GDP_CHECK(read_ply("out.ply").number_of_faces() == 2);

  // polygons that are not convex, one with many corners, and what the faces know of themselves
  write(folder / "concave.ply",
        "ply\nformat ascii 1.0\nelement vertex 14\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 3\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n"
        "0 0 0\n4 0 0\n4 1 0\n1 1 0\n1 4 0\n0 4 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n2 5 0\n2 6 0\n1 5.2 0\n3 5.2 0\n"
        "6 0 1 2 3 4 5 7\n4 6 7 8 9 8\n4 12 10 13 11 9\n");
  check_succeeds("concave.ply out.ply --triangulate --gradient-weight 0");
  const Mesh split = read_ply("out.ply");
  const auto part = existing_map<Mesh::Face_index, std::int32_t>(split, "f:part");
  double area[3] = {0, 0, 0};
  for(auto f : split.faces())
  {
    const auto h = split.halfedge(f);
    const Kernel::Point_3 p = split.point(split.source(h)), q = split.point(split.target(h)), r = split.point(split.target(split.next(h)));
    const double z = CGAL::cross_product(q - p, r - p).z() / 2;
    GDP_CHECK(z > 0 && get(part, f) >= 7 && get(part, f) <= 9);
    area[(get(part, f) - 7) % 3] += z;
  }
  GDP_CHECK(split.number_of_faces() == 8);
  GDP_CHECK_NEAR(area[0], 7, 1e-12);
  GDP_CHECK_NEAR(area[1], 1, 1e-12);
  GDP_CHECK_NEAR(area[2], 1, 1e-12);
  std::ostringstream star;
  star << "OFF\n2000 1 0\n";
  for(int i = 0; i < 2000; ++i)
    star << (i % 2 ? 1 : 0.3) * std::cos(i * 0.00314159265358979) << " " << (i % 2 ? 1 : 0.3) * std::sin(i * 0.00314159265358979) << " 0\n";
  star << "2000";
  for(int i = 0; i < 2000; ++i)
    star << " " << i;
  write(folder / "star.off", star.str());
  check_succeeds("star.off out.ply --triangulate --gradient-weight 0");
  double star_area = 0;
  const Mesh split_star = read_ply("out.ply");
  for(auto f : split_star.faces())
  {
    const auto h = split_star.halfedge(f);
    const Kernel::Point_3 p = split_star.point(split_star.source(h)), q = split_star.point(split_star.target(h)),
                          r = split_star.point(split_star.target(split_star.next(h)));
    star_area += std::abs(CGAL::cross_product(q - p, r - p).z()) / 2;
  }
  GDP_CHECK_NEAR(star_area, 1000 * 0.3 * std::sin(0.00314159265358979), 1e-5);

  // two faces that have the shorter diagonal in common: only one can have it
  write(folder / "diagonal.off", "OFF\n6 2 0\n0 0 0\n1 2 0\n2 0 0\n1 -2 0\n1 1 3\n1 1 -3\n4 0 1 2 3\n4 0 4 2 5\n");
  const Outcome diagonal = run("diagonal.off out.ply --triangulate");
  GDP_CHECK(diagonal.code == 1 && is_one_line(diagonal.err)); // two corners that join faces without an edge
  write(folder / "pillow.off", "OFF\n4 2 0\n0 0 0\n1 2 0\n2 0 0\n1 -2 0\n4 0 1 2 3\n4 3 2 1 0\n");
  check_succeeds("pillow.off out.ply --triangulate");
  GDP_CHECK(read_ply("out.ply").number_of_faces() == 4);
  write(folder / "fan.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  check_succeeds("fan.off out.ply --repair");
  GDP_CHECK(read_ply("out.ply").number_of_faces() == 3);
  write(folder / "strip.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                              "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n");
  check_succeeds("strip.ply out.ply");
  GDP_CHECK(read_ply("out.ply").number_of_faces() == 2);
  for(const char* name : {"quad.off", "concave.ply", "star.off", "diagonal.off", "pillow.off", "fan.off", "strip.ply", "out.ply"})
    fs::remove(folder / name);
}

// Just enough of JSON to know that a text is it.
class Json
{
  const std::string& m_text;
  std::size_t m_at = 0;

public:
  explicit Json(const std::string& text) : m_text(text) {}
  bool is_valid() { return value() && (space(), m_at == m_text.size()); }

private:
  void space() { while(m_at < m_text.size() && std::isspace((unsigned char)m_text[m_at])) ++m_at; }
  bool take(char c) { space(); return m_at < m_text.size() && m_text[m_at] == c ? (++m_at, true) : false; }
  bool string()
  {
    if(!take('"'))
      return false;
    for(; m_at < m_text.size() && m_text[m_at] != '"'; ++m_at)
    {
      if((unsigned char)m_text[m_at] < 0x20)
        return false;
      if(m_text[m_at] == '\\')
        ++m_at;
    }
    return take('"');
  }
  bool value()
  {
    space();
    if(m_text.compare(m_at, 4, "null") == 0)
      return m_at += 4, true;
    if(m_at < m_text.size() && m_text[m_at] == '"')
      return string();
    if(take('{'))
    {
      do
        if(!string() || !take(':') || !value())
          return false;
      while(take(','));
      return take('}');
    }
    char* end = nullptr;
    const double x = std::strtod(m_text.c_str() + m_at, &end);
    const bool is_number = end != m_text.c_str() + m_at && std::isfinite(x);
    m_at = std::size_t(end - m_text.c_str());
    return is_number;
  }
};

void test_denoise(const Mesh& mesh)
{
  Mesh noisy = mesh;
  for(Mesh::Vertex_index v : noisy.vertices())
  {
    const double amount = 0.03 * std::sin(1e4 * int(v) + 1);
    const Kernel::Point_3 p = noisy.point(v);
    noisy.point(v) = Kernel::Point_3((1 + amount) * p.x(), (1 + amount) * p.y(), (1 + amount) * p.z());
  }
  std::ofstream stream(folder / "noisy.off");
  stream.precision(17);
  CGAL::IO::write_OFF(stream, noisy);
  stream.close();

  // the passes that are named are run; without a name their number comes from the data
  for(unsigned int passes : {1u, 3u})
  {
    Mesh expected = noisy;
    GDP_CHECK(GDP::denoise(expected, GDP::parameters::number_of_iterations(passes)) == GDP::OK);
    check_succeeds("noisy.off out.ply --operation denoise --passes " + std::to_string(passes));
    GDP_CHECK(largest_difference(read_ply("out.ply"), expected) < 1e-9);
    GDP_CHECK(largest_difference(expected, noisy) > 1e-3);
  }
  Mesh expected = noisy;
  GDP_CHECK(GDP::denoise(expected) == GDP::OK);
  check_succeeds("noisy.off out.ply --operation denoise");
  GDP_CHECK(largest_difference(read_ply("out.ply"), expected) < 1e-9);
  GDP_CHECK(largest_difference(expected, noisy) > 1e-3);
  check_fails("noisy.off out.ply --passes 3", 2, "denoise");
  check_fails("noisy.off out.ply --operation denoise --passes 0", 2, "passes");
  check_fails("noisy.off out.ply --operation denoise --gradient-weight 1", 2, "contradicts");
  fs::remove(folder / "noisy.off");
  fs::remove(folder / "out.ply");
}

void test_report(const Mesh& mesh)
{
  check_succeeds("mesh.off 'a\"b.ply' --report report.json --metric edge-aware");
  const std::string report = contents(folder / "report.json");
  GDP_CHECK(Json(report).is_valid());
  for(const char* key : {"vertices", "edges", "faces", "area", "solver", "matrix_non_zeros", "factor_non_zeros", "max_displacement",
                         "mean_displacement", "seconds", "read", "validate", "curvature", "metric", "analyze", "assemble", "factor", "solve",
                         "write", "total", "peak_memory_bytes"})
    GDP_CHECK(report.find("\"" + std::string(key) + "\": ") != std::string::npos);
  GDP_CHECK(report.find("\"vertices\": " + std::to_string(mesh.number_of_vertices()) + ",") != std::string::npos);
  GDP_CHECK(report.find("\"faces\": " + std::to_string(mesh.number_of_faces()) + ",") != std::string::npos);
  fs::remove(folder / "report.json");
  fs::remove(folder / "a\"b.ply");
  const Outcome outcome = run("mesh.off out.ply --verbose");
  GDP_CHECK(outcome.code == 0 && outcome.err.empty());
  GDP_CHECK(outcome.out.find("wrote out.ply") != std::string::npos);
  fs::remove(folder / "out.ply");
}

} // namespace

int main(int argc, char* argv[])
{
  const char* const name = argc > 1 ? argv[1] : std::getenv("GRADIENT_DOMAIN_FILTER");
  if(!GDP_CHECK(name != nullptr))
    return GDP_TEST_RESULT();
  program = fs::absolute(name).string();
  if(!GDP_CHECK(fs::is_regular_file(program)))
  {
    std::cerr << "  " << program << " is not there" << std::endl;
    return GDP_TEST_RESULT();
  }
  folder = fs::temp_directory_path() / ("test_filter_program_" + std::to_string(std::random_device()()));
  fs::create_directory(folder);
  try
  {
    fs::copy_file("data/ellipsoid.off", folder / "mesh.off");
    const Mesh mesh = read_off(folder / "mesh.off");
    write(folder / "properties.ply", ply_with_properties(mesh));

    test_usage();
    test_bad_files(mesh);
    test_no_room();
    test_result(mesh);
    test_properties(mesh);
    test_other_operations(mesh);
    test_denoise(mesh);
    test_report(mesh);

    GDP_CHECK(number_of_files() == 2); // nothing is left behind
  }
  catch(const std::exception& error) // what follows would make no sense
  {
    std::cerr << error.what() << std::endl;
    GDP_CHECK(false);
  }
  fs::remove_all(folder);
  return GDP_TEST_RESULT();
}
