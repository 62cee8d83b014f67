// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// gradient_domain_filter from outside: exit codes, messages, files. The program is named by the environment variable
// GRADIENT_DOMAIN_FILTER or the first argument.

#include "test_random_files.h"
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
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
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
  const std::string command =
    "cd \"" + folder.string() + "\" && { " + before + " \"" + program + "\" " + arguments + "; } >stdout 2>stderr";
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
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n'
         && text.compare(0, 24, "gradient_domain_filter: ") == 0;
}

// One line that names `what`, the right code, and no trace in the folder.
void check_fails(const std::string& arguments, int code, const std::string& what,
                 const std::string& before = std::string())
{
  const std::size_t files = number_of_files();
  const Outcome outcome = run(arguments, before);
  const bool holds = outcome.code == code && is_one_line(outcome.err) && outcome.err.find(what) != std::string::npos
                     && outcome.out.empty() && number_of_files() == files;
  if(!GDP_CHECK(holds))
    std::cerr << "  " << arguments << ": exit " << outcome.code << ", " << outcome.err << std::endl;
}

// `said`: what is in the lines on the standard error, one string for each of them in turn.
void check_succeeds(const std::string& arguments, const std::vector<std::string>& said = {})
{
  const Outcome outcome = run(arguments);
  std::istringstream lines(outcome.err);
  bool holds = outcome.code == 0;
  std::string line;
  for(const std::string& what : said)
    holds = holds && std::getline(lines, line) && is_one_line(line + "\n") && line.find(what) != std::string::npos;
  if(!GDP_CHECK(holds && !std::getline(lines, line)))
    std::cerr << "  " << arguments << ": exit " << outcome.code << ", " << outcome.err << std::endl;
}

