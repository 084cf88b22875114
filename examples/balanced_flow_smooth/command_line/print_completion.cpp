// SPDX-License-Identifier: GPL-3.0-or-later
#include "print_completion.h"

#include "Option_name.h"

#include <algorithm>
#include <functional>

namespace balanced_flow_smooth {

namespace options = boost::program_options;

namespace {

typedef std::function<void(const Option_name& name, const options::option_description& option)>
    Visitor;

void for_each_option(const Command_line& command_line, const Visitor& visit)
{
  for (const Command_line::Option_group& group : command_line.groups)
    for (const auto& option : group.options())
      visit(Option_name(*option), *option);
}

/// The values of an option, with blanks between them; empty if there is no fixed choice.
std::string values_of(const options::option_description& option)
{
  const auto found = choices().find(option.long_name());
  std::string values;
  if (found != choices().end())
    for (const std::string& value : found->second)
      values += (values.empty() ? "" : " ") + value;
  return values;
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

void print_for_bash(std::ostream& out, const Command_line& command_line,
                    const Completed_program& program)
{
  std::string all, function = "_" + program.name;
  std::replace(function.begin(), function.end(), '-', '_');
  out << "# SPDX-License-Identifier: GPL-3.0-or-later\n"
      << function
      << "()\n{\n"
         "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  COMPREPLY=()\n"
         "  if [[ $cur == = ]]; then\n"
         "    cur=\n"
         "  elif [[ $prev == = ]]; then\n"
         "    prev=${COMP_WORDS[COMP_CWORD-2]}\n"
         "  fi\n"
         "  case $prev in\n";
  for_each_option(command_line, [&](const Option_name& name, const auto& option) {
    all += (all.empty() ? "" : " ") + name.long_name;
    if (name.argument.empty() || name.argument_is_optional)
      return;
    out << "    " << name.short_name << (name.short_name.empty() ? "" : "|") << name.long_name
        << ")\n      ";
    const std::string values = values_of(option);
    if (!values.empty())
      out << "COMPREPLY=($(compgen -W '" << values << "' -- \"$cur\"))\n      ";
    else if (name.argument == "DIR")
      out << "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- \"$cur\")\n      ";
    else
      out << "compopt +o default\n      ";
    out << "return ;;\n";
  });
  out << "  esac\n"
         "  if [[ $cur == -?* || $cur == - ]]; then\n"
         "    COMPREPLY=($(compgen -W '"
      << all << "' -- \"$cur\"))\n";
  if (!program.commands.empty())
    out << "  elif ((COMP_CWORD == 1)); then\n"
           "    COMPREPLY=($(compgen -W '"
        << joined(program.commands) << "' -- \"$cur\"))\n";
  out << "  fi\n"
         "} &&\n"
         "  complete -o default -F "
      << function << ' ' << program.name << '\n';
}

void print_for_zsh(std::ostream& out, const Command_line& command_line,
                   const Completed_program& program)
{
  out << "#compdef " << program.name
      << "\n# SPDX-License-Identifier: GPL-3.0-or-later\n"
         "_arguments -s";
  for_each_option(command_line, [&](const Option_name& name, const auto& option) {
    std::string text;
    for (const char c : option.description())
      text += c == '\'' ? "'\\''" : std::string(c == '[' || c == ']' || c == ':', '\\') + c;
    std::string value;
    if (!name.argument.empty()) {
      const std::string values = values_of(option);
      value = (name.argument_is_optional ? "::" : ":") + name.argument + ":" +
              (!values.empty()           ? "(" + values + ")"
               : name.argument == "DIR"  ? "_files -/"
               : name.argument == "FILE" ? "_files"
                                         : "");
    }
    const std::string suffix = name.argument.empty() ? "" : name.argument_is_optional ? "=-" : "=";
    out << " \\\n  ";
    if (!name.short_name.empty())
      out << "'(" << name.short_name << ' ' << name.long_name << ")'{" << name.short_name
          << (suffix.empty() ? "" : "+") << ',' << name.long_name << suffix << "}";
    else
      out << name.long_name << suffix;
    out << "'[" << text << ']' << value << "'";
  });
  if (!program.commands.empty())
    out << " \\\n  '1:command:(" << joined(program.commands) << ")'";
  out << " \\\n  '*:file:_files'\n";
}

void print_for_fish(std::ostream& out, const Command_line& command_line,
                    const Completed_program& program)
{
  out << "# SPDX-License-Identifier: GPL-3.0-or-later\n";
  if (!program.commands.empty())
    out << "complete -c " << program.name << " -n __fish_use_subcommand -f -a '"
        << joined(program.commands) << "'\n";
  for_each_option(command_line, [&](const Option_name& name, const auto& option) {
    std::string text;
    for (const char c : option.description())
      text += c == '\'' ? "\\'" : std::string(1, c);
    out << "complete -c " << program.name << " -l " << option.long_name();
    if (!name.short_name.empty())
      out << " -s " << name.short_name[1];
    const std::string values = values_of(option);
    if (!values.empty())
      out << " -x -a '" << values << "'";
    else if (name.argument == "DIR")
      out << " -x -a '(__fish_complete_directories)'";
    else if (!name.argument.empty() && !name.argument_is_optional)
      out << " -x";
    out << " -d '" << text << "'\n";
  });
}

} // namespace

void print_completion(std::ostream& out, const Command_line& command_line,
                      const Completed_program& program, const std::string& shell)
{
  if (shell == "bash")
    print_for_bash(out, command_line, program);
  else if (shell == "zsh")
    print_for_zsh(out, command_line, program);
  else
    print_for_fish(out, command_line, program);
}

} // namespace balanced_flow_smooth
