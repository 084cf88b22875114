// SPDX-License-Identifier: GPL-3.0-or-later
#include "Experience.h"

#include "Block_result.h"

#include <algorithm>
#include <exception>
#include <filesystem>

namespace balanced_flow_blocks {

Experience Experience::before(const Manifest& manifest, std::size_t block)
{
  const std::size_t near = 16;
  Experience experience;
  if (manifest.settings.smoothing.k)
    experience.most_neighbors = *manifest.settings.smoothing.k;
  for (std::size_t i = block; i > 0 && block - i < near;) {
    try {
      if (!std::filesystem::exists(manifest.result_file(--i)))
        continue;
      const Block_result result(manifest, i);
      experience.halo_width = result.effort().halo_width;
      experience.set_neighbors(result.report().most_neighbors);
      break;
    }
    catch (const std::exception&) { // whoever needs this block will complain
    }
  }
  return experience;
}

void Experience::widen()
{
  const double most = 200.; // what is missing then is asked for where it is
  halo_width = (std::min)(1.15 * halo_width, most);
}

void Experience::set_neighbors(std::size_t number)
{
  most_neighbors = number + number / 4; // noise differs from place to place
}

} // namespace balanced_flow_blocks
