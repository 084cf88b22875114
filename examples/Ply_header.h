// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef BALANCED_FLOW_EXAMPLES_PLY_HEADER_H
#define BALANCED_FLOW_EXAMPLES_PLY_HEADER_H

#include <cstddef>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

struct Ply_header {
  bool binary = true, normals = false;
  int digits = 9; // enough for the numbers in it
};

/// Reads from the header of a PLY file what CGAL's reader does not tell, and refuses what it takes
/// for granted: coordinates of other types crash it, unknown types shift all values behind them,
/// properties with the names of its own ones are lost.
inline Ply_header read_ply_header(std::istream& in)
{
  Ply_header header;
  const std::string numbers = " char uchar short ushort int uint float double "
                              "int8 uint8 int16 uint16 int32 uint32 float32 float64 ";
  const auto file_size = static_cast<std::size_t>(in.seekg(0, std::ios::end).tellg());
  in.seekg(0);
  std::map<std::string, std::string> types = {{"index", ""}, {"point", ""}, {"normal", ""}};
  bool of_points = false, has_elements = false;
  for (;;) {
    std::string line, keyword, type, name;
    if (!std::getline(in, line))
      throw std::runtime_error("this is not a complete PLY file");
    std::istringstream words(line);
    words >> keyword >> type >> name;
    if (keyword == "end_header")
      break;
    if (keyword == "format")
      header.binary = type != "ascii";
    else if (keyword == "element") {
      of_points = type == "vertex" || type == "vertices";
      has_elements = true;
      if (name.empty() || name.find_first_not_of("0123456789") != name.npos)
        throw std::runtime_error("there is no number of elements in \"" + line + "\"");
      std::size_t count = 0;
      if (!(std::istringstream(name) >> count) || count > file_size) // before CGAL reserves memory
        throw std::runtime_error("the file is too short for " + name +
                                 (of_points ? " points" : " times " + type));
      if (!of_points)
        std::cerr << "warning: only the points are kept, not the PLY element " << type << std::endl;
    }
    else if (keyword == "property" && !has_elements)
      throw std::runtime_error("\"" + line + "\" comes before any element");
    else if (keyword == "property" && type == "list") {
      if (of_points)
        std::cerr << "warning: lists are not kept, as in \"" << line << "\"" << std::endl;
    }
    else if (keyword == "property") {
      if (numbers.find(" " + type + " ") == std::string::npos)
        throw std::runtime_error("the type in \"" + line + "\" is not known");
      if (type == "float32" || type == "float64")
        type = type == "float32" ? "float" : "double";
      if (of_points && !types.emplace(name, type).second)
        throw std::runtime_error("the property name \"" + name + "\" is taken: rename it");
      if (of_points && type == "double")
        header.digits = 17;
    }
    else if (keyword != "ply" && keyword != "comment" && keyword != "obj_info" && !keyword.empty())
      throw std::runtime_error("\"" + line + "\" is not known in the header of a PLY file");
  }

  const std::string real = types["x"];
  if ((real != "float" && real != "double") || types["y"] != real || types["z"] != real)
    throw std::runtime_error(
        "x, y and z must be properties of type float or double, all of the same");
  std::size_t normals = 0, usable = 0;
  for (const char* name : {"nx", "ny", "nz"}) {
    normals += types.count(name);
    usable += types[name] == "float" || (types[name] == "double" && real == "double");
  }
  if (normals != 0 && usable != 3)
    throw std::runtime_error("nx, ny and nz must be there together, with the type of x, y and z");
  header.normals = normals != 0;
  return header;
}

#endif // BALANCED_FLOW_EXAMPLES_PLY_HEADER_H
