// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_SMOOTH_LAYOUT_H
#define BALANCED_FLOW_SMOOTH_LAYOUT_H

#include "Scalar.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

struct Property {
  std::string name;
  Scalar type;                      // of its number, or of each number of a list
  std::optional<Scalar> count_type; // of a list

  Property(std::string n, Scalar t, std::optional<Scalar> c = std::nullopt)
      : name(std::move(n)), type(t), count_type(c)
  {}
};

/// What stands where in the record of a point
class Layout {
  std::vector<Property> m_properties;
  std::array<std::size_t, 3> m_coordinates = {}, m_normals = {};
  bool m_has_normals = false;

public:
  Layout() = default;

  /// Coordinates are called x, y, z, and normals nx, ny, nz, if there are any.
  explicit Layout(std::vector<Property> properties) : m_properties(std::move(properties))
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

  /// "x y z", "nx ny nz" if there are normals, and "column_4" and so on up to the width
  static Layout of_columns(std::size_t width, bool with_normals)
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

  const std::vector<Property>& properties() const { return m_properties; }
  const std::array<std::size_t, 3>& coordinates() const { return m_coordinates; }
  const std::array<std::size_t, 3>& normals() const { return m_normals; }
  bool has_normals() const { return m_has_normals; }

  /// the type of new properties that belong to the coordinates
  Scalar coordinate_type() const { return m_properties[m_coordinates[0]].type; }

  /// where further properties go
  std::size_t last_coordinate() const
  {
    return *std::max_element(m_coordinates.begin(), m_coordinates.end());
  }

  /// the properties other than coordinates and normals, without lists
  std::vector<std::size_t> others() const
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

private:
  bool find(const std::array<const char*, 3>& names, std::array<std::size_t, 3>& places) const
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
};

#endif // BALANCED_FLOW_SMOOTH_LAYOUT_H
