// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAYOUT_H
#define POINT_FILES_LAYOUT_H

#include "Scalar.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace point_files {

/// A number, or a list of numbers, of each point
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
  explicit Layout(std::vector<Property> properties);

  /// "x y z", "nx ny nz" if there are normals, and "column_4" and so on up to the width
  static Layout of_columns(std::size_t width, bool with_normals);

  const std::vector<Property>& properties() const { return m_properties; }
  const std::array<std::size_t, 3>& coordinates() const { return m_coordinates; }
  const std::array<std::size_t, 3>& normals() const { return m_normals; }
  bool has_normals() const { return m_has_normals; }

  /// the type of new properties that belong to the coordinates
  Scalar coordinate_type() const { return m_properties[m_coordinates[0]].type; }

  /// where further properties go
  std::size_t last_coordinate() const;

  /// the properties other than coordinates and normals, without lists
  std::vector<std::size_t> others() const;

private:
  bool find(const std::array<const char*, 3>& names, std::array<std::size_t, 3>& places) const;
};

} // namespace point_files

#endif // POINT_FILES_LAYOUT_H
