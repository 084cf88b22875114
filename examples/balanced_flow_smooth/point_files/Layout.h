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
  bool is_padding = false;          // means nothing

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

  /// Coordinates and normals, if there are any, have the names that `role_of()` knows. Throws
  /// `std::runtime_error` if they are not there, or only in part.
  explicit Layout(std::vector<Property> properties);

  /// The same of columns of text
  explicit Layout(const std::vector<std::string>& names);

  const std::vector<Property>& properties() const { return m_properties; }
  const std::array<std::size_t, 3>& coordinates() const { return m_coordinates; }
  const std::array<std::size_t, 3>& normals() const { return m_normals; }
  bool has_normals() const { return m_has_normals; }

  /// a type that holds all coordinates, also after smoothing
  Scalar coordinate_type() const;

  /// the type of normals that are added
  Scalar normal_type() const;

  /// which properties are coordinates and normals: their numbers, from 1 on
  std::vector<std::pair<std::string, std::size_t>> roles() const;

  /// where further properties go
  std::size_t last_coordinate() const;

  /// the properties other than coordinates and normals, without lists and padding
  std::vector<std::size_t> others() const;

private:
  bool find(const std::array<const char*, 3>& roles, std::array<std::size_t, 3>& places) const;
};

/// "x", "y", "z", "nx", "ny" or "nz" if a name means it, as do "X", "X [m]", "NormalX" and "normal_x";
/// empty if it means nothing of this.
std::string role_of(const std::string& name);

/// "x y z", "nx ny nz" if there are normals, and "column_4" and so on up to the width
std::vector<std::string> default_names(std::size_t width, bool with_normals);

} // namespace point_files

#endif // POINT_FILES_LAYOUT_H
