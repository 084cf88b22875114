// SPDX-License-Identifier: GPL-3.0-or-later
#include "Record_cursor.h"

namespace point_files {

const std::vector<Field>* Text_cursor::next()
{
  const std::size_t width = m_properties.size();
  m_words.clear();
  for (std::size_t wanted = (std::min)(width, std::size_t(1)); m_words.size() < wanted;) {
    Field line;
    if (!m_lines.next(line))
      return nullptr;
    m_lines.append_words(line, m_words);
    if (m_words.size() >= wanted || !m_style.lines_may_end)
      wanted = m_has_lists ? join_lists() : width;
    if (!m_style.lines_may_end)
      break;
  }
  const std::vector<Field>& fields = m_has_lists ? m_fields : m_words;
  if (fields.size() != width)
    m_lines.fail(std::to_string(fields.size()) + " columns, but " + std::to_string(width) +
                 " are expected");
  return &fields;
}

/// Makes one field of the words of each list.
/// \return how many words the record has at least
std::size_t Text_cursor::join_lists()
{
  m_fields.clear();
  const std::size_t width = m_properties.size();
  std::size_t at = 0;
  for (std::size_t i = 0; i < width; ++i) {
    if (at >= m_words.size())
      return at + width - i;
    const Property& property = m_properties[i];
    Field field = m_words[at++];
    if (property.count_type) {
      const double count = m_lines.number(field);
      const double left = m_style.lines_may_end ? double(m_lines.place().bytes->size())
                                                : double(m_words.size() - at);
      if (!(count >= 0. && count <= left))
        m_lines.fail("the list " + property.name + " is not complete");
      at += std::size_t(count);
      if (at > m_words.size())
        return at + width - i - 1;
      field.end = m_words[at - 1].end;
    }
    m_fields.push_back(field);
  }
  const std::size_t complete = at;
  while (at != m_words.size()) // too many: counted by the caller
    m_fields.push_back(m_words[at++]);
  return complete;
}

const std::vector<Field>* Binary_cursor::next()
{
  std::size_t at = m_place.at;
  for (std::size_t i = 0; i < m_fields.size(); ++i) {
    const std::optional<std::size_t> end = find_end(*m_place.bytes, m_properties[i], at, m_swapped);
    if (!end)
      return nullptr;
    m_fields[i] = {at, *end};
    at = *end;
  }
  m_place.at = at;
  return &m_fields;
}

std::optional<std::size_t> Binary_cursor::find_end(const Bytes& bytes, const Property& property,
                                                   std::size_t at, bool swapped)
{
  double count = 1.;
  if (property.count_type) {
    const std::size_t size = size_of(*property.count_type);
    if (bytes.size() - at < size)
      return std::nullopt;
    count = from_bytes(*property.count_type, bytes.data() + at, swapped);
    at += size;
  }
  const std::size_t size = size_of(property.type);
  if (!(count >= 0. && count <= double((bytes.size() - at) / size)))
    return std::nullopt;
  return at + std::size_t(count) * size;
}

} // namespace point_files