// Nothing is filtered; the rest of `said` follows.
void check_copies(const std::string& files, std::vector<std::string> said = {})
{
  said.insert(said.begin(), "nothing has changed: the gradient weight is 0");
  check_succeeds(files + " --gradient-weight 0", said);
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
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float ny\nproperty "
         "float nz\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int selected\nproperty float "
         "quality\nproperty double alpha_weight\n"
         "element face "
      << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n";
  int i = 0;
  for(auto v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    out << p.x() << " " << p.y() << " " << p.z() << " 0 0.5 0.25 " << (i % 3 == 0 ? 255 : 0) << " " << (i * 7) % 256
        << " 128 " << (p.x() > 0) << " " << i * 0.5 << " " << 1 + i % 2 << "\n";
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
  check_fails("scene.glb out.ply", 2, "scene.glb: glTF is not read or written here; convert it to PLY or OBJ");
  check_fails("mesh.off out.3mf", 2, "out.3mf: 3MF is not read or written here");
  check_fails("part.vtp out.ply", 2, "part.vtp: VTP is not read or written here");
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
  check_fails("mesh.off out.off --signal quality", 2, "PLY only");
  check_fails("mesh.off out.ply --signal a,a", 2, "twice");
  check_fails("mesh.off out.ply --signal a,,b", 2, "empty name");
  check_fails("mesh.off out.ply --signal normal --axes z", 2, "axes");
  check_fails("mesh.off out.ply --axes xx", 2, "axes");
  check_fails("mesh.off out.ply --axes w", 2, "axes");
  check_fails("mesh.off out.ply --signal color --keep-normals", 2, "keep-normals");
  check_fails("mesh.off out.ply --missing-values", 2, "missing-values");
  check_fails("mesh.off out.ply --max-displacement -1", 2, "max-displacement");
  check_fails("mesh.off out.ply --weld-tolerance nan", 2, "weld-tolerance");
  check_fails("mesh.off out.ply --weld-tolerance 0 --no-weld", 2, "contradicts");
  check_fails("mesh.off out.ply --non-shrinking 0", 2, "non-shrinking");
  check_fails("mesh.off out.ply --non-shrinking --gradient-scale 2", 2, "contradicts");
  check_fails("mesh.off out.ply --operation denoise --non-shrinking", 2, "contradicts");
  check_fails("mesh.off out.ply --noise-level 0.1", 2, "denoise");
  check_fails("mesh.off out.ply --operation denoise --noise-scale -1", 2, "noise-scale");
  check_fails("mesh.off out.ply --operation denoise --solver cg", 2, "contradicts");
  check_fails("mesh.off out.ply --picture out.ply", 2, "--picture is a file of its own");
  check_fails("mesh.off out.ply --picture -", 2, "--picture is a file of its own");
  check_fails("mesh.off out.ply --signal curvature --picture out.png", 2, "--picture needs");
  check_fails("mesh.off out.ply --operation denoise --value-weight 0", 2, "--value-weight");
  check_fails("mesh.off out.ply --normal-fit edges", 2, "normal-to-position");
  check_fails("mesh.off out.ply --precision half", 2, "single, double");
  check_fails("mesh.off out.ply --input-format xyz", 2, "input-format");
  check_fails("mesh.off - --report -", 2, "report");
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
  fails("bad.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no faces");
  fails("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "face 0 has 2 corners");
  fails("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1\n", "face 1 has 1 corner\n");
  write(folder / "quads.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex "
                              "0 1 0\nendloop\nendfacet\nendsolid\n");
  check_copies("quads.stl copy.stl");
  GDP_CHECK(contents(folder / "copy.stl") == contents(folder / "quads.stl"));
  check_fails("quads.stl out.stl --binary", 1, "face 0 has 4 corners");
  fs::remove(folder / "quads.stl");
  fs::remove(folder / "copy.stl");
  write(folder / "quad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  check_fails("quad.off out.stl", 1, "face 0 has 4 corners");
  check_fails("mesh.off out.stl --binary --precision double", 1, "single precision");
  fs::remove(folder / "quad.off");
  fails("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4");
  fails("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4");
  fails("bad.obj", "f 1 2 -9223372036854775808\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "line 1: a face has a vertex");
  fails("bad.obj", "f -9223372036854775808 -9223372036854775808 -9223372036854775808\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
        "line 1: a face has a vertex");
  fails("bad.stl", std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(50, ' '), "STL");

  const std::string head = "ply\nformat binary_little_endian 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  fails("bad.ply", head + "element vertex 99999999999\n" + xyz + "end_header\n", "do not fit");
  fails("bad.ply", head + "element vertex 99999999999\nend_header\n", "without a property");
  fails("bad.ply", head + "element vertex -1\n" + xyz + "end_header\n", "header");
  fails("bad.ply", head + "element vertex 1\nproperty quad x\nend_header\n", "quad");
  fails("bad.ply",
        head + "element vertex 1\n" + xyz + "element face 1\nproperty list uchar float vertex_indices\nend_header\n"
          + std::string(30, '\0'),
        "list of integers");
  fails("bad.ply",
        head + "element vertex 1\n" + xyz + "element face 1\nproperty list uint int vertex_indices\nend_header\n"
          + std::string(12, '\0') + "\xff\xff\xff\xff",
        "ends");

  // truncated at every kilobyte
  for(const char* arguments :
      {"whole.ply --binary", "whole.ply --ascii", "whole.stl --binary", "whole.stl --ascii", "whole.off"})
  {
    const std::string words(arguments), name = words.substr(0, words.find(' ')),
                                        extension = name.substr(name.find('.'));
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
    GDP_CHECK(outcome.code == 0 ? outcome.err.find("cut.obj: face") == std::string::npos
                                : outcome.code == 1 && is_one_line(outcome.err));
    fs::remove(folder / "cut.obj");
    fs::remove(folder / "cut.ply");
  }
  GDP_CHECK(contents(folder / "out.ply") == "as it was");
  fs::remove(folder / "out.ply");
  check_fails("properties.ply out.ply --constrain nothing", 1, "'nothing'");
  check_fails("mesh.off out.ply --signal color", 1, "no vertex colors, as red, green and blue; there are: none");
  check_fails("mesh.off out.ply --value-weight 0", 1, "mesh.off: ");
  GDP_CHECK(mesh.number_of_faces() > 0);
}

// Files of several blocks: lines that go on at their boundary, indices into the blocks before, the line of a mistake.
void test_blocks()
{
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  while(obj.size() < (std::size_t(5) << 19))
    obj += "# no number\n";
  const std::string comments = std::to_string(std::count(obj.begin(), obj.end(), '#')) + " comments";
  obj += "f -1 -2 -3\n";
  write(folder / "long.obj", obj);
  check_copies("long.obj out.off", {"not kept: " + comments});
  GDP_CHECK(contents(folder / "out.off").find("\n3 2 1 0\n") != std::string::npos);
  obj += "f 1 2 -4\nf 1 2 x\n";
  write(folder / "long.obj", obj);
  fs::remove(folder / "out.off");
  check_fails("long.obj out.off", 1, "line " + std::to_string(std::count(obj.begin(), obj.end(), '\n') - 1) + ": ");

  // one line with many breaks
  std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  while(corners.size() < (std::size_t(5) << 19))
    corners += " \\\r\n";
  write(folder / "long.obj", corners + "1 2 3\n");
  check_copies("long.obj out.off");
  GDP_CHECK(contents(folder / "out.off").find("\n3 0 1 2\n") != std::string::npos);
  fs::remove(folder / "long.obj");
  fs::remove(folder / "out.off");
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
  GDP_CHECK(GDP::smooth(expected, GDP::parameters::gradient_weight(1e-3).gradient_scale(0.5)) == GDP::ok);
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
    check_copies("out.off " + arguments);
    check_copies(file + " back.off");
    GDP_CHECK(largest_difference(read_off(folder / "back.off"), written) == 0);
    fs::remove(folder / file);
  }
  check_copies("out.off a.stl"); // orders the vertices anew
  check_copies("a.stl b.stl --binary");
  check_copies("b.stl back.off");
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
  for(const char* line : {"property double x\n", "property float nx\n", "property uchar red\n",
                          "property int selected\n", "property float quality\n", "property int part\n"})
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
    GDP_CHECK(get(color, v)
              == CGAL::IO::Color(std::size_t(v) % 3 == 0 ? 255 : 0, (unsigned char)((std::size_t(v) * 7) % 256), 128));
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
  check_succeeds("properties.ply out.ply --signal normal", {"nothing has changed"});
  const Mesh normals = read_ply("out.ply");
  const auto normal = existing_map<Mesh::Vertex_index, Kernel::Vector_3>(normals, "v:normal");
  for(auto v : mesh.vertices())
    GDP_CHECK(get(normal, v) == Kernel::Vector_3(0, 0.5, 0.25));

  // normals and colors go through the formats that can hold them
  for(const char* file : {"a.off", "a.obj"})
  {
    check_copies("properties.ply " + std::string(file),
                 {"not kept: 1 comment, the properties selected, quality, alpha_weight of vertices, "
                  "the property part of faces"});
    check_succeeds(std::string(file) + " out.ply --signal color --gradient-scale 2");
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
  for(const char* options :
      {"--operation enhance-details", "--operation enhance-details --metric edge-aware",
       "--signal normal-to-position --gradient-weight 1e-3", "--signal normal-to-position --normal-fit edges",
       "--metric anisotropic --curvature normals", "--metric preserve-convex --jet-degree 3 --iterations 2",
       "--metric preserve-concave", "--curvature-weight 0.1", "--border fixed", "--border along-border",
       "--area-normalization off", "--threads 1", "--restore-volume"})
  {
    check_succeeds("mesh.off out.ply " + std::string(options));
    GDP_CHECK(largest_difference(read_ply("out.ply"), mesh) > 1e-9);
  }
  write(
    folder / "strip.ply",
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n");
  check_succeeds("strip.ply out.off");
  GDP_CHECK(read_off(folder / "out.off").number_of_faces() == 2);
  for(const char* name : {"strip.ply", "out.off", "out.ply"})
    fs::remove(folder / name);
}

// A plate with a bump in the middle, which is the region.
std::string plate_with_bump()
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex 81\nproperty double x\nproperty double y\nproperty double "
                     "z\nproperty int r\n"
                     "element face 64\nproperty list uchar int vertex_indices\nend_header\n";
  for(int i = 0; i < 9; ++i)
    for(int j = 0; j < 9; ++j)
    {
      const bool is_inside = i > 2 && i < 6 && j > 2 && j < 6;
      text += std::to_string(i) + " " + std::to_string(j) + (is_inside ? " 2 1\n" : " 0 0\n");
    }
  for(int i = 0; i < 8; ++i)
    for(int j = 0; j < 8; ++j)
      text += "4 " + std::to_string(9 * i + j) + " " + std::to_string(9 * i + 9 + j) + " "
              + std::to_string(9 * i + 10 + j) + " " + std::to_string(9 * i + 1 + j) + "\n";
  return text;
}

// Every face with corners of its own.
std::string soup_of(const Mesh& mesh)
{
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << 3 * mesh.number_of_faces() << " " << mesh.number_of_faces() << " 0\n";
  for(auto f : mesh.faces())
    for(auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << mesh.point(v) << "\n";
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    out << "3 " << 3 * f << " " << 3 * f + 1 << " " << 3 * f + 2 << "\n";
  return out.str();
}

// Fair patches, bands of waves, harmonics, second derivatives.
void test_beyond_the_paper(const Mesh& mesh)
{
  write(folder / "plate.ply", plate_with_bump());
  check_succeeds("plate.ply out.ply --operation fair --region-vertices r");
  const Mesh plate = read_ply("plate.ply"), fair = read_ply("out.ply");
  for(auto v : plate.vertices())
    if(plate.point(v).z() == 0)
      GDP_CHECK(fair.point(v) == plate.point(v));
    else
      GDP_CHECK_NEAR(fair.point(v).z(), 0, 1e-6);
  check_succeeds("plate.ply out.ply --operation fair --constrain r --report report.json");
  const Mesh around = read_ply("out.ply"); // the bump stays
  for(auto v : plate.vertices())
    if(plate.point(v).z() != 0)
      GDP_CHECK(around.point(v) == plate.point(v));
  GDP_CHECK(largest_difference(around, plate) > 0.1);
  GDP_CHECK(contents(folder / "report.json").find("\"solver\": \"ch") != std::string::npos
            || contents(folder / "report.json").find("\"solver\": \"eigen\"") != std::string::npos);
  fs::remove(folder / "report.json");
  check_succeeds("plate.ply out.ply --value-weight 0 --constrain r", {"spanned like a soap film"});
  check_fails("plate.ply out2.ply --operation fair", 2, "--region-vertices");
  check_fails("plate.ply out2.ply --operation fair --region-vertices nothing", 1, "nothing");
  check_fails("plate.ply out2.ply --operation fair --region-vertices r --gradient-weight 1", 2, "gradient-weight");

  // all waves are in one of two bands, or in both
  check_succeeds("mesh.off low.ply --operation low-pass --wavelengths 0.5");
  check_succeeds("mesh.off high.ply --operation high-pass --wavelengths 0.5 --order 4");
  const Mesh low = read_ply("low.ply"), high = read_ply("high.ply");
  double most = 0;
  for(auto v : mesh.vertices())
    most = (std::max)(
      most, std::sqrt(((low.point(v) - CGAL::ORIGIN) + (high.point(v) - CGAL::ORIGIN) - (mesh.point(v) - CGAL::ORIGIN))
                        .squared_length()));
  GDP_CHECK_NEAR(most, 0, 1e-6);
  GDP_CHECK(largest_difference(low, mesh) > 1e-9 && largest_difference(high, mesh) > 1e-2);
  check_succeeds("mesh.off out.ply --operation band-pass --wavelengths 0.5,2 --metric edge-aware");
  check_succeeds("mesh.off out.ply --operation band-stop --wavelengths 2,0.5");
  check_fails("mesh.off out2.ply --operation band-pass --wavelengths 0.5", 2, "two numbers");
  check_fails("mesh.off out2.ply --operation low-pass --wavelengths 0.5,1", 2, "one number");
  check_fails("mesh.off out2.ply --operation low-pass", 2, "--wavelengths");
  for(const char* wrong : {"0", "-1", "x", "1,", "1,2,3", "1;2", "inf"})
    check_fails("mesh.off out2.ply --operation low-pass --wavelengths '" + std::string(wrong) + "'", 2,
                "--wavelengths");
  check_fails("mesh.off out2.ply --wavelengths 1", 2, "wavelengths");

  // windows: what one filter keeps the other removes; they are other than Butterworth's
  check_succeeds("mesh.off low.ply --operation band-pass --wavelengths 0.5,2 --window nuttall --degree 30");
  check_succeeds("mesh.off high.ply --operation band-stop --wavelengths 2,0.5 --window nuttall --degree 30");
  const Mesh passed = read_ply("low.ply"), stopped = read_ply("high.ply");
  most = 0;
  for(auto v : mesh.vertices())
    most = (std::max)(most, std::sqrt(((passed.point(v) - CGAL::ORIGIN) + (stopped.point(v) - CGAL::ORIGIN)
                                       - (mesh.point(v) - CGAL::ORIGIN)).squared_length()));
  GDP_CHECK_NEAR(most, 0, 1e-6);
  GDP_CHECK(largest_difference(stopped, mesh) > 1e-2 && largest_difference(stopped, read_ply("out.ply")) > 1e-6);
  check_succeeds("mesh.off high.ply --operation high-pass --wavelengths 0.5 --window hann");
  GDP_CHECK(largest_difference(high, read_ply("high.ply")) > 1e-9);
  check_fails("mesh.off out2.ply --operation low-pass --wavelengths 1 --window box", 2, "nuttall");
  check_fails("mesh.off out2.ply --operation low-pass --wavelengths 1 --window hann --order 3", 2, "order");
  check_fails("mesh.off out2.ply --operation low-pass --wavelengths 1 --degree 3", 2, "--window");
  check_fails("mesh.off out2.ply --window hann", 2, "low-pass");

  check_succeeds("mesh.off out.ply --operation spectrum --count 5 --eigenvalues e.csv");
  const std::string table = contents(folder / "e.csv");
  GDP_CHECK(table.compare(0, 19, "index,eigenvalue\n0,") == 0 && std::count(table.begin(), table.end(), '\n') == 6);
  GDP_CHECK_NEAR(std::stod(table.substr(19)), 0, 1e-8);
  GDP_CHECK(contents(folder / "out.ply").find("property double harmonic_4\n") != std::string::npos);
  GDP_CHECK(largest_difference(read_ply("out.ply"), mesh) == 0);
  write(folder / "soup.off", soup_of(mesh));
  check_succeeds("soup.off out.ply --operation spectrum --count 5 --eigenvalues soup.csv",
                 {"vertices at seams were welded to others"});
  std::istringstream whole(table), welded(contents(folder / "soup.csv"));
  for(std::string a, b; std::getline(whole, a) && std::getline(welded, b);)
    if(a[0] != 'i')
      GDP_CHECK_NEAR(std::stod(a.substr(2)), std::stod(b.substr(2)), 1e-6);
  check_succeeds("soup.off out.ply --operation spectrum --count 2 --no-weld", {"border vertices at the same place"});
  fs::remove(folder / "soup.off");
  fs::remove(folder / "soup.csv");
  // the five lowest are nearest to what is below all; one that is nearest to the third is that
  check_succeeds("mesh.off out.ply --operation spectrum --count 5 --shift -1 --eigenvalues shifted.csv");
  std::istringstream lowest(table), shifted(contents(folder / "shifted.csv"));
  std::string third;
  for(std::string a, b; std::getline(lowest, a) && std::getline(shifted, b);)
    if(a[0] != 'i')
    {
      GDP_CHECK_NEAR(std::stod(a.substr(2)), std::stod(b.substr(2)), 1e-6);
      third = a[0] == '2' ? a.substr(2) : third;
    }
  check_succeeds("mesh.off out.ply --operation spectrum --count 1 --shift " + third + " --eigenvalues shifted.csv");
  GDP_CHECK_NEAR(std::stod(contents(folder / "shifted.csv").substr(19)), std::stod(third), 1e-6);
  fs::remove(folder / "shifted.csv");
  check_fails("mesh.off out2.ply --operation spectrum --shift inf", 2, "shift");
  check_fails("mesh.off out2.ply --shift 3", 2, "--operation spectrum");
  check_fails("mesh.off out.off --operation spectrum", 2, "PLY");
  check_fails("mesh.off out2.ply --operation spectrum --eigenvalues mesh.off", 2, "input");
  check_fails("mesh.off out2.ply --operation spectrum --eigenvalues ./out2.ply", 2, "output");
  check_fails("mesh.off out2.ply --operation spectrum --eigenvalues r.json --report r.json", 2, "report");
  check_fails("mesh.off out2.ply --operation spectrum --count 100000", 1, "mesh.off");

  check_succeeds("mesh.off out.ply --gradient-weight 0 --hessian-weight 1e-6");
  GDP_CHECK(largest_difference(read_ply("out.ply"), mesh) > 1e-9);
  check_fails("mesh.off out2.ply --hessian-weight -1", 2, "hessian-weight");
  for(const char* name : {"plate.ply", "out.ply", "low.ply", "high.ply", "e.csv"})
    fs::remove(folder / name);
}

// Any polygons, connected in any way; order and number of all stay.
void test_any_surface()
{
  const struct { const char* name; const char* said; const char* first_face; const char* text;
  } surfaces[] = {
    {"fan.off", "fan.off: 1 edge with more than two faces, which stay together", "\n3 0 1 2\n",
     "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n3 0 1 2\n3 1 0 3\n3 0 1 4\n"},
    {"umbrellas.off", "umbrellas.off: 1 face without area", "\n3 0 1 2\n",
     "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n3 0 1 2\n3 0 3 4\n"},
    {"turned.off", "turned.off: 1 edge between faces of which one is turned over", "\n3 0 1 2\n",
     "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n"},
    {"polygons.off", nullptr, "\n4 0 1 2 3\n",
     "OFF\n7 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n2 0 1\n2 1 1\n3 0.5 0\n4 0 1 2 3\n5 1 4 6 5 2\n3 3 2 5\n"}};
  for(const auto& surface : surfaces)
  {
    const std::string name = surface.name, text = surface.text;
    write(folder / name, text);
    check_succeeds(name + " out.off",
                   surface.said ? std::vector<std::string>{surface.said} : std::vector<std::string>());
    check_succeeds(name + " out.off --quiet");
    const std::string out = contents(folder / "out.off");
    GDP_CHECK(out != text);
    GDP_CHECK(std::count(out.begin(), out.end(), '\n') == std::count(text.begin(), text.end(), '\n'));
    const std::string faces = text.substr(text.find(surface.first_face));
    GDP_CHECK(out.size() > faces.size() && out.substr(out.size() - faces.size()) == faces);
    fs::remove(folder / name);
  }

  // copies of a vertex at a border are one, unless they shall not be
  write(folder / "seam.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2\n3 3 5 4\n");
  const auto is_closed = [] {
    Mesh mesh = read_off(folder / "out.off");
    const auto point = [&](unsigned int v) { return mesh.point(Mesh::Vertex_index(v)); };
    return point(1) == point(3) && point(2) == point(4);
  };
  check_succeeds("seam.off out.off --gradient-weight 0.1", {"seam.off: 2 vertices at seams were welded to others"});
  GDP_CHECK(is_closed());
  check_succeeds("seam.off out.off --gradient-weight 0.1 --no-weld",
                 {"4 border vertices at the same place as others are not one"});
  GDP_CHECK(!is_closed());

  // a vertex that no face uses may be anything
  write(folder / "unused.off", "OFF\n5 2 0\nnan 0 inf\n0 0 0\n1 0 0\n1 1 1\n0 1 0\n3 1 2 3\n3 1 3 4\n");
  check_succeeds("unused.off out.off", {"unused.off: 1 vertex without a face stays as it is"});
  GDP_CHECK(contents(folder / "out.off").find("OFF\n5 2 0\nnan 0 inf\n") == 0);
  for(const char* name : {"seam.off", "unused.off", "out.off"})
    fs::remove(folder / name);
}

// Three sheets that meet in a line.
void test_lines()
{
  std::string text = "OFF\n20 24 0\n", faces;
  const auto row = [&](double x, double y, double shift) {
    for(int i = 0; i < 5; ++i)
      text += std::to_string(x) + " " + std::to_string(y + shift * (i % 2)) + " " + std::to_string(i) + "\n";
  };
  row(0, 0, 0.3);
  row(1, 0.2, 0);
  row(-1, 0.5, 0);
  row(-1, -1, 0);
  for(int sheet = 1; sheet < 4; ++sheet)
    for(int i = 0; i < 4; ++i)
      for(const auto& t :
          {std::vector<int>{i, i + 1, 5 * sheet + i}, std::vector<int>{i + 1, 5 * sheet + i + 1, 5 * sheet + i}})
        faces += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  write(folder / "lines.off", text + faces);
  const auto filtered = [&](const std::string& options) {
    check_succeeds("lines.off out.off --gradient-weight 0.1 " + options, {"4 edges with more than two faces"});
    std::vector<std::string> lines;
    std::istringstream in(contents(folder / "out.off"));
    for(std::string line; std::getline(in, line);)
      lines.push_back(line);
    return lines;
  };
  const auto free = filtered(""), fixed = filtered("--non-manifold fixed"),
             along = filtered("--non-manifold along-lines");
  std::vector<std::string> before;
  std::istringstream in(text);
  for(std::string line; std::getline(in, line);)
    before.push_back(line);
  for(std::size_t i = 2; i < 7; ++i)
    GDP_CHECK(fixed[i] == before[i] && along[i] != before[i] && free[i] != before[i] && along[i] != free[i]);
  for(std::size_t i = 7; i < 22; ++i)
    GDP_CHECK(fixed[i] != before[i] && along[i] != before[i] && fixed[i] != along[i]);
  for(std::size_t i = 2; i < 7; ++i) // a curve in a plane stays in it
    GDP_CHECK(along[i].compare(0, 9, "0.000000 ") == 0);
  check_fails("lines.off new.off --operation denoise --non-manifold along-lines", 2, "contradicts");
  fs::remove(folder / "lines.off");
  fs::remove(folder / "out.off");
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
    if(take('['))
    {
      if(take(']'))
        return true;
      do
        if(!value())
          return false;
      while(take(','));
      return take(']');
    }
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
    GDP_CHECK(GDP::denoise(expected, GDP::parameters::number_of_iterations(passes)) == GDP::ok);
    check_succeeds("noisy.off out.ply --operation denoise --passes " + std::to_string(passes));
    GDP_CHECK_NEAR(largest_difference(read_ply("out.ply"), expected), 0, 1e-6); // single precision
    GDP_CHECK(largest_difference(expected, noisy) > 1e-3);
  }
  Mesh expected = noisy;
  GDP_CHECK(GDP::denoise(expected) == GDP::ok);
  check_succeeds("noisy.off out.ply --operation denoise");
  GDP_CHECK_NEAR(largest_difference(read_ply("out.ply"), expected), 0, 1e-6); // single precision
  GDP_CHECK(largest_difference(expected, noisy) > 1e-3);
  check_succeeds("mesh.off out.ply --operation denoise --noise-level 0", {"nothing has changed: no noise was found"});
  check_fails("noisy.off out.ply --passes 3", 2, "denoise");
  check_fails("noisy.off out.ply --operation denoise --passes 0", 2, "passes");
  check_fails("noisy.off out.ply --operation denoise --gradient-weight 1", 2, "contradicts");
  fs::remove(folder / "noisy.off");
  fs::remove(folder / "out.ply");
}

// Two sheets of many vertices, three faces at an edge of the second and one of its faces turned over; a vertex without
// a face.
void test_survey_of_many()
{
  const int width = 130, sheet = width * width;
  std::string off;
  const auto corner = [&](int k, int i, int j) { return std::to_string(k * sheet + i * width + j) + " "; };
  int faces = 0;
  for(int k = 0; k < 2; ++k)
    for(int i = 0; i + 1 < width; ++i)
      for(int j = 0; j + 1 < width; ++j, ++faces)
      {
        const std::string a = corner(k, i, j), b = corner(k, i + 1, j), c = corner(k, i + 1, j + 1),
                          d = corner(k, i, j + 1);
        off += "4 " + (k == 1 && i == 126 && j == 64 ? d + c + b + a : a + b + c + d) + "\n";
      }
  off += "3 " + corner(1, 128, 5) + corner(1, 128, 6) + std::to_string(2 * sheet) + "\n";
  std::string points;
  for(int k = 0; k < 2; ++k)
    for(int v = 0; v < sheet; ++v)
      points += std::to_string(v / width) + " " + std::to_string(v % width) + " " + std::to_string(10 * k) + "\n";
  write(folder / "sheets.off", "OFF\n" + std::to_string(2 * sheet + 2) + " " + std::to_string(faces + 1) + " 0\n"
                                 + points + "128.5 5.5 12\n7 7 7\n" + off);
  const Outcome outcome = run("sheets.off out.off --report report.json --gradient-weight 1e-6");
  GDP_CHECK(outcome.code == 0);
  const std::string report = contents(folder / "report.json");
  const int edges = 2 * 2 * width * (width - 1) + 2, border = 2 * 4 * (width - 1) + 2;
  for(const std::string& said : {"\"edges\": " + std::to_string(edges), "\"border_edges\": " + std::to_string(border),
                                std::string("\"crowded_edges\": 1"), std::string("\"components\": 2")})
    GDP_CHECK(report.find(said + ",") != std::string::npos);
  GDP_CHECK(outcome.err.find("1 edge with more than two faces") != std::string::npos);
  GDP_CHECK(outcome.err.find("4 edges between faces of which one is turned over") != std::string::npos);
  GDP_CHECK(outcome.err.find("1 vertex without a face stays as it is") != std::string::npos);
  for(const char* name : {"sheets.off", "out.off", "report.json"})
    fs::remove(folder / name);
}

void test_report(const Mesh& mesh)
{
  check_succeeds("mesh.off 'a\"b.ply' --report report.json --metric edge-aware");
  const std::string report = contents(folder / "report.json");
  GDP_CHECK(Json(report).is_valid());
  for(const char* key : {"vertices",
                         "edges",
                         "faces",
                         "area",
                         "solver",
                         "matrix_non_zeros",
                         "factor_non_zeros",
                         "max_displacement",
                         "mean_displacement",
                         "seconds",
                         "read",
                         "validate",
                         "curvature",
                         "metric",
                         "analyze",
                         "assemble",
                         "factor",
                         "solve",
                         "write",
                         "total",
                         "peak_memory_bytes",
                         "gradient_weight",
                         "curvature_weight",
                         "components",
                         "remarks",
                         "not_kept"})
    GDP_CHECK(report.find("\"" + std::string(key) + "\": ") != std::string::npos);
  GDP_CHECK(report.find("\"vertices\": " + std::to_string(mesh.number_of_vertices()) + ",") != std::string::npos);
  GDP_CHECK(report.find("\"faces\": " + std::to_string(mesh.number_of_faces()) + ",") != std::string::npos);
  // the weights that an operation does not use are not there
  check_succeeds("mesh.off out.ply --report report.json --operation enhance-details");
  GDP_CHECK(contents(folder / "report.json").find("\"sharpening_weight\": ") != std::string::npos);
  GDP_CHECK(run("mesh.off out.ply --report report.json --operation denoise --passes 1").code == 0);
  const std::string denoised = contents(folder / "report.json");
  GDP_CHECK(Json(denoised).is_valid() && denoised.find("\"noise_level\": ") != std::string::npos);
  GDP_CHECK(denoised.find("\"passes\": 1,") != std::string::npos
            && denoised.find("\"gradient_weight\"") == std::string::npos);
  // and the solver is the one that solved
  GDP_CHECK(run("mesh.off out.ply --report report.json --solver cg --gradient-weight 1e-2").code == 0);
  GDP_CHECK(contents(folder / "report.json").find("\"solver\": \"cg\"") != std::string::npos);
  std::string strip = "OFF\n900 841 0\n";
  for(int v = 0; v < 900; ++v)
    strip += std::to_string(v / 30) + " " + std::to_string(1e-4 * (v % 30)) + " "
             + std::to_string((v * 7 % 10) * 0.01) + "\n";
  for(int v = 0; v < 870; ++v)
    if(v % 30 < 29)
      strip += "4 " + std::to_string(v) + " " + std::to_string(v + 30) + " " + std::to_string(v + 31) + " "
               + std::to_string(v + 1) + "\n";
  write(folder / "strip.off", strip);
  const Outcome turned = run("strip.off out.ply --report report.json --solver cg --gradient-weight 1e14");
  const bool is_by_cholesky = turned.err.find("is solved by Cholesky factorization") != std::string::npos;
  GDP_CHECK(turned.code == 0
            && is_by_cholesky == (contents(folder / "report.json").find("\"solver\": \"cg\"") == std::string::npos));
  fs::remove(folder / "strip.off");
  fs::remove(folder / "report.json");
  fs::remove(folder / "a\"b.ply");
  const Outcome outcome = run("mesh.off out.ply --verbose");
  GDP_CHECK(outcome.code == 0 && outcome.err.empty());
  GDP_CHECK(outcome.out.find("wrote out.ply") != std::string::npos);
  fs::remove(folder / "out.ply");
}

// A file of every format with all that such a file can have.
const char* const full_obj = "# a file\\\nmtllib  my mat.mtl\no thing\nv  0.0 0.00 0\t# c\nv 1.0 0.0 0.20 \\\n\r\nv 1 "
                             "\\\n 1.50 -0\nv 0 1 1e-0 0.5 0.25 1\n"
                             "vt 0 0\nvt 1 0.5\nvn 0 0 1\nvn 0 0.0 1.0\n\ng part one\nusemtl red\ns 1\nf 1/1/1 2/2/1 "
                             "3/1/1\nusemtl blue\nf 1//1 3//1 \\\n 4//2\nl 1 2\n";
const char* const full_off = "# c\nCNOFF # x\n\n4  2 0\n0 0 0.0 0 0 1 0.5 0.25 1.0\n1 0 0 0 0 1 1.0 0.0 0.0\r\n\n1 1 "
                             "1.50  0 0 1 0 1 0 # a\n0 1 0 0 0 1 0 1 0\n"
                             "3 0 1 2 255 0 0\n3  0 2 3  0 255 0\n# end\n";
const char* const full_stl = "solid facet vertex 1\n facet normal 0 0 1.0\n  outer loop\n   vertex 0 0 0\n   vertex 1 "
                             "0 0.0\n   vertex 1 1 -0\n  endloop\n endfacet\n"
                             " facet normal 0 0 0\n  outer loop\n   vertex 0 0 0\n   vertex 1 1 0\n   vertex 0 1 1e0\n "
                             " endloop\n endfacet\nendsolid facet vertex 1\n";
const char* const full_ply_header =
  "comment by  me\nobj_info x y\nelement camera 1\nproperty list uchar float view\nproperty float f\nelement vertex 4\n"
  "property list uchar short near\nproperty float x\nproperty double y\ncomment in between\nproperty float z\nproperty "
  "uchar red\n"
  "property uchar green\nproperty uchar blue\nproperty uint id\nelement face 2\nproperty list uchar uint vertex_index\n"
  "property list uchar float texcoord\nproperty short part\nelement edge 1\nproperty int vertex1\nproperty int "
  "vertex2\nend_header\n";
const char* const full_ply_body =
  "2 0.50 0.5   7\n1 3 0.0 0 0 1 2 3 4000000000\n0 1 0.0 0.1 4 5 6 1\n2 1 2 1.0 1 0 7 8 9 2\n0 0 1 2 1 1 1 3\n"
  "3 0 1 2 6 0 0 1 0 1 1 5\n3 0 2 3 0 -6\n0 1\n\n";

// Numbers in the byte order that is asked for, whatever that of the machine.
template <class T>
void append(std::string& bytes, T x, bool is_little)
{
  char buffer[sizeof(T)];
  std::memcpy(buffer, &x, sizeof(T));
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  if((first == 1) != is_little)
    std::reverse(buffer, buffer + sizeof(T));
  bytes.append(buffer, sizeof(T));
}

std::string full_binary_ply(bool is_little)
{
  std::string text =
    std::string("ply\nformat binary_") + (is_little ? "little" : "big") + "_endian 1.0\n" + full_ply_header;
  const auto add = [&](auto x) { append(text, x, is_little); };
  add(std::uint8_t(1)), add(0.5f), add(7.f);
  for(int v = 0; v < 4; ++v)
  {
    add(std::uint8_t(v % 2));
    for(int i = 0; i < v % 2; ++i)
      add(std::int16_t(-v));
    add(float(v == 1 || v == 2)), add(0.1 * double(v > 1)), add(float(v == 3)), add(std::uint8_t(v)),
      add(std::uint8_t(9)), add(std::uint8_t(255));
    add(4000000000u + unsigned(v));
  }
  for(unsigned int f = 0; f < 2; ++f)
  {
    add(std::uint8_t(3)), add(0u), add(1u + f), add(2u + f), add(std::uint8_t(2)), add(0.25f), add(1.f),
      add(std::int16_t(5));
  }
  add(0), add(1);
  return text;
}

std::string full_binary_stl()
{
  std::string text = "solid COLOR=abcd";
  text.resize(80, '\1');
  append(text, std::uint32_t(2), true);
  for(int f = 0; f < 2; ++f)
  {
    for(float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, float(f), 0.f, float(1 - f), 1.f, f == 0 ? -0.f : 0.5f})
      append(text, x, true);
    append(text, std::uint16_t(31 + f), true);
  }
  return text;
}

std::vector<std::pair<std::string, std::string> > full_files()
{
  return {{"full.obj", full_obj},
          {"full.off", full_off},
          {"full.stl", full_stl},
          {"binary.stl", full_binary_stl()},
          {"full.ply", std::string("ply\nformat ascii 1.0\n") + full_ply_header + full_ply_body},
          {"little.ply", full_binary_ply(true)},
          {"big.ply", full_binary_ply(false)}};
}

// The words of both texts are the same but where both are numbers; returns how many differ.
std::size_t number_of_other_numbers(const std::string& a, const std::string& b)
{
  std::istringstream words_a(a), words_b(b);
  std::size_t count = 0;
  std::string word_a, word_b;
  const auto is_number = [](const std::string& word) {
    char* end = nullptr;
    std::strtod(word.c_str(), &end);
    return !word.empty() && *end == 0;
  };
  while(words_a >> word_a)
  {
    if(!GDP_CHECK(bool(words_b >> word_b)))
      return 0;
    if(word_a != word_b)
    {
      GDP_CHECK(is_number(word_a) && is_number(word_b));
      ++count;
    }
  }
  GDP_CHECK(!(words_b >> word_b));
  return count;
}

// What is not filtered comes out as it came in, to the byte.
void test_lossless()
{
  for(const auto& file : full_files())
  {
    const std::string &name = file.first, &text = file.second, extension = name.substr(name.find('.')),
                      out = "out" + extension;
    write(folder / name, text);
    check_copies(name + " " + out);
    GDP_CHECK(contents(folder / out) == text);
    check_succeeds(name + " " + out + " --gradient-weight 1e-2");
    const std::string moved = contents(folder / out);
    GDP_CHECK(moved != text);
    const bool is_binary = text.find('\1') != std::string::npos || text.find("binary") != std::string::npos;
    if(is_binary)
      GDP_CHECK(moved.size() == text.size() && moved.substr(0, 84) == text.substr(0, 84));
    else
    {
      const std::size_t others = number_of_other_numbers(text, moved);
      GDP_CHECK(others > 0 && others <= 12 + 6 + 18); // coordinates and normals
      GDP_CHECK(std::count(text.begin(), text.end(), '\n') == std::count(moved.begin(), moved.end(), '\n'));
    }
    fs::remove(folder / out);
    fs::remove(folder / name);
  }

  // from one form of PLY to another and back
  write(folder / "little.ply", full_binary_ply(true));
  check_copies("little.ply text.ply --ascii");
  GDP_CHECK(contents(folder / "text.ply").find("\n1 -1 1 0 0 1 9 255 4000000001\n") != std::string::npos);
  check_copies("text.ply back.ply --binary");
  GDP_CHECK(contents(folder / "back.ply") == full_binary_ply(true));
  check_copies("little.ply text.ply --ascii --precision double");
  GDP_CHECK(
    contents(folder / "text.ply")
      .find("\nproperty double x\nproperty double y\ncomment in between\nproperty double z\nproperty uchar red\n")
    != std::string::npos);
  check_copies("text.ply back.ply --binary --precision single");
  GDP_CHECK(contents(folder / "back.ply").find("\nproperty float x\nproperty float y\ncomment in between\n")
            != std::string::npos);
  for(const char* name : {"little.ply", "text.ply", "back.ply"})
    fs::remove(folder / name);
}

// The same of files that are spelled at random.
void test_random_files()
{
  for(unsigned int seed = 0; seed < 12; ++seed)
  {
    gdp_test::Random_file random(seed);
    const std::pair<std::string, std::string> files[] = {{"random.obj", random.obj()},
                                                         {"random.off", random.off()},
                                                         {"random.stl", random.text_stl()},
                                                         {"binary.stl", random.binary_stl()},
                                                         {"random.ply", random.ply(0)},
                                                         {"little.ply", random.ply(1)},
                                                         {"big.ply", random.ply(2)}};
    for(const auto& file : files)
    {
      const std::string &name = file.first, &text = file.second, out = "out" + name.substr(name.find('.'));
      write(folder / name, text);
      const Outcome copied = run(name + " " + out + " --gradient-weight 0");
      if(!GDP_CHECK(copied.code == 0 && contents(folder / out) == text))
        std::cerr << "  " << name << " of seed " << seed << ": " << copied.err << std::endl;
      GDP_CHECK(run(name + " " + out + " --gradient-weight 1e-2").code == 0);
      const std::string moved = contents(folder / out);
      GDP_CHECK(moved != text);
      if(name.substr(0, 6) == "random") // only numbers, and no line, are others
        GDP_CHECK(number_of_other_numbers(text, moved) > 0
                  && std::count(text.begin(), text.end(), '\n') == std::count(moved.begin(), moved.end(), '\n'));
      else
        GDP_CHECK(moved.size() == text.size());
      fs::remove(folder / name);
      fs::remove(folder / out);
    }
  }
}

// What another format cannot hold is said.
void test_format_changes()
{
  for(const auto& file : full_files())
    write(folder / file.first, file.second);
  check_copies(
    "full.obj out.ply",
    {"not kept: vertex colors, which not all vertices have, texture coordinates, 2 materials, 1 object, 1 group, "
     "smoothing groups, points, lines and curves, 2 comments"});
  check_copies("full.off out.obj", {"not kept: 4 comments, colors of faces"});
  check_copies("full.off out.stl", {"not kept: 4 comments, normals of vertices, colors of vertices"});
  check_copies("full.off out.ply --ascii", {"not kept: 4 comments"});
  GDP_CHECK(contents(folder / "out.ply").find("\n3 0 1 2 255 0 0\n") != std::string::npos);
  check_copies("full.ply out.off",
               {"not kept: 3 comments, 1 camera element, the list 'near' of vertex, the list 'texcoord' of face, "
                "1 edge element, the property id of vertices, the property part of faces"});
  GDP_CHECK(contents(folder / "out.off").find("COFF\n4 2 0\n") == 0);
  check_copies("full.stl out.off", {"not kept: name of the solid"});
  GDP_CHECK(contents(folder / "out.off") == "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2\n3 0 2 3\n");
  check_copies("binary.stl out.stl --ascii", {"not kept: header, attribute bytes"});
  write(folder / "alpha.off", "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 7\n0 1 0 0 0 1 9\n3 0 1 2\n");
  check_copies("alpha.off out.obj", {"not kept: alpha of vertices"});
  fs::remove(folder / "alpha.off");
  write(folder / "lonely.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n");
  check_copies("lonely.off out.stl", {"not kept: 1 vertex without a face"});
  write(folder / "huge.off", "OFF\n3 1 0\n0 0 0\n1e40 0 0\n0 1e40 0\n3 0 1 2\n");
  check_fails("huge.off new.stl --binary", 1, "does not fit into single precision");
  for(const auto& file : full_files())
    fs::remove(folder / file.first);
  for(const char* name : {"lonely.off", "huge.off", "out.ply", "out.obj", "out.stl", "out.off"})
    fs::remove(folder / name);
}

void test_streams()
{
  for(const auto& file : full_files())
    write(folder / file.first, file.second);
  for(const auto& file : full_files())
  {
    const Outcome outcome = run("- - --gradient-weight 0 <" + file.first);
    GDP_CHECK(outcome.code == 0 && outcome.out == file.second
              && outcome.err.find("standard output: nothing has changed") != std::string::npos);
  }
  const Outcome changed = run("- - --output-format off --gradient-weight 0 --verbose <full.stl");
  GDP_CHECK(changed.code == 0 && changed.out == "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2\n3 0 2 3\n");
  GDP_CHECK(changed.err.find("wrote standard output") != std::string::npos);
  GDP_CHECK(run("full.off - --gradient-weight 0").out == full_off);
  check_fails("- out.ply </dev/null", 1, "standard input: the file is empty");
  write(folder / "words", "neither this\nnor that\n");
  check_fails("- out.ply <words", 1, "standard input: neither OFF");
  check_fails("- - --signal color <full.stl", 2, "STL cannot hold");
  for(const auto& file : full_files())
    fs::remove(folder / file.first);
  fs::remove(folder / "words");
}

void test_packed_files()
{
  const Outcome outcome = run("mesh.off out.off.gz --gradient-weight 0");
  if(outcome.code == 2 && outcome.err.find("without Boost.Iostreams") != std::string::npos)
  {
    std::cerr << "packed files are not tested: the program was built without Boost.Iostreams" << std::endl;
    return;
  }
  const std::string packed = contents(folder / "out.off.gz");
  GDP_CHECK(packed.substr(0, 2) == "\x1f\x8b" && packed.size() < contents(folder / "mesh.off").size());
  check_copies("out.off.gz back.off");
  GDP_CHECK(contents(folder / "back.off") == contents(folder / "mesh.off"));
  GDP_CHECK(run("- - --gradient-weight 0 <out.off.gz").out == contents(folder / "mesh.off"));
  write(folder / "cut.off.gz", packed.substr(0, packed.size() / 2));
  check_fails("cut.off.gz out.ply", 1, "cut.off.gz: cannot be unpacked");
  for(const char* name : {"out.off.gz", "back.off", "cut.off.gz"})
    fs::remove(folder / name);
}

// The normals of a file are those of the moved surface; those that have no reason to change stay.
void test_normals_follow()
{
  // a bump; the far corner is constrained with all around it
  std::string obj = "vn 0 0 1\nvn 0 0 1\n",
              ply = "ply\nformat ascii 1.0\nelement vertex 25\nproperty double x\nproperty double y\n"
                    "property double z\nproperty double nx\nproperty double ny\nproperty double nz\nproperty int "
                    "kept\nelement face 16\n"
                    "property list uchar int vertex_indices\nend_header\n";
  for(int i = 0; i < 25; ++i)
  {
    const std::string point = std::to_string(i % 5) + " " + std::to_string(i / 5) + (i == 6 ? " 1" : " 0");
    obj += "v " + point + "\n";
    ply += point + " 0 0.0 1.00 " + (i % 5 > 2 ? "1" : "0") + "\n";
  }
  for(int i = 0; i < 16; ++i)
  {
    const int v = i % 4 + 5 * (i / 4);
    for(int corner : {v, v + 1, v + 6, v + 5})
    {
      ply += (corner == v ? "4 " : " ") + std::to_string(corner);
      obj += (corner == v ? "f " : " ") + std::to_string(corner + 1) + (i % 4 < 2 ? "//1" : "//2");
    }
    ply += "\n";
    obj += "\n";
  }
  write(folder / "bump.ply", ply);
  write(folder / "bump.obj", obj);
  check_succeeds("bump.ply out.ply --constrain kept --gradient-weight 0.01");
  const std::string followed = contents(folder / "out.ply");
  std::istringstream lines(followed.substr(followed.find("end_header\n") + 11));
  std::size_t unit = 0, kept = 0;
  std::string line;
  for(int i = 0; i < 25 && std::getline(lines, line); ++i)
  {
    double x[7];
    std::istringstream numbers(line);
    for(double& number : x)
      numbers >> number;
    unit += std::abs(std::sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) - 1) < 1e-12 && x[5] > 0.3;
    const bool is_as_it_was = line.find(" 0 0.0 1.00 ") != std::string::npos;
    kept += is_as_it_was;
    GDP_CHECK(i % 5 != 4 || is_as_it_was); // faces with constrained corners only
    GDP_CHECK(i != 6 || !is_as_it_was);
  }
  GDP_CHECK(unit == 25 && kept >= 5 && kept < 20);
  check_succeeds("bump.ply out.ply --constrain kept --gradient-weight 0.01 --keep-normals");
  const std::string same = contents(folder / "out.ply");
  std::size_t spelled = 0;
  for(std::size_t at = same.find(" 0 0.0 1.00 "); at != std::string::npos; at = same.find(" 0 0.0 1.00 ", at + 1))
    ++spelled;
  GDP_CHECK(spelled == 25);

  // a vn is one normal, of all corners that use it; the other half of the bump is lower
  check_succeeds("bump.obj out.obj --gradient-weight 0.01");
  const std::string text = contents(folder / "out.obj");
  GDP_CHECK(text.compare(0, 3, "vn ") == 0 && text.compare(0, 9, "vn 0 0 1\n") != 0);
  GDP_CHECK(text.substr(text.find("\nf ")) == obj.substr(obj.find("\nf ")));
  for(const char* name : {"bump.ply", "bump.obj", "out.ply", "out.obj"})
    fs::remove(folder / name);
}

std::string ply_square(const std::string& vertex_property, const std::vector<std::string>& values,
                       const std::string& face_property, const std::vector<std::string>& face_values)
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\n"
                     + vertex_property + "element face 8\nproperty list uchar int vertex_indices\n" + face_property
                     + "end_header\n";
  for(std::size_t v = 0; v < 9; ++v)
    text += std::to_string(v % 3) + " " + std::to_string(v / 3) + " 0 " + values[v] + "\n";
  for(std::size_t f = 0; f < 8; ++f)
  {
    const std::size_t v = f / 2 % 2 + 3 * (f / 4);
    text += "3 " + std::to_string(v) + " " + std::to_string(f % 2 ? v + 4 : v + 1) + " "
            + std::to_string(f % 2 ? v + 3 : v + 4) + " " + face_values[f] + "\n";
  }
  return text;
}

void test_property_signals()
{
  const std::vector<std::string> heat = {"0", "0", "0", "0", "90.0", "0", "0", "0", "0"},
                                 part = {"8", "0", "0", "0", "0", "0", "0", "0"};
  const std::string text = ply_square("property float heat\n", heat, "property short part\n", part);
  write(folder / "square.ply", text);
  check_succeeds("square.ply out.ply --signal heat --gradient-weight 0.1");
  GDP_CHECK(number_of_other_numbers(text, contents(folder / "out.ply")) == 9);
  check_succeeds("square.ply out.ply --signal part --gradient-weight 0.1",
                 {"the property part has integers, and the result is rounded to such"});
  const std::size_t others = number_of_other_numbers(text, contents(folder / "out.ply"));
  GDP_CHECK(others >= 2 && others <= 8); // integers stay integers
  check_fails("square.ply new.ply --signal part,heat", 1,
              "no property 'part,heat'; vertices have: heat; faces have: part");
  check_fails("square.ply new.ply --signal part --constrain heat", 1, "--constrain");
  check_fails("square.ply new.ply --signal part --border fixed", 1, "--border");
  check_succeeds("square.ply out.ply --signal part --region heat", {"nothing has changed: the region is empty"});

  std::vector<std::string> gap = heat;
  gap[4] = "nan";
  gap[0] = "9";
  write(folder / "gap.ply", ply_square("property float heat\n", gap, "property short part\n", part));
  check_fails("gap.ply new.ply --signal heat", 1, "the property 'heat' of vertex 4 is NaN");
  check_succeeds("gap.ply out.ply --signal heat --missing-values --gradient-weight 0.1",
                 {"gap.ply: 1 missing value was filled in"});
  GDP_CHECK(contents(folder / "out.ply").find("nan") == std::string::npos);
  for(const char* name : {"square.ply", "gap.ply", "out.ply"})
    fs::remove(folder / name);
}

// Where vertices may move, and how far.
void test_places()
{
  const Mesh mesh = read_off(folder / "mesh.off");
  check_succeeds("mesh.off out.off --axes z --gradient-weight 1e-2");
  const Mesh along_z = read_off(folder / "out.off");
  bool is_moved = false;
  for(auto v : mesh.vertices())
  {
    GDP_CHECK(mesh.point(v).x() == along_z.point(v).x() && mesh.point(v).y() == along_z.point(v).y());
    is_moved = is_moved || mesh.point(v).z() != along_z.point(v).z();
  }
  GDP_CHECK(is_moved);
  const double free = [&] {
    check_succeeds("mesh.off out.off --gradient-weight 1e-2");
    return largest_difference(mesh, read_off(folder / "out.off"));
  }();
  const Outcome held = run("mesh.off out.off --gradient-weight 1e-2 --max-displacement " + std::to_string(free / 4));
  GDP_CHECK(held.code == 0 && held.err.find(" held back at the largest displacement") != std::string::npos);
  GDP_CHECK_NEAR(largest_difference(mesh, read_off(folder / "out.off")), free / 4, 1e-5 * free);
  check_succeeds("mesh.off out.off --gradient-weight 1e-2 --non-shrinking 4");
  const Mesh once_more = read_off(folder / "out.off");
  check_succeeds("mesh.off out.off --gradient-weight 1e-2 --non-shrinking");
  GDP_CHECK(largest_difference(mesh, once_more) < largest_difference(mesh, read_off(folder / "out.off")));
  GDP_CHECK(largest_difference(mesh, read_off(folder / "out.off")) < 0.8 * free);
  fs::remove(folder / "out.off");
}

// Weights of 0 and constraints everywhere, by properties; signals without gradients; results that nobody can mean.
void test_reasons()
{
  write(folder / "all.ply",
        ply_square("property int all\nproperty int one\n", std::vector<std::string>(9, "1 1"), "",
                   std::vector<std::string>(8)));
  write(folder / "none.ply",
        ply_square("property int none\n", std::vector<std::string>(9, "0"), "", std::vector<std::string>(8)));
  check_succeeds("none.ply out.ply --gradient-weight-property none",
                 {"nothing has changed: the gradient weight is 0, as none is at all vertices"});
  check_succeeds("all.ply out.ply --gradient-scale-property one",
                 {"nothing has changed: the gradient scale is 1, as one is at all vertices"});
  for(const char* options : {"", "--signal normal-to-position", "--signal normal-to-position --gradient-weight 1e-3"})
    check_succeeds("all.ply out.ply --constrain all " + std::string(options),
                   {"nothing has changed: all vertices are constrained"});
  check_succeeds("mesh.off out.off --signal normal-to-position --max-displacement 0",
                 {"nothing has changed: the largest displacement is 0"});
  check_succeeds("all.ply out.ply --signal all", {"nothing has changed: the signal is the same everywhere"});
  check_succeeds("mesh.off out.off --signal normal-to-position",
                 {"nothing has changed but by rounding: the normals are those that the surface has"});
  check_succeeds("mesh.off out.off --gradient-weight 1e-20", {"the gradient weight is too small"});
  write(folder / "flat.off",
        "NOFF\n6 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 0 0 1 0\n1 0 0 0 1 0\n0 0 1 0 1 0\n"
        "3 0 1 2\n3 4 3 5\n");
  check_succeeds("flat.off out.off --signal normal", {"on every face the signal is the same at all corners"});

  // what is left of the surface is not what was meant
  check_succeeds("mesh.off out.off --gradient-weight 1e9", {"times as large as before"});
  check_succeeds("mesh.off out.off --gradient-scale 1e9", {"times as large as before"});
  check_succeeds("mesh.off out.off --operation low-pass --wavelengths 1e-6", {"no waves on this surface"});
  for(const char* name : {"none.ply", "all.ply", "flat.off", "out.ply", "out.off"})
    fs::remove(folder / name);
}

// Whatever leaves everything as it was says why, also in the report.
void test_said()
{
  write(folder / "none.ply",
        ply_square("property int none\n", std::vector<std::string>(9, "0"), "", std::vector<std::string>(8)));
  check_copies("mesh.off out.off");
  check_succeeds("none.ply out.ply --region none", {"nothing has changed: the region is empty"});
  check_succeeds("mesh.off out.off --max-displacement 0", {"nothing has changed: the largest displacement is 0"});
  check_succeeds("mesh.off out.off --gradient-weight 0 --report report.json", {"nothing has changed"});
  const std::string report = contents(folder / "report.json");
  GDP_CHECK(report.find("\"why_unchanged\": \"the gradient weight is 0\"") != std::string::npos);
  GDP_CHECK(report.find("\"changed\": 0,") != std::string::npos);

  // less than single precision holds
  check_copies("mesh.off single.ply --precision single");
  check_succeeds("single.ply out.ply --gradient-weight 1e-13",
                 {"nothing has changed: all changes are smaller than what the numbers of the file can hold"});
  check_succeeds("single.ply out.ply --gradient-weight 1e-13 --quiet");
  GDP_CHECK(contents(folder / "out.ply") == contents(folder / "single.ply"));
  fs::remove(folder / "single.ply");

  // jets on needles
  write(folder / "needles.off",
        "OFF\n6 4 0\n0 0 0\n1 0 0\n0 50 1\n1 50 1\n0 100 0\n1 100 0\n3 0 1 3\n3 0 3 2\n3 2 3 5\n3 2 5 4\n");
  check_succeeds("needles.off out.off --metric edge-aware", {"4 faces are needles"});
  check_succeeds("needles.off out.off --metric edge-aware --curvature normals");
  check_succeeds("needles.off out.off");
  fs::remove(folder / "needles.off");

  // parts of different size, and a face alone
  write(folder / "parts.off",
        "OFF\n7 3 0\n0 0 0\n100 0 0\n0 100 0\n100 100 1\n0 0 50\n1 0 50\n0 1 50\n3 0 1 2\n3 1 3 2\n3 4 5 6\n");
  check_succeeds("parts.off out.off",
                 {"2 parts of very different size under one weight", "1 face that is connected to no other"});
  check_succeeds("parts.off out.off --gradient-weight 1e-6",
                 {"2 parts of very different size under one weight", "1 face that is connected to no other",
                  "1 part hardly moves, that of face 0: the gradient weight is small for such large faces"});
  check_succeeds("parts.off out.off --quiet");
  const Outcome parts = run("parts.off out.off --verbose");
  GDP_CHECK(parts.err.empty()); // not twice
  GDP_CHECK(parts.out.find("2 parts of very different size under one weight: the smallest is 100 times smaller")
            != std::string::npos);
  GDP_CHECK(parts.out.find("1 face that is connected to no other") != std::string::npos);
  // faces that are there twice or have no area
  write(folder / "odd.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n3 0 1 2\n3 0 2 3\n3 2 0 1\n3 0 3 3\n");
  check_succeeds("odd.off out.off",
                 {"2 edges with more than two faces", "2 edges between faces of which one is turned over",
                  "1 face that is there already", "1 face without area"});
  for(const char* name : {"none.ply", "parts.off", "odd.off", "report.json", "out.off", "out.ply"})
    fs::remove(folder / name);
}

struct Soup
{
  std::vector<Kernel::Vector_3> points;
  std::vector<std::vector<std::size_t> > faces;
};

Soup read_soup(const fs::path& path)
{
  std::ifstream in(path);
  std::string word;
  std::size_t counts[3] = {0, 0, 0};
  in >> word >> counts[0] >> counts[1] >> counts[2];
  Soup soup;
  for(std::size_t v = 0; v < counts[0]; ++v)
  {
    std::string x, y, z; // NaN is no number to a stream
    in >> x >> y >> z;
    soup.points.emplace_back(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr),
                             std::strtod(z.c_str(), nullptr));
  }
  soup.faces.resize(counts[1]);
  for(auto& face : soup.faces)
  {
    std::size_t n = 0;
    in >> n;
    face.resize(n < 100 ? n : 0);
    for(std::size_t& v : face)
      in >> v;
  }
  GDP_CHECK(bool(in) && !soup.faces.empty());
  return soup;
}

