// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_FORMAT_H
#define POINT_FILES_FORMAT_H

#include "Bytes.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace point_files {

class Point_file;
class Streamed_file;
struct Target;

/// What becomes of points that are none, with coordinates that are not finite or all 0. By default
/// they are kept where the format has a meaning for them, and are an error elsewhere.
enum class Invalid { BY_FORMAT, KEEP, DROP, ERROR };

/// What readers are told beside the bytes
struct Read_options {
  bool with_normals = false;        // whether normals are wanted even if there are none in the file
  std::vector<std::string> columns; // the names of columns of text; empty if the file tells them
  Invalid invalid = Invalid::BY_FORMAT;
  bool zeros_are_invalid = false; // also where the format does not say so
};

/// A format of point files, and all that is to be known of it outside of its own file in the folder
/// `formats`. Formats are compared by their address in `all_formats()`.
struct Format {
  std::string name;                    // of options and reports, and the usual extension
  std::vector<std::string> extensions; // other ones
  std::string family;          // within it, a file changes its format and nothing else is lost
  std::string magic;           // the first bytes of all files; empty if they differ
  std::string library;         // the optional one that it needs; empty if there is none
  std::string package;         // where that is found
  std::string columns_warning; // for files of other formats that have columns
  bool adds_normals = true;    // whether its own files can get normals
  bool has_columns = false;    // whether its files may be told the names of their columns

  /// Whether bytes look like a file of this format: those with its magic if it has one, those without
  /// the magic of any format if not; may be null.
  bool (*recognizes)(const Bytes& bytes) = nullptr;

  /// Makes a file of its bytes; null if the program was built without the library.
  std::unique_ptr<Point_file> (*read)(Bytes bytes, const Read_options& options) = nullptr;

  /// The same from a file on the disk, for those who need not have all of its bytes; may be null.
  std::unique_ptr<Point_file> (*read_path)(const std::filesystem::path& path,
                                           const Read_options& options) = nullptr;

  /// Opens a file on the disk without reading its points; null if this one does not allow it. May be null.
  std::unique_ptr<Streamed_file> (*stream)(const std::filesystem::path& path,
                                           const Read_options& options) = nullptr;

  /// Writes the points, normals and columns of a file of another family.
  void (*write)(const Target& target, const Point_file& file) = nullptr;
};

inline bool are_of_one_family(const Format& a, const Format& b) { return a.family == b.family; }

/// The table of all formats
const std::vector<Format>& all_formats();

/// The format of that name or extension, in any case of letters; null if there is none.
const Format* find_format(std::string name);

/// The format that the extension of a name tells; throws `std::runtime_error` if it tells none.
const Format& format_of(const std::filesystem::path& path);

/// The format that the magic tells with which the bytes begin; null if there is none.
const Format* format_with_magic(const Bytes& bytes);

/// Guesses the format from how a file begins: text is XYZ if no other format recognizes it. Throws
/// `std::runtime_error` if the bytes are no text, either.
const Format& format_of_bytes(const Bytes& bytes);

/// Throws `std::runtime_error` if this build has not the library that the format needs.
void check_support(const Format& format);

/// Throws `std::runtime_error`, which says that this build has not a library that something needs.
/// \param package where the library is found
[[noreturn]] void fail_without(const std::string& library, const std::string& package,
                               const std::string& what);

} // namespace point_files

#endif // POINT_FILES_FORMAT_H
