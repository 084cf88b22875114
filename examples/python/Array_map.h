// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_PYTHON_ARRAY_MAP_H
#define BALANCED_FLOW_PYTHON_ARRAY_MAP_H

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstring>

namespace balanced_flow_python {

/// Property maps on the memory of arrays, whose keys are the numbers of rows. They own nothing.

/// The memory of an array with three columns; strides in bytes may be negative, and numbers need not be
/// aligned.
template <typename FT>
struct Rows {
  char* data = nullptr; ///< null if there is no array
  std::ptrdiff_t row_stride = 0, column_stride = 0;

  FT get(std::size_t row, int column) const
  {
    FT number;
    std::memcpy(&number, at(row, column), sizeof number);
    return number;
  }

  void set(std::size_t row, int column, FT number) const
  {
    std::memcpy(at(row, column), &number, sizeof number);
  }

private:
  char* at(std::size_t row, int column) const
  {
    return data + std::ptrdiff_t(row) * row_stride + column * column_stride;
  }
};

/// Reads points or vectors from one array and writes them to another one, which may be the same. It is
/// false as a condition if there is no array.
/// \tparam Triple `Point_3` or `Vector_3` of a kernel whose coordinates have the type `FT`
template <typename Triple, typename FT>
struct Rows_map {
  typedef std::size_t key_type;
  typedef Triple value_type;
  typedef Triple reference;
  typedef boost::read_write_property_map_tag category;

  Rows<FT> from, to;

  explicit operator bool() const { return from.data != nullptr; }
  friend Triple get(const Rows_map& map, std::size_t i)
  {
    return Triple(map.from.get(i, 0), map.from.get(i, 1), map.from.get(i, 2));
  }
  friend void put(const Rows_map& map, std::size_t i, const Triple& triple)
  {
    map.to.set(i, 0, triple.x());
    map.to.set(i, 1, triple.y());
    map.to.set(i, 2, triple.z());
  }
};

/// Reads a contiguous array with one number for each point.
template <typename Number>
struct Numbers_map {
  typedef std::size_t key_type;
  typedef Number value_type;
  typedef Number reference;
  typedef boost::readable_property_map_tag category;

  const Number* numbers = nullptr; ///< null if there is no array: then all of them are 0

  friend Number get(const Numbers_map& map, std::size_t i)
  {
    return map.numbers ? map.numbers[i] : Number(0);
  }
};

} // namespace balanced_flow_python

#endif // BALANCED_FLOW_PYTHON_ARRAY_MAP_H
