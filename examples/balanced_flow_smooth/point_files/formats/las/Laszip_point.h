// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef POINT_FILES_LAS_LASZIP_POINT_H
#define POINT_FILES_LAS_LASZIP_POINT_H

#include "Bytes.h"
#include "Header.h"

#include <laszip/laszip_api.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace point_files::las {

/// From the points of LASzip to the bytes of a record and back, every bit of it
class Laszip_point {
  bool m_is_new; // format 6 to 10
  bool m_has_time, m_has_waveform;
  std::size_t m_colors; // channels
  std::size_t m_size;   // without extra bytes

public:
  explicit Laszip_point(unsigned format)
      : m_is_new(format >= 6), m_has_time(m_is_new || (format != 0 && format != 2)),
        m_has_waveform(format == 4 || format == 5 || format >= 9),
        m_colors(format == 8 || format == 10                                ? 4
                 : format == 2 || format == 3 || format == 5 || format == 7 ? 3
                                                                            : 0),
        m_size(smallest_record(format))
  {}

  void get(const laszip_point_struct& p, std::string& record) const
  {
    char* const r = record.data();
    put(r, p.X);
    put(r + 4, p.Y);
    put(r + 8, p.Z);
    put(r + 12, p.intensity);
    if (m_is_new)
      get_new(p, r);
    else
      get_old(p, r);
    char* at = r + (m_is_new ? 22 : 20);
    if (m_has_time)
      put(at, p.gps_time), at += 8;
    for (std::size_t c = 0; c < m_colors; ++c, at += 2)
      put(at, p.rgb[c]);
    if (m_has_waveform)
      std::copy(p.wave_packet, p.wave_packet + 29, at);
    std::copy(p.extra_bytes, p.extra_bytes + (record.size() - m_size), r + m_size);
  }

  void set(laszip_point_struct& p, const char* r, std::size_t record_size) const
  {
    p.X = las::get<std::int32_t>(r);
    p.Y = las::get<std::int32_t>(r + 4);
    p.Z = las::get<std::int32_t>(r + 8);
    p.intensity = las::get<std::uint16_t>(r + 12);
    if (m_is_new)
      set_new(p, r);
    else
      set_old(p, r);
    const char* at = r + (m_is_new ? 22 : 20);
    if (m_has_time)
      p.gps_time = las::get<double>(at), at += 8;
    for (std::size_t c = 0; c < m_colors; ++c, at += 2)
      p.rgb[c] = las::get<std::uint16_t>(at);
    if (m_has_waveform)
      std::copy(at, at + 29, reinterpret_cast<char*>(p.wave_packet));
    std::copy(r + m_size, r + record_size, reinterpret_cast<char*>(p.extra_bytes));
  }

private:
  static unsigned byte(const char* r, std::size_t i) { return las::get<std::uint8_t>(r + i); }

  static void get_old(const laszip_point_struct& p, char* r)
  {
    put(r + 14, std::uint8_t(p.return_number | p.number_of_returns << 3 |
                             p.scan_direction_flag << 6 | p.edge_of_flight_line << 7));
    put(r + 15, std::uint8_t(p.classification | p.synthetic_flag << 5 | p.keypoint_flag << 6 |
                             p.withheld_flag << 7));
    put(r + 16, p.scan_angle_rank);
    put(r + 17, p.user_data);
    put(r + 18, p.point_source_ID);
  }

  static void set_old(laszip_point_struct& p, const char* r)
  {
    p.return_number = byte(r, 14) & 7;
    p.number_of_returns = byte(r, 14) >> 3 & 7;
    p.scan_direction_flag = byte(r, 14) >> 6 & 1;
    p.edge_of_flight_line = byte(r, 14) >> 7 & 1;
    p.classification = byte(r, 15) & 31;
    p.synthetic_flag = byte(r, 15) >> 5 & 1;
    p.keypoint_flag = byte(r, 15) >> 6 & 1;
    p.withheld_flag = byte(r, 15) >> 7 & 1;
    p.scan_angle_rank = las::get<std::int8_t>(r + 16);
    p.user_data = las::get<std::uint8_t>(r + 17);
    p.point_source_ID = las::get<std::uint16_t>(r + 18);
  }

  static void get_new(const laszip_point_struct& p, char* r)
  {
    put(r + 14, std::uint8_t(p.extended_return_number | p.extended_number_of_returns << 4));
    put(r + 15, std::uint8_t(p.extended_classification_flags | p.extended_scanner_channel << 4 |
                             p.scan_direction_flag << 6 | p.edge_of_flight_line << 7));
    put(r + 16, p.extended_classification);
    put(r + 17, p.user_data);
    put(r + 18, p.extended_scan_angle);
    put(r + 20, p.point_source_ID);
  }

  static void set_new(laszip_point_struct& p, const char* r)
  {
    p.extended_point_type = 1;
    p.extended_return_number = byte(r, 14) & 15;
    p.extended_number_of_returns = byte(r, 14) >> 4 & 15;
    p.extended_classification_flags = byte(r, 15) & 15;
    p.extended_scanner_channel = byte(r, 15) >> 4 & 3;
    p.scan_direction_flag = byte(r, 15) >> 6 & 1;
    p.edge_of_flight_line = byte(r, 15) >> 7 & 1;
    p.extended_classification = las::get<std::uint8_t>(r + 16);
    p.user_data = las::get<std::uint8_t>(r + 17);
    p.extended_scan_angle = las::get<std::int16_t>(r + 18);
    p.point_source_ID = las::get<std::uint16_t>(r + 20);
    // LASzip compares them with those of the old formats, of which it does not write these bits
    p.synthetic_flag = byte(r, 15) & 1;
    p.keypoint_flag = byte(r, 15) >> 1 & 1;
    p.withheld_flag = byte(r, 15) >> 2 & 1;
    p.classification = byte(r, 16) < 32 ? byte(r, 16) & 31 : 0;
  }
};

} // namespace point_files::las

#endif // POINT_FILES_LAS_LASZIP_POINT_H