double largest_difference(const Soup& a, const Soup& b)
{
  double largest = 0;
  for(std::size_t v = 0; v < a.points.size(); ++v)
    largest = (std::max)(largest, std::sqrt((a.points[v] - b.points[v]).squared_length()));
  return largest;
}

// Marks of UTF-8, names that say another format, vertices without a face far away, tolerances that join nothing or all.
void test_odd_files()
{
  const std::string mark = "\xEF\xBB\xBF", square = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  write(folder / "marked.off", mark + square);
  check_copies("marked.off out.off");
  GDP_CHECK(contents(folder / "out.off") == mark + square);
  check_succeeds("marked.off out.off --gradient-weight 0.1");
  GDP_CHECK(contents(folder / "out.off").compare(0, 7, mark + "OFF\n") == 0);
  check_succeeds("marked.off out.obj --gradient-weight 0.1", {"not kept: the mark of UTF-8"});
  GDP_CHECK(contents(folder / "out.obj").compare(0, 3, mark) != 0);
  fs::remove(folder / "out.obj");
  check_copies("marked.off out.obj", {"not kept: the mark of UTF-8"});
  GDP_CHECK(contents(folder / "out.obj").compare(0, 2, "v ") == 0);
  write(folder / "marked.obj", mark + "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n"); // its first vertex counts
  check_succeeds("marked.obj out.off --gradient-weight 0.1", {"not kept: the mark of UTF-8"});
  GDP_CHECK(contents(folder / "out.off").compare(0, 10, "OFF\n4 1 0\n") == 0);

  write(folder / "voxels.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n9 0 0\n9 9 7\n0 9 0\n4 0 1 2 3\n");
  check_succeeds("voxels.ply out.ply --gradient-weight 0.1", {"the result is rounded to such"});
  GDP_CHECK(contents(folder / "out.ply").find("property int z\n") != std::string::npos);
  check_succeeds("voxels.ply out.ply --gradient-weight 0.1 --precision double");
  GDP_CHECK(contents(folder / "out.ply").find("property double z\n") != std::string::npos);
  fs::remove(folder / "voxels.ply");
  fs::remove(folder / "out.ply");

  write(folder / "wrong.stl", square);
  check_fails("wrong.stl new.off", 1, "; it looks like --input-format off");
  check_succeeds("wrong.stl out.off --input-format off --gradient-weight 0.1");
  write(folder / "wrong.obj", full_binary_ply(true));
  check_fails("wrong.obj new.off", 1, "; it looks like --input-format ply");

  // triangles that have lost their neighbors, almost
  const std::string apart = "\n0 0 0\n1 0 0\n1 1 0.5\n1e-7 0 0\n1 1 0.5000001\n0 1 0\n", faces = "3 0 1 2\n3 3 4 5\n";
  write(folder / "apart.off", "OFF\n6 2 0" + apart + faces);
  write(folder / "far.off", "OFF\n8 2 0" + apart + "1e149 0 0\nnan 0 0\n" + faces);
  check_succeeds("apart.off near.off --gradient-weight 0.1 --weld-tolerance 1e-5",
                 {"2 vertices at seams were welded to others"});
  check_succeeds("far.off out.off --gradient-weight 0.1 --weld-tolerance 1e-5",
                 {"2 vertices at seams were welded to others", "2 vertices without a face stay as they are"});
  GDP_CHECK_NEAR(largest_difference(read_soup(folder / "near.off"), read_soup(folder / "out.off")), 0, 1e-12);
  for(const char* tolerance : {"1e-9", "1e-30", "1e-300"})
    check_succeeds("apart.off out.off --gradient-weight 0.1 --weld-tolerance " + std::string(tolerance),
                   {"2 faces that are connected to no other: does a (larger) --weld-tolerance join them?"});
  check_succeeds("apart.off out.off --weld-tolerance 2",
                 {"nothing has changed", "5 vertices at seams were welded to others"});
  for(const char* name : {"marked.off", "marked.obj", "wrong.stl", "wrong.obj", "apart.off", "far.off", "near.off",
                          "out.off", "out.obj"})
    fs::remove(folder / name);
}

