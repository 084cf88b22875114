// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_SET_FLOW_COMPARISON_COMPARISON_PAGE_H
#define POINT_SET_FLOW_COMPARISON_COMPARISON_PAGE_H

#include "Drawn_cloud.h"
#include "Result_table.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cstdint>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

/// The page without its data: HTML, styles and scripts of the folder `page`, which the build turns
/// into a program text.
std::string comparison_page_template();

/// A page that shows clouds side by side, with all that it needs in one file.
class Comparison_page {
  typedef boost::property_tree::ptree Tree;
  Tree m_data, m_clouds;
  std::size_t m_most;

  static std::string base64(const std::string& bytes)
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
  static Tree packed(const Items& items, const Number_of& number_of)
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
    Tree tree;
    tree.put("low", low);
    tree.put("high", high);
    tree.put("data", base64(bytes));
    return tree;
  }

  static Tree list(const std::vector<std::string>& texts)
  {
    Tree tree;
    for (const std::string& text : texts)
      tree.push_back({"", Tree(text)});
    return tree;
  }

public:
  /// \param most the number of points that are drawn of a cloud; of larger ones it is a sample
  explicit Comparison_page(std::size_t most) : m_most(most) {}

  /// What else the page says: "input", "radius" (of the data, in their unit), "noise" (rms), ...
  template <typename Value>
  void set(const std::string& name, const Value& value)
  {
    m_data.put(name, value);
  }

  /// \param errors of the points; empty if they are not known
  /// \param shown whether the cloud is there when the page opens
  void add(const std::string& name, const std::string& title, const Points& points,
           const std::vector<double>& errors, bool shown)
  {
    const Drawn_cloud cloud = make_drawn_cloud(points, errors, m_most);
    Tree tree;
    tree.put("name", name);
    tree.put("title", title);
    tree.put("shown", shown);
    tree.put("points", points.size());
    tree.put("drawn", cloud.points.size());
    tree.put("spacing", cloud.spacing);
    tree.add_child("x", packed(cloud.points, [](const Point_3& p) { return p.x(); }));
    tree.add_child("y", packed(cloud.points, [](const Point_3& p) { return p.y(); }));
    tree.add_child("z", packed(cloud.points, [](const Point_3& p) { return p.z(); }));
    // on the side where z is positive, so that x and y are enough
    const auto up = [](const Vector_3& n) { return n.z() < 0. ? -n : n; };
    tree.add_child("normal_x", packed(cloud.normals, [&](const Vector_3& n) { return up(n).x(); }));
    tree.add_child("normal_y", packed(cloud.normals, [&](const Vector_3& n) { return up(n).y(); }));
    const auto same = [](double x) { return x; };
    tree.add_child("curvature", packed(cloud.variations, same));
    tree.add_child("feature", packed(cloud.strengths, same));
    if (!cloud.errors.empty())
      tree.add_child("error", packed(cloud.errors, same));
    m_clouds.push_back({"", tree});
  }

  /// Throws `std::runtime_error` if there is no cloud, or the file can not be written.
  void write(const std::string& file, const Result_table& table)
  {
    if (m_clouds.empty())
      throw std::runtime_error("there is no cloud that the page could show");
    Tree lines;
    table.for_each_line("", [&](const std::vector<std::string>& line) {
      lines.push_back({"", list(line)});
    });
    m_data.put_child("table", lines);
    m_data.put_child("clouds", m_clouds);
    std::ostringstream json;
    boost::property_tree::write_json(json, m_data, false);
    std::string page = comparison_page_template();
    // a name with "<" in it must not end the script that holds the data
    boost::replace_first(page, "@COMPARISON_DATA@",
                         boost::replace_all_copy(json.str(), "<", "\\u003c"));
    std::ofstream out(file, std::ios::binary);
    out << page;
    if (!out.flush())
      throw std::runtime_error("cannot write " + file);
  }
};

#endif // POINT_SET_FLOW_COMPARISON_COMPARISON_PAGE_H
