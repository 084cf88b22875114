// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layout.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace point_files {

namespace {

constexpr std::array<const char*, 3> coordinate_roles = {"x", "y", "z"};
constexpr std::array<const char*, 3> normal_roles = {"nx", "ny", "nz"};

std::vector<Property> to_columns(const std::vector<std::string>& names)
{
  std::vector<Property> properties;
  for (const std::string& name : names)
    properties.emplace_back(name, Scalar::DOUBLE);
  return properties;
}

} // namespace

std::string role_of(const std::string& name)
{
  std::string role;
  for (const char c : name.substr(0, name.find_first_of(" [(")))
    if (c != '_')
      role += char(std::tolower(static_cast<unsigned char>(c)));
  if (role.compare(0, 6, "normal") == 0)
    role = "n" + role.substr(6);
  const auto is_role = [&](const char* r) { return role == r; };
  const bool is_known = std::any_of(coordinate_roles.begin(), coordinate_roles.end(), is_role) ||
                        std::any_of(normal_roles.begin(), normal_roles.end(), is_role);
  return is_known ? role : "";
}

std::vector<std::string> default_names(std::size_t width, bool with_normals)
{
  std::vector<std::string> names(coordinate_roles.begin(), coordinate_roles.end());
  if (with_normals)
    names.insert(names.end(), normal_roles.begin(), normal_roles.end());
  while (names.size() < width)
    names.push_back("column_" + std::to_string(names.size() + 1));
  return names;
}

Layout::Layout(std::vector<Property> properties) : m_properties(std::move(properties))
{
  if (!find(coordinate_roles, m_coordinates))
    throw std::runtime_error("x, y and z must be there, and be numbers and no lists");
  m_has_normals = find(normal_roles, m_normals);
  const auto is_part = [](const Property& p) {
    return role_of(p.name)[0] == 'n' && !is_unsigned(p.type);
  };
  if (!m_has_normals && std::any_of(m_properties.begin(), m_properties.end(), is_part))
    throw std::runtime_error("nx, ny and nz must be there together, and be numbers and no lists");
}

Layout::Layout(const std::vector<std::string>& names) : Layout(to_columns(names)) {}

Scalar Layout::coordinate_type() const
{
  for (const std::size_t i : m_coordinates)
    if (m_properties[i].type != Scalar::FLOAT)
      return Scalar::DOUBLE;
  return Scalar::FLOAT;
}

Scalar Layout::normal_type() const
{
  const Scalar type = m_properties[m_coordinates[0]].type;
  return is_integer(type) ? Scalar::FLOAT : type;
}

std::vector<std::pair<std::string, std::size_t>> Layout::roles() const
{
  std::vector<std::pair<std::string, std::size_t>> roles;
  for (std::size_t c = 0; c < 3; ++c)
    roles.emplace_back(coordinate_roles[c], m_coordinates[c] + 1);
  for (std::size_t c = 0; m_has_normals && c < 3; ++c)
    roles.emplace_back(normal_roles[c], m_normals[c] + 1);
  return roles;
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
    if (!m_properties[i].count_type && !m_properties[i].is_padding &&
        std::none_of(m_coordinates.begin(), m_coordinates.end(), is_i) &&
        !(m_has_normals && std::any_of(m_normals.begin(), m_normals.end(), is_i)))
      others.push_back(i);
  }
  return others;
}

/// Finds the properties of three roles: by the exact names, or else by names that mean the same.
/// Unsigned numbers are no normals: what code they have is not known, so they stay as they are.
bool Layout::find(const std::array<const char*, 3>& roles, std::array<std::size_t, 3>& places) const
{
  for (std::size_t c = 0; c < 3; ++c) {
    const auto is_possible = [&](const Property& p) {
      return roles != normal_roles || !is_unsigned(p.type);
    };
    const auto is_exact = [&](const Property& p) { return p.name == roles[c] && is_possible(p); };
    const auto means_it = [&](const Property& p) {
      return role_of(p.name) == roles[c] && is_possible(p);
    };
    const auto begin = m_properties.begin(), end = m_properties.end();
    auto count = std::count_if(begin, end, is_exact);
    const bool by_name = count != 0;
    if (!by_name)
      count = std::count_if(begin, end, means_it);
    if (count > 1)
      throw std::runtime_error("there are two properties called " + std::string(roles[c]));
    if (count == 0)
      return false;
    const auto found =
        by_name ? std::find_if(begin, end, is_exact) : std::find_if(begin, end, means_it);
    if (found->count_type)
      return false;
    places[c] = std::size_t(found - begin);
  }
  return true;
}

} // namespace point_files