// A height that is missing lies between those around it.
void test_missing_heights()
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex 25\nproperty double x\nproperty double y\nproperty double "
                     "z\nelement face 16\n"
                     "property list uchar int vertex_indices\nend_header\n";
  for(int i = 0; i < 25; ++i)
    text += std::to_string(i % 5) + " " + std::to_string(i / 5) + " "
            + (i == 12 || i == 13 ? "nan" : std::to_string(i % 5)) + "\n";
  for(int i = 0; i < 16; ++i)
  {
    const int v = i % 4 + 5 * (i / 4);
    text += "4 " + std::to_string(v) + " " + std::to_string(v + 1) + " " + std::to_string(v + 6) + " "
            + std::to_string(v + 5) + "\n";
  }
  write(folder / "terrain.ply", text);
  check_fails("terrain.ply new.ply --axes z", 1, "vertex 12: ");
  check_fails("terrain.ply new.ply --missing-values", 2, "--axes with one axis");
  check_fails("terrain.ply new.ply --axes xy --missing-values", 2, "--axes with one axis");
  check_fails("terrain.ply new.ply --axes x --missing-values", 1, "vertex 12: ");
  check_succeeds("terrain.ply out.ply --axes z --missing-values --gradient-weight 0",
                 {"terrain.ply: 2 missing heights were filled in"});
  std::istringstream in(contents(folder / "out.ply"));
  std::string line;
  for(int i = 0; i < 9; ++i)
    std::getline(in, line);
  for(int i = 0; i < 25; ++i)
  {
    double x = 0, y = 0, z = 0;
    in >> x >> y >> z;
    GDP_CHECK(x == i % 5 && y == i / 5);
    GDP_CHECK_NEAR(z, i % 5, 1e-12); // a plane
  }
  for(const char* name : {"terrain.ply", "out.ply"})
    fs::remove(folder / name);
}

