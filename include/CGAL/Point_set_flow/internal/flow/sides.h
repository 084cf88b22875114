// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SIDES_H
#define CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SIDES_H

#include <CGAL/license/Point_set_flow.h>

#include <CGAL/Point_set_flow/internal/neighbors/Surface.h>
#include <CGAL/Point_set_flow/internal/parallel/Array.h>

#include <cstddef>

namespace CGAL {
namespace Point_set_flow {
namespace internal {

/// Whether a given side can be trusted
inline bool is_trusted(const Vector_3& side, const Local_layers& layers)
{
  return layers.side_trust == Side_trust::TWO_SHEETS ||
         (layers.side_trust == Side_trust::ONE_SHEET && side * layers.usual_side.vector() > 0.);
}

/// Takes the sides that the caller gave, where they are trusted.
/// \param sides one for each point, null vectors where not known; empty if none is given
inline void take_given_sides(Surface_state& state, const Array<Vector_3>& sides)
{
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == NULL_VECTOR || !is_trusted(sides[i], state.parameters(i).layers))
      continue;
    state.sides.resize(sides.size()); // not earlier, to save memory
    state.sides[i] = Side_3(sides[i]);
  }
}

/// Takes the sides that were found, where none is trusted: of two sheets, the direction from the
/// middle between them to a point is the same for all points of one sheet, and opposite for those of the
/// other. Turns the normals to the sides.
/// \param sides see `Sheets::sides`
inline void take_found_sides(Surface_state& state, const Array<signed char>& sides)
{
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == 0)
      continue;
    state.sides.resize(sides.size());
    if (sides[i] < 0)
      state.normals[i] = -state.normals[i].vector();
    state.sides[i] = Side_3(state.normals[i].vector());
  }
}

} // namespace internal
} // namespace Point_set_flow
} // namespace CGAL

#endif // CGAL_POINT_SET_FLOW_INTERNAL_FLOW_SIDES_H
