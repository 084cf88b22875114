// SPDX-License-Identifier: GPL-3.0-or-later
#include "print_manual.h"

#include "Manual.h"
#include "Option_name.h"

#include <cstddef>
#include <sstream>

namespace balanced_flow_smooth {

namespace {

/// Breaks a text into lines, with so many blanks before each but the first.
std::string wrap(const std::string& text, std::size_t indent)
{
  const std::size_t width = 80;
  std::istringstream words(text);
  std::string wrapped, word;
  std::size_t column = indent;
  while (words >> word) {
    if (column > indent && column + word.size() >= width) {
      wrapped += "\n" + std::string(indent, ' ');
      column = indent;
    }
    else if (column > indent)
      wrapped += ' ', ++column;
    wrapped += word;
    column += word.size();
  }
  return wrapped + "\n";
}

/// A line as the language of manual pages has it
std::string to_roff(const std::string& text)
{
  std::string roff;
  for (const char c : text)
    if (c == '\\')
      roff += "\\e";
    else if (c == '-')
      roff += "\\-";
    else if (c == '\'')
      roff += "\\(aq";
    else
      roff += c;
  return (!text.empty() && text[0] == '.' ? "\\&" : "") + roff;
}

/// A paragraph in the same language, in short lines
std::string paragraph_to_roff(const std::string& text)
{
  std::istringstream lines(wrap(text, 0));
  std::string roff, line;
  while (std::getline(lines, line))
    roff += to_roff(line) + '\n';
  return roff;
}

void print_options(std::ostream& out, const Command_line& command_line)
{
  out << ".SH OPTIONS\n";
  for (const Command_line::Option_group& group : command_line.groups) {
    std::ostringstream caption; // the only way to it
    caption << group;
    out << ".SS " << to_roff(caption.str().substr(0, caption.str().find(':'))) << '\n';
    for (const auto& option : group.options()) {
      const Option_name parts(*option);
      out << ".TP\n\\fB" << to_roff(parts.short_name)
          << (parts.short_name.empty() ? "" : "\\fR, \\fB") << to_roff(parts.long_name) << "\\fR";
      if (!parts.argument.empty())
        out << (parts.argument_is_optional ? "[=" : " ") << "\\fI" << to_roff(parts.argument)
            << "\\fR" << (parts.argument_is_optional ? "]" : "");
      out << '\n' << paragraph_to_roff(option->description());
    }
  }
}

} // namespace

void print_help(std::ostream& out, const Command_line& command_line)
{
  const char* before = "Usage: ";
  for (const std::string& line : manual::synopsis) {
    out << before << program_name << ' ' << line << '\n';
    before = "       ";
  }
  for (const std::string& paragraph : manual::description)
    out << '\n' << wrap(paragraph, 0);
  for (const Command_line::Option_group& group : command_line.groups)
    out << '\n' << group;
  const auto print_terms = [&](const char* title, const auto& terms) {
    out << '\n' << title << ":\n";
    for (const auto& [term, text] : terms)
      out << "  " << term << std::string(10 - term.size(), ' ') << wrap(text, 12);
  };
  print_terms("Formats", manual::formats);
  for (const std::string& paragraph : manual::on_formats)
    out << '\n' << wrap(paragraph, 0);
  print_terms("Exit status", manual::exit_status);
}

void print_manual_page(std::ostream& out, const Command_line& command_line, const std::string& date)
{
  const std::string name = to_roff(program_name);
  out << ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n"
      << ".TH BALANCED\\-FLOW\\-SMOOTH 1 \"" << date << "\" \"" << name << ' '
      << POINT_SET_FLOW_VERSION << "\" \"User Commands\"\n"
      << ".SH NAME\n"
      << name << " \\- " << to_roff(manual::summary) << "\n.SH SYNOPSIS\n";
  const char* between = "";
  for (const std::string& line : manual::synopsis) {
    out << between << ".B " << name << "\n" << to_roff(line) << '\n';
    between = ".br\n";
  }
  out << ".SH DESCRIPTION\n";
  between = "";
  for (const std::string& paragraph : manual::description) {
    out << between << paragraph_to_roff(paragraph);
    between = ".PP\n";
  }
  print_options(out, command_line);
  const auto print_terms = [&](const char* title, const auto& terms) {
    out << ".SH " << title << '\n';
    for (const auto& [term, text] : terms)
      out << ".TP\n.B " << to_roff(term) << '\n' << paragraph_to_roff(text);
  };
  print_terms("FORMATS", manual::formats);
  for (const std::string& paragraph : manual::on_formats)
    out << ".PP\n" << paragraph_to_roff(paragraph);
  print_terms("EXIT STATUS", manual::exit_status);
  print_terms("EXAMPLES", manual::examples);
  out << ".SH SEE ALSO\n"
      << "C. Xiao, Y. Miao, S. Liu and Q. Peng,\n"
      << ".I A dynamic balanced flow for filtering point\\-sampled geometry,\n"
      << "The Visual Computer 22, 2006.\n";
}

} // namespace balanced_flow_smooth