// ---- files of strangers, where they are beside the package

double volume(const Soup& soup)
{
  double sum = 0;
  for(const auto& f : soup.faces)
    sum += CGAL::scalar_product(soup.points[f[0]], CGAL::cross_product(soup.points[f[1]], soup.points[f[2]])) / 6;
  return sum;
}

// Degrees between the faces of a ball and a sphere about `center`.
double mean_angle_to_sphere(const Soup& soup, const Kernel::Vector_3& center)
{
  double sum = 0;
  for(const auto& f : soup.faces)
  {
    const Kernel::Vector_3 a = soup.points[f[0]], b = soup.points[f[1]], c = soup.points[f[2]];
    const Kernel::Vector_3 n = CGAL::cross_product(b - a, c - a), r = (a + b + c) / 3. - center;
    sum += std::acos((std::min)(1., n * r / std::sqrt(n.squared_length() * r.squared_length())));
  }
  return sum / double(soup.faces.size()) * 180 / 3.14159265358979323846;
}

const fs::path cases = "../../../shared/data/cases";

std::string quoted_case(const std::string& name) { return "\"" + fs::absolute(cases / name).string() + "\""; }

// A file of the kind as it is, and as it is filtered.
Soup case_in(const std::string& name)
{
  GDP_CHECK(run(quoted_case(name + ".ply.gz") + " in.off --gradient-weight 0").code == 0);
  return read_soup(folder / "in.off");
}

