// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Filters the positions, normals or colors of a mesh file: the package on the command line.

#include "gradient_domain_filter/Background_task.h"
#include "gradient_domain_filter/Failure.h"
#include "gradient_domain_filter/Options.h"
#include "gradient_domain_filter/Output_file.h"
#include "gradient_domain_filter/Report.h"
#include "gradient_domain_filter/Stage_clock.h"
#include "gradient_domain_filter/files/Mesh_file.h"
#include "gradient_domain_filter/filter_mesh.h"
#include "gradient_domain_filter/normals.h"
#include "gradient_domain_filter/signal.h"
#include "gradient_domain_filter/why_unchanged.h"

#ifdef GRADIENT_DOMAIN_FILTER_HAS_PICTURES
#include "gradient_domain_viewer/draw_picture.h"
#endif

#include <exception>
#include <functional>
#include <iostream>
#include <locale>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace GDP = CGAL::Gradient_domain_processing;

namespace {

bool is_terminal()
{
#if defined(__unix__) || defined(__APPLE__)
  return ::isatty(2) == 1;
#else
  return false;
#endif
}

// One line on the standard error, whatever is on the terminal.
void say(Stage_clock& clock, const std::string& sentence)
{
  clock.clear();
  std::cerr << "gradient_domain_filter: " << sentence << std::endl;
}

Mesh_file read(const Options& options)
{
  std::string text = read_bytes(options.input);
  const File_format format = options.input_format ? *options.input_format : sniffed_format(options.input_name(), text);
  return parse_mesh_file(options.input_name(), format, std::move(text));
}

// Filters, and lets the normals of the file follow.
void filter(const Options& options, const Output_form& form, bool is_surveyed, Mesh_file& file, Stage_clock& clock,
            Report& report)
{
  const std::vector<std::vector<double> > before = signal_values(options, file);
  const std::vector<Point> points = file.points;
  std::optional<Background_task> surveying;
  if(is_surveyed)
    surveying.emplace([&] { report.survey = survey(points, file.polygons, options.has_metric()); });
  const GDP::Error_code code = filter_mesh(options, file, clock, report.facts);
  if(code != GDP::ok)
    throw Failure(options.input_name(),
                  (clock.invalid().empty() ? "" : clock.invalid() + ": ") + GDP::get_error_message(code));
  if(surveying)
    surveying->wait();
  const bool is_changed = report.measure(before, signal_values(options, file)) || options.only_adds();
  if(!is_changed)
    report.why_unchanged = report.facts.why_unchanged.empty() ? why_unchanged(options, file, before)
                                                              : report.facts.why_unchanged;
  if(options.moves_vertices() && !options.keeps_normals)
    report.updated_normals = update_normals(points, file);
  report.not_kept = not_kept(file, form);
  if(is_changed)
    report.notices = rounded_signals(options, file, form);
  if(is_changed && !report.facts.why_unchanged.empty())
    report.notices.push_back(report.facts.why_unchanged); // outliers and missing heights have moved all the same
  for(const std::string& notice : clock.notices())
    if(notice != "no vertex was moved") // which may be all that is asked for, or is said with its reason
      report.notices.push_back(notice);
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for(const std::string& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

// What nobody should have to find out for himself. Remarks about a surface that was not to change are of no use, and
// --verbose has them in its summary.
void say_all(const Options& options, const Report& report, Stage_clock& clock)
{
  const bool is_unchanged = !report.why_unchanged.empty();
  if(is_unchanged)
    say(clock, options.output_name() + ": nothing has changed" + (report.changed_values == 0 ? "" : " but by rounding")
                 + ": " + report.why_unchanged);
  const bool asks_for_more = options.operation == Operation::DENOISE || options.weld_tolerance.value_or(0) > 0;
  if(!options.is_verbose && (!is_unchanged || asks_for_more))
    for(const std::string& remark : report.remarks(options))
      say(clock, options.input_name() + ": " + remark);
  if(!report.not_kept.empty())
    say(clock, options.output_name() + ": not kept: " + joined(report.not_kept));
}

// Of the surface before, and as it is in the file.
std::string picture([[maybe_unused]] const std::vector<Point>& before, [[maybe_unused]] const Mesh_file& file)
{
#ifdef GRADIENT_DOMAIN_FILTER_HAS_PICTURES
  const std::vector<Vector> normals = vertex_normals(before, file.polygons);
  std::vector<double> displacements;
  for(std::size_t v = 0; v < before.size(); ++v)
    displacements.push_back((file.points[v] - before[v]) * normals[v]);
  return picture_of(before, file.points, file.polygons, displacements);
#else
  return std::string(); // refused with the options
#endif
}

// Where there is a name.
std::unique_ptr<Output_file> optional_file(const std::string& name)
{
  return name.empty() ? nullptr : std::make_unique<Output_file>(name);
}

std::string eigenvalue_table(const std::vector<double>& eigenvalues)
{
  std::ostringstream table;
  table.imbue(std::locale::classic());
  table.precision(17);
  table << "index,eigenvalue\n";
  for(std::size_t i = 0; i < eigenvalues.size(); ++i)
    table << i << "," << eigenvalues[i] << "\n";
  return table.str();
}

// Consumes the file.
void write(const Options& options, const Output_form& form, Mesh_file& file, Stage_clock& clock, Report& report,
           Output_file& output)
{
  Timed_stage stage(clock, "write");
  const std::size_t size = file.text.size(), hash = std::hash<std::string_view>()(file.text);
  std::string contents = mesh_file_contents(file, form);
  std::string_view written(contents);
  if(file.has_mark && written.substr(0, 3) == utf8_mark)
    written.remove_prefix(3);
  if(report.why_unchanged.empty() && written.size() == size && std::hash<std::string_view>()(written) == hash)
  {
    report.why_unchanged = "all changes are smaller than what the numbers of the file can hold";
    report.changed_values = 0;
  }
  output.write(is_compressed_name(options.output) ? packed(contents) : std::move(contents));
}

void run(const Options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  std::unique_ptr<tbb::global_control> limit;
  if(options.threads > 0)
    limit =
      std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
#endif
  Stage_clock clock(!options.is_quiet && is_terminal());
  Output_file output(options.output);
  const std::unique_ptr<Output_file> report_file = optional_file(options.report),
                                     eigenvalue_file = optional_file(options.eigenvalues),
                                     picture_file = optional_file(options.picture);
#ifdef GRADIENT_DOMAIN_FILTER_HAS_PICTURES
  if(picture_file)
    check_screen();
#endif

  Mesh_file file;
  Report report;
  Output_form form{File_format::PLY, options.encoding, options.precision};
  {
    Timed_stage stage(clock, "read");
    file = read(options);
    form.format = options.output_format.value_or(file.format);
    check_output_form(options, form);
    check_form(file, form, options.output_name());
  }
  const std::vector<Point> before = picture_file ? file.points : std::vector<Point>();
  filter(options, form, !options.is_quiet || report_file, file, clock, report);
  if(picture_file)
    picture_file->write(picture(before, file));
  write(options, form, file, clock, report, output);
  if(report_file)
    report_file->write(report.json(options, clock));
  if(eigenvalue_file)
    eigenvalue_file->write(eigenvalue_table(report.facts.eigenvalues));
  output.commit();
  for(Output_file* other : {eigenvalue_file.get(), picture_file.get(), report_file.get()})
    if(other)
      other->commit();
  if(!options.is_quiet)
    say_all(options, report, clock);
  clock.clear();
  if(options.is_verbose)
    (options.output == "-" || options.report == "-" || options.eigenvalues == "-" ? std::cerr : std::cout)
      << report.summary(options, clock) << std::flush;
}

} // namespace

int main(int argc, char* argv[])
{
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 17); // large arrays go back to the system as they are freed: a tenth of the memory
#endif
  Options options;
  try
  {
    if(parse_command_line(argc, argv, options))
      run(options);
    return 0;
  }
  catch(const Usage_error& error)
  {
    std::cerr << "gradient_domain_filter: " << error.what() << std::endl;
    return 2;
  }
  catch(const Failure& failure)
  {
    std::cerr << "gradient_domain_filter: " << failure.what() << std::endl;
  }
  catch(const std::bad_alloc&)
  {
    std::cerr << "gradient_domain_filter: " << options.input_name() << ": out of memory" << std::endl;
  }
  catch(const std::exception& error)
  {
    std::cerr << "gradient_domain_filter: " << options.input_name() << ": " << error.what() << std::endl;
  }
  return 1;
}
