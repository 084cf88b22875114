// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scan_frame.h"

#include <cmath>
#include <stdexcept>

namespace point_files {

namespace {

typedef Scan_frame::Triple Triple;

Triple cross(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Triple combine(const std::array<Triple, 3>& axes, const Triple& p)
{
  Triple sum = {0., 0., 0.};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += p[i] * axes[i][c];
  return sum;
}

bool is_finite(const Triple& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

bool is_none(const Triple& p) { return (p[0] == 0. && p[1] == 0. && p[2] == 0.) || !is_finite(p); }

} // namespace

Scan_frame::Scan_frame(const std::array<Triple, 3>& axes, const Triple& translation,
                       const Triple& position)
    : m_axes(axes), m_translation(translation), m_position(position)
{
  const std::array<Triple, 3> normals = {cross(axes[1], axes[2]), cross(axes[2], axes[0]),
                                         cross(axes[0], axes[1])};
  const double determinant = dot(axes[0], normals[0]);
  if (!is_finite(translation))
    throw std::runtime_error("the transformation of a scan is not finite");
  if (!(std::isfinite(determinant) && determinant != 0.))
    throw std::runtime_error("the transformation of a scan has no inverse");
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      m_inverse[i][c] = normals[c][i] / determinant;
}

Scan_frame::Scan_frame(const Triple& position)
    : Scan_frame({Triple{1., 0., 0.}, Triple{0., 1., 0.}, Triple{0., 0., 1.}}, {0., 0., 0.},
                 position)
{}

Triple Scan_frame::to_shared(const Triple& p) const
{
  if (is_none(p))
    return p;
  Triple image = combine(m_axes, p);
  for (std::size_t c = 0; c < 3; ++c)
    image[c] += m_translation[c];
  return image;
}

Triple Scan_frame::to_own(const Triple& p) const
{
  if (is_none(p))
    return p;
  Triple moved = p;
  for (std::size_t c = 0; c < 3; ++c)
    moved[c] -= m_translation[c];
  return combine(m_inverse, moved);
}

} // namespace point_files