Soup case_out(const std::string& name, const std::string& options)
{
  const Outcome outcome = run(quoted_case(name + ".ply.gz") + " out.off " + options);
  if(!GDP_CHECK(outcome.code == 0))
    std::cerr << "  " << name << " " << options << ": " << outcome.err << std::endl;
  return read_soup(folder / "out.off");
}

void test_textured_file()
{
  check_copies(quoted_case("textured.obj.gz") + " copy.obj");
  check_succeeds("copy.obj out.obj --gradient-weight 1e-3");
  const auto others = [](const fs::path& path) {
    std::istringstream in(contents(path));
    std::string rest;
    for(std::string line; std::getline(in, line);)
      if(line.compare(0, 2, "v ") != 0 && line.compare(0, 3, "vn ") != 0)
        rest += line + "\n";
    return rest;
  };
  GDP_CHECK(others(folder / "copy.obj") == others(folder / "out.obj") && contents(folder / "copy.obj").size() > 30000);
  for(const char* name : {"copy.obj", "out.obj"})
    fs::remove(folder / name);
}

void test_case_files()
{
  if(!fs::exists(cases / "sphere.ply.gz")
     || run(quoted_case("sphere.ply.gz") + " in.off").err.find("without Boost.Iostreams") != std::string::npos)
  {
    std::cerr << "the files of strangers are not here, and not tested" << std::endl;
    return;
  }
  const double soup_volume = volume(case_out("soup_labelmap", "")) / volume(case_in("soup_labelmap"));
  GDP_CHECK_NEAR(soup_volume, 0.99186, 1e-4); // of the minimum of the energy; a ball as large keeps 0.9915

  const Kernel::Vector_3 center(18.13, 18.26, 18.39);
  const Soup ball = case_out("labelmap_sphere", "--operation denoise");
  GDP_CHECK(mean_angle_to_sphere(case_in("labelmap_sphere"), center) > 20 && mean_angle_to_sphere(ball, center) < 2.5);
  double radius = 0;
  for(const auto& p : ball.points)
    radius += std::sqrt((p - center).squared_length()) / double(ball.points.size());
  GDP_CHECK_NEAR(radius / 15, 1, 1e-3);

  const Soup house = case_in("house_clean");
  double edge = 0;
  for(const auto& f : house.faces)
    edge += std::sqrt((house.points[f[0]] - house.points[f[1]]).squared_length()) / double(house.faces.size());
  GDP_CHECK(largest_difference(house, case_out("house_spikes", "--operation denoise")) < edge);

  GDP_CHECK(largest_difference(case_in("cap_sphere"), case_out("cap_sphere", "--signal normal-to-position")) < 1e-3);
  GDP_CHECK_NEAR(volume(case_out("slab", "--signal normal-to-position")) / volume(case_in("slab")), 1, 1e-9);
  GDP_CHECK_NEAR(volume(case_out("sphere", "--iterations 50 --gradient-weight 1e-3 --restore-volume"))
                   / volume(case_in("sphere")), 1, 1e-9);

  const Soup scan = case_in("scan_zigzag");
  GDP_CHECK(largest_difference(scan, case_out("scan_zigzag", "--operation denoise --border along-border")) > 0.1);
  GDP_CHECK(largest_difference(case_out("slivers_cg", "--solver cg"), case_out("slivers_cg", "--solver eigen")) < 1e-9);
  const Soup plate = case_out("cad_plate", "--metric edge-aware --curvature normals --presmoothing-weight 0");
  for(const auto& p : plate.points)
    GDP_CHECK(std::abs(p.z() - 2.5) > 2.45 && std::abs(p.z() - 2.5) < 2.55);
  check_succeeds(quoted_case("cad_plate.ply.gz") + " out.off --metric edge-aware", {"368 faces are needles"});

  const Soup unused = case_out("unused_nan", "");
  GDP_CHECK(std::count_if(unused.points.begin(), unused.points.end(),
                          [](const Kernel::Vector_3& p) { return std::isnan(p.x()); }) == 5);
  double top = 0;
  for(const auto& p : case_out("flat_patch", "--operation fair --constrain con").points)
    top = (std::max)(top, p.z());
  GDP_CHECK_NEAR(top, 1, 0.01);
  test_textured_file();
  for(const char* name : {"in.off", "out.off"})
    fs::remove(folder / name);
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
    test_blocks();
    test_no_room();
    test_result(mesh);
    test_properties(mesh);
    test_other_operations(mesh);
    test_beyond_the_paper(mesh);
    test_any_surface();
    test_lines();
    test_lossless();
    test_random_files();
    test_format_changes();
    test_streams();
    test_packed_files();
    test_normals_follow();
    test_property_signals();
    test_places();
    test_said();
    test_reasons();
    test_missing_heights();
    test_odd_files();
    test_case_files();
    test_denoise(mesh);
    test_report(mesh);
  test_survey_of_many();

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
