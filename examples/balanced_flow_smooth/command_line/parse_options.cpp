// SPDX-License-Identifier: GPL-3.0-or-later
#include "parse_options.h"

#include <vector>

namespace balanced_flow_smooth {

namespace options = boost::program_options;

options::parsed_options parse_options(int argc, char** argv,
                                      const options::options_description& known,
                                      const std::string& words)
{
  // without it, Boost takes the next word for an optional argument
  const auto without_argument = [&](std::vector<std::string>& left) {
    std::vector<options::option> parsed;
    const std::string& word = left.front();
    if (word.size() < 3 || word.compare(0, 2, "--") != 0 || word.find('=') != std::string::npos)
      return parsed;
    const options::option_description* option = known.find_nothrow(word.substr(2), true);
    if (!option || option->semantic()->min_tokens() != 0 || option->semantic()->max_tokens() == 0)
      return parsed;
    const std::string& name = option->long_name(); // it may be abbreviated
    options::option& own =
        parsed.emplace_back(name, std::vector<std::string>{name == "json"    ? json_without_file
                                                           : name == "relax" ? relax_without_count
                                                                             : man_without_date});
    own.original_tokens.push_back(word);
    left.erase(left.begin());
    return parsed;
  };
  options::positional_options_description positions;
  positions.add(words.c_str(), -1);
  return options::command_line_parser(argc, argv)
      .options(known)
      .positional(positions)
      .extra_style_parser(without_argument)
      .run();
}

} // namespace balanced_flow_smooth
