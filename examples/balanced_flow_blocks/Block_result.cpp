// SPDX-License-Identifier: GPL-3.0-or-later
#include "Block_result.h"

#include "Disk_file.h"
#include "point_files/Temporary_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

namespace balanced_flow_blocks {

namespace {

typedef nlohmann::ordered_json Json;

/// Visits what is in a report: sums, and means over points.
template <typename Report, typename Sum, typename Mean>
void for_each_number(Report& r, const Sum& sum, const Mean& mean)
{
  sum("points", r.number_of_points);
  sum("distinct_points", r.number_of_distinct_points);
  sum("moved", r.number_of_moved_points);
  sum("constrained", r.number_of_constrained_points);
  sum("too_few_neighbors", r.number_of_isolated_points);
  sum("without_noise", r.number_of_points_without_noise);
  sum("at_rest", r.number_of_points_at_rest);
  mean("noise", r.noise);
  mean("spacing", r.spacing);
  mean("feature_threshold", r.feature_threshold);
  mean("filter_width", r.filter_width);
  mean("mean_movement", r.mean_movement);
  mean("last_movement", r.last_movement);
}

Smoothing_report report_from_json(const Json& json)
{
  Smoothing_report report;
  const auto read = [&](const char* name, auto& value) { json.at(name).get_to(value); };
  for_each_number(report, read, read);
  read("fewest_neighbors", report.fewest_neighbors);
  read("most_neighbors", report.most_neighbors);
  read("iterations", report.number_of_iterations);
  return report;
}

} // namespace

Json to_json(const Smoothing_report& report)
{
  Json json;
  const auto write = [&](const char* name, const auto& value) { json[name] = value; };
  for_each_number(report, write, write);
  write("fewest_neighbors", report.fewest_neighbors);
  write("most_neighbors", report.most_neighbors);
  write("iterations", report.number_of_iterations);
  return json;
}

void Report_sum::add(const Smoothing_report& report)
{
  const bool is_first = m_sum.number_of_points == 0;
  const Json other = to_json(report);
  const double weight = double(report.number_of_points);
  for_each_number(
      m_sum, [&](const char* name, std::size_t& sum) { sum += other[name].get<std::size_t>(); },
      [&](const char* name, double& sum) { sum += weight * other[name].get<double>(); });
  m_sum.fewest_neighbors = is_first ? report.fewest_neighbors
                                    : (std::min)(m_sum.fewest_neighbors, report.fewest_neighbors);
  m_sum.most_neighbors = (std::max)(m_sum.most_neighbors, report.most_neighbors);
  m_sum.number_of_iterations = report.number_of_iterations;
}

Smoothing_report Report_sum::report() const
{
  Smoothing_report report = m_sum;
  const double weight = (std::max)(double(m_sum.number_of_points), 1.);
  for_each_number(
      report, [](const char*, std::size_t&) {}, [&](const char*, double& sum) { sum /= weight; });
  return report;
}

void Block_result::write(const Manifest& manifest, std::size_t block, const Records& points,
                         const Smoothing_report& report, const Effort& effort)
{
  Json head;
  head["plan"] = manifest.checksum;
  head["block"] = block;
  head["count"] = points.size();
  head["has_normals"] = points.has_normals();
  head["checksum"] = Checksum::of(points.bytes(), points.byte_count());
  head["report"] = to_json(report);
  head["effort"] = {{"points_at_hand", effort.points_at_hand},
                    {"trials", effort.trials},
                    {"halo_width", effort.halo_width}};
  point_files::Temporary_file file(manifest.result_file(block));
  file.stream() << head.dump() << '\n';
  file.stream().write(points.bytes(), std::streamsize(points.byte_count()));
  file.take_place();
}

bool Block_result::exists(const Manifest& manifest, std::size_t block)
{
  return std::filesystem::exists(manifest.result_file(block)) &&
         (Block_result(manifest, block), true);
}

Block_result::Block_result(const Manifest& manifest, std::size_t block)
    : m_path(manifest.result_file(block)), m_number_of_points(manifest.number_of_points)
{
  std::ifstream in(m_path, std::ios::binary);
  std::string line;
  if (!std::getline(in, line))
    throw std::runtime_error("block " + std::to_string(block) + " is not smoothed yet");
  try {
    const Json head = Json::parse(line);
    if (head.at("plan") != manifest.checksum || head.at("block") != block)
      throw std::runtime_error("it is of another plan");
    m_begin = line.size() + 1;
    m_count = head.at("count");
    m_has_normals = head.at("has_normals");
    m_checksum = head.at("checksum");
    m_report = report_from_json(head.at("report"));
    const Json& effort = head.at("effort");
    m_effort = {effort.at("points_at_hand"), effort.at("trials"), effort.at("halo_width")};
    if (std::filesystem::file_size(m_path) != m_begin + m_count * Records::bytes_of(m_has_normals))
      throw std::runtime_error("it is not complete");
  }
  catch (const std::exception& e) {
    throw std::runtime_error(m_path.string() + " can not be used: " + e.what() +
                             "; remove it, and smooth block " + std::to_string(block) + " again");
  }
}

void Block_result::for_each(const std::function<void(const Records&)>& visit) const
{
  const auto refuse = [&] {
    throw std::runtime_error(m_path.string() +
                             " is damaged: remove it, and smooth its block again");
  };
  const Disk_file file(m_path, Disk_file::READ);
  Records records(m_has_normals);
  Checksum checksum;
  for (std::uint64_t i = 0; i < m_count; i += records.size()) {
    records.resize(std::size_t((std::min)(m_count - i, std::uint64_t(1) << 16)));
    file.read(m_begin + i * records.record_size(), records.bytes(), records.byte_count());
    checksum.add(records.bytes(), records.byte_count());
    for (std::size_t j = 0; j < records.size(); ++j)
      if (records.number(j) >= m_number_of_points)
        refuse();
    visit(records);
  }
  if (checksum.value() != m_checksum)
    refuse();
}

} // namespace balanced_flow_blocks
