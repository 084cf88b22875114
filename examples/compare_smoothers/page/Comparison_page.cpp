// SPDX-License-Identifier: GPL-3.0-or-later
#include "Comparison_page.h"

#include "Drawn_cloud.h"
#include "page_template.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

namespace comparison {

namespace {

std::string base64(const std::string& bytes)
{
  using namespace boost::archive::iterators;
  typedef base64_from_binary<transform_width<std::string::const_iterator, 6, 8>> Encoder;
  // bytes come in pairs, but the encoder needs threes
  const std::string padded = bytes + std::string((3 - bytes.size() % 3) % 3, '\0');
  std::string text(Encoder(padded.begin()), Encoder(padded.end()));
  for (std::size_t i = bytes.size(); i < padded.size(); ++i)
    text[text.size() - 1 - (i - bytes.size())] = '=';
  return text;
}

/// Numbers as 16 bits each, which is finer than a screen can show: 0 for the least, 65535 for the
/// largest, low byte first
template <typename Items, typename Number_of>
nlohmann::ordered_json packed(const Items& items, const Number_of& number_of)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& item : items) {
    low = (std::min)(low, number_of(item));
    high = (std::max)(high, number_of(item));
  }
  std::string bytes;
  for (const auto& item : items) {
    const auto level = static_cast<std::uint16_t>(
        high > low ? std::lround(65535. * ((number_of(item) - low) / (high - low))) : 0);
    bytes += static_cast<char>(level & 0xff);
    bytes += static_cast<char>(level >> 8);
  }
  return {{"low", low}, {"high", high}, {"data", base64(bytes)}};
}

} // namespace

void Comparison_page::add(const std::string& name, const std::string& title, const Points& points,
                          const std::vector<double>& errors, bool shown)
{
  const Drawn_cloud cloud = make_drawn_cloud(points, errors, m_most);
  nlohmann::ordered_json json;
  json["name"] = name;
  json["title"] = title;
  json["shown"] = shown;
  json["points"] = points.size();
  json["drawn"] = cloud.points.size();
  json["spacing"] = cloud.spacing;
  json["x"] = packed(cloud.points, [](const Point_3& p) { return p.x(); });
  json["y"] = packed(cloud.points, [](const Point_3& p) { return p.y(); });
  json["z"] = packed(cloud.points, [](const Point_3& p) { return p.z(); });
  // on the side where z is positive, so that x and y are enough
  const auto up = [](const Vector_3& n) { return n.z() < 0. ? -n : n; };
  json["normal_x"] = packed(cloud.normals, [&](const Vector_3& n) { return up(n).x(); });
  json["normal_y"] = packed(cloud.normals, [&](const Vector_3& n) { return up(n).y(); });
  const auto same = [](double x) { return x; };
  json["curvature"] = packed(cloud.variations, same);
  json["feature"] = packed(cloud.strengths, same);
  if (!cloud.errors.empty())
    json["error"] = packed(cloud.errors, same);
  m_clouds.push_back(std::move(json));
}

void Comparison_page::write(const std::string& file, const Result_table& table) const
{
  if (m_clouds.empty())
    throw std::runtime_error("there is no cloud that the page could show");
  nlohmann::ordered_json data = m_data;
  nlohmann::ordered_json& lines = data["table"];
  lines.push_back(table.columns());
  lines[0].insert(lines[0].begin(), "method");
  table.for_each_row([&](const std::string& name, const std::vector<double>& numbers) {
    lines.push_back(numbers); // what is not known, NaN, is null in JSON
    lines.back().insert(lines.back().begin(), name);
  });
  data["clouds"] = m_clouds;
  // names of files may be any bytes
  const std::string json =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string page = page_template();
  // a name with "<" in it must not end the script that holds the data
  boost::replace_first(page, "@COMPARISON_DATA@", boost::replace_all_copy(json, "<", "\\u003c"));
  std::ofstream out(file, std::ios::binary);
  out << page;
  if (!out.flush())
    throw std::runtime_error("cannot write " + file);
}

} // namespace comparison
