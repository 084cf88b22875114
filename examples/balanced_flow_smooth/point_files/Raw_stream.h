// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_RAW_STREAM_H
#define POINT_FILES_RAW_STREAM_H

#include "Raw_file.h"
#include "Streamed_file.h"

#include <filesystem>
#include <memory>
#include <utility>

namespace point_files {

/// A file that is kept as its bytes, of which some records are a `Raw_file` at a time.
class Raw_stream : public Streamed_file {
  const Anatomy m_file;

public:
  /// \param file not its points, which are read when they are needed
  explicit Raw_stream(Anatomy file);

  void for_each_chunk(const Visitor& visit) const override;
  void write(const Target& target, const New_points& points) const override;

private:
  template <typename Visit>
  void for_each_piece(const Visit& visit) const;
  Anatomy piece(const Block& block, const Place& first, const Place& last, std::size_t begin,
                std::size_t size) const;
  Place skip(const Place& place, std::size_t number_of_records) const;
};

/// Sets the functions of a format that read its files.
/// \tparam dissect finds out what is in the bytes of a file
template <Anatomy (*dissect)(Bytes, const Read_options&)>
void set_readers(Format& format)
{
  format.read = [](Bytes bytes, const Read_options& options) -> std::unique_ptr<Point_file> {
    return std::make_unique<Raw_file>(dissect(std::move(bytes), options));
  };
  format.stream = [](const std::filesystem::path& path,
                     const Read_options& options) -> std::unique_ptr<Streamed_file> {
    const Bytes bytes = Bytes::of_file(path);
    refuse_wide_characters(bytes);
    return std::make_unique<Raw_stream>(dissect(bytes, options));
  };
}

} // namespace point_files

#endif // POINT_FILES_RAW_STREAM_H
