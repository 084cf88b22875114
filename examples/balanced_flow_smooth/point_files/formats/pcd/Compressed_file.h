// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_PCD_COMPRESSED_FILE_H
#define POINT_FILES_PCD_COMPRESSED_FILE_H

#include "../../Raw_file.h"
#include "Header.h"

#include <string>

namespace point_files::pcd {

// Compressed points are not records one after the other, but fields: all values of the first, all of the
// second, and so on.

/// Makes records of the points of a compressed file; what is before and behind them stays. Throws
/// `std::runtime_error` if they are not as many as the header says.
/// \param header of the file; learns whether the padding is left out
std::string decompress(const Bytes& bytes, Header& header);

/// A file whose points are compressed, and were made records to be smoothed.
class Compressed_file : public Raw_file {
  Bytes m_compressed; // as it was
  bool m_leaves_out_padding;

public:
  Compressed_file(Bytes compressed, Anatomy records, bool leaves_out_padding);

  void write(const Target& target) const override;
};

} // namespace point_files::pcd

#endif // POINT_FILES_PCD_COMPRESSED_FILE_H
