// SPDX-License-Identifier: GPL-3.0-or-later
#include "Report.h"

#include <sstream>

namespace balanced_flow_smooth {

namespace {

std::string neighbors_to_text(const Smoothing_report& r)
{
  const std::string most = std::to_string(r.most_neighbors);
  return r.fewest_neighbors == r.most_neighbors
             ? most
             : std::to_string(r.fewest_neighbors) + " to " + most;
}

/// "84.1%"; neither none nor all if it is not exactly that
std::string share_to_text(std::size_t count, std::size_t of)
{
  if (count != 0 && double(count) < .001 * double(of))
    return "less than 0.1%";
  if (count != of && double(count) > .999 * double(of))
    return "more than 99.9%";
  std::ostringstream text;
  text.precision(3);
  text << 100. * double(count) / double(of) << '%';
  return text.str();
}

/// How many points moved, and why the others did not
std::string movement_to_text(const Smoothing_report& r, bool makes_steps)
{
  const std::size_t all = r.number_of_points;
  std::string text = share_to_text(r.number_of_moved_points, all) + " of the points";
  const char* between = "; ";
  const auto add = [&](std::size_t count, const char* what) {
    if (count != 0)
      text += between + share_to_text(count, all) + what, between = ", ";
  };
  add(r.number_of_points_without_noise, " have no noise");
  add(r.number_of_isolated_points, " have fewer than two neighbors or are far from all others");
  add(r.number_of_constrained_points, " are constrained");
  add(r.number_of_points_at_rest, makes_steps ? " lie on their surface already" : " made no step");
  return text;
}

/// What the user can do if nothing moved; empty if there is nothing to do.
std::string advice(const Smoothing_report& r, const Smoothing_settings& s)
{
  if (r.number_of_moved_points != 0 || !s.makes_steps())
    return "";
  if (r.number_of_points_without_noise != 0)
    return "no noise was found; --noise sets its standard deviation by hand";
  if (r.number_of_isolated_points != 0 && s.neighbor_radius > 0.)
    return "a larger --neighbor-radius finds more neighbors";
  return "";
}

/// What was taken for coordinates and normals
std::string roles_to_text(const File_report& r)
{
  std::string text;
  for (const auto& [role, column] : r.roles)
    text += (text.empty() ? "" : ", ") + role + " " + std::to_string(column);
  text += ", by " + r.roles_source;
  if (r.unknown_normals != 0)
    text += "; " + std::to_string(r.unknown_normals) + " normals are null or not finite";
  return text;
}

/// What the file is, as far as it says so itself
void print_file(std::ostream& out, const File_report& r, bool with_name)
{
  if (with_name)
    out << r.job.input.string() << "\n";
  out << "points            " << r.points << "\n";
  if (r.scans > 1)
    out << "scans             " << r.scans << "\n";
  if (r.invalid_points != 0)
    out << "invalid points    " << r.invalid_points
        << (r.drops_invalid ? ", dropped" : ", kept as they are") << "\n";
  if (!r.roles.empty())
    out << "columns           " << roles_to_text(r) << "\n";
  if (r.movement)
    out << "moved             " << share_to_text(r.movement->number_of_points, r.points)
        << " of the points\nmean movement     " << r.movement->mean << "\n";
}

void print_movement(std::ostream& out, const Smoothing_report& r, const Smoothing_settings& s)
{
  out << "moved             " << movement_to_text(r, s.makes_steps()) << "\n";
  const std::string hint = advice(r, s);
  if (!hint.empty())
    out << "hint              " << hint << "\n";
  out << "mean movement     " << r.mean_movement << " (last iteration: " << r.last_movement
      << ")\n";
}

} // namespace

std::size_t Scene_report::sum(std::size_t File_report::*number) const
{
  std::size_t sum = 0;
  for (const File_report& file : files)
    sum += file.*number;
  return sum;
}

void print_summary(std::ostream& out, const Scene_report& r, const Settings& settings)
{
  const Smoothing_settings& s = settings.smoothing;
  for (const File_report& file : r.files)
    print_file(out, file, settings.jobs.size() > 1);
  if (settings.together)
    out << "together\n"
        << "points            " << r.sum(&File_report::points) << "\n"
        << "scans             " << r.sum(&File_report::scans) << "\n";
  if (r.sided_points)
    out << "sides             of " << share_to_text(*r.sided_points, r.sum(&File_report::points))
        << " of the points by the scanner\n";
  out << "spacing           " << r.smoothing->spacing << "\n"
      << (s.noise ? "given noise       " : "estimated noise   ") << r.smoothing->noise << "\n"
      << "neighbors         " << neighbors_to_text(*r.smoothing)
      << (s.k || s.is_paper_estimator() ? "" : " (fewer where two sheets are close)") << "\n"
      << "iterations        " << s.iterations << "\n";
  if (s.relaxation_steps != 0)
    out << "relaxation steps  " << s.relaxation_steps << "\n";
  if (!settings.dry_run)
    print_movement(out, *r.smoothing, s);
  else
    out << "flow              " << s.flow << ", with the estimator " << s.curvature << "\n"
        << "step length       " << s.step_length << "\n"
        << "update period     " << s.update_period << "\n"
        << "filter width      " << r.smoothing->filter_width << "\n"
        << "feature threshold " << r.smoothing->feature_threshold << "\n";
  out << "seconds           " << r.seconds << std::endl;
}

} // namespace balanced_flow_smooth
