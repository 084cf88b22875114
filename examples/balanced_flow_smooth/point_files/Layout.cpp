// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layout.h"

#include <algorithm>
#include <stdexcept>

namespace point_files {

Layout::Layout(std::vector<Property> properties) : m_properties(std::move(properties))
{
  if (!find({"x", "y", "z"}, m_coordinates))
    throw std::runtime_error("x, y and z must be properties of type float or double");
  m_has_normals = find({"nx", "ny", "nz"}, m_normals);
  const auto is_part = [](const Property& p) {
    return p.name == "nx" || p.name == "ny" || p.name == "nz";
  };
  if (!m_has_normals && std::any_of(m_properties.begin(), m_properties.end(), is_part))
    throw std::runtime_error("nx, ny and nz must be there together, of type float or double");
}

Layout Layout::of_columns(std::size_t width, bool with_normals)
{
  std::vector<Property> properties;
  for (const char* name : {"x", "y", "z"})
    properties.emplace_back(name, Scalar::DOUBLE);
  if (with_normals)
    for (const char* name : {"nx", "ny", "nz"})
      properties.emplace_back(name, Scalar::DOUBLE);
  while (properties.size() < width)
    properties.emplace_back("column_" + std::to_string(properties.size() + 1), Scalar::DOUBLE);
  return Layout(std::move(properties));
}

std::size_t Layout::last_coordinate() const
{
  return *std::max_element(m_coordinates.begin(), m_coordinates.end());
}

std::vector<std::size_t> Layout::others() const
{
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < m_properties.size(); ++i) {
    const auto is_i = [i](std::size_t j) { return i == j; };
    if (!m_properties[i].count_type &&
        std::none_of(m_coordinates.begin(), m_coordinates.end(), is_i) &&
        !(m_has_normals && std::any_of(m_normals.begin(), m_normals.end(), is_i)))
      others.push_back(i);
  }
  return others;
}

bool Layout::find(const std::array<const char*, 3>& names, std::array<std::size_t, 3>& places) const
{
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < m_properties.size(); ++i)
      if (m_properties[i].name == names[c]) {
        if (m_properties[i].count_type || is_integer(m_properties[i].type))
          return false;
        places[c] = i;
        ++found;
      }
    if (found > 1)
      throw std::runtime_error("there are two properties called " + std::string(names[c]));
    if (found == 0)
      return false;
  }
  return true;
}

} // namespace point_files
