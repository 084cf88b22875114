// SPDX-License-Identifier: GPL-3.0-or-later
#include "print_manual.h"

#include "Option_name.h"

#include <algorithm>
#include <cctype>
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

std::string capitals(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::toupper(c)); });
  return text;
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

void print_help(std::ostream& out, const Manual_page& page, const Command_line& command_line)
{
  const char* before = "Usage: ";
  for (const std::string& line : page.synopsis) {
    out << before << page.name << ' ' << line << '\n';
    before = "       ";
  }
  for (const std::string& paragraph : page.description)
    out << '\n' << wrap(paragraph, 0);
  for (const Command_line::Option_group& group : command_line.groups)
    out << '\n' << group;
  for (const Manual_page::Section& section : page.sections) {
    if (!section.is_in_help)
      continue;
    out << '\n' << section.title << ":\n";
    for (const auto& [term, text] : section.terms)
      out << "  " << term << std::string(10 - term.size(), ' ') << wrap(text, 12);
    for (const std::string& paragraph : section.paragraphs)
      out << '\n' << wrap(paragraph, 0);
  }
}

void print_manual_page(std::ostream& out, const Manual_page& page, const Command_line& command_line,
                       const std::string& date)
{
  const std::string name = to_roff(page.name);
  out << ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n"
      << ".TH " << to_roff(capitals(page.name)) << " 1 \"" << date << "\" \"" << name << ' '
      << POINT_SET_FLOW_VERSION << "\" \"User Commands\"\n"
      << ".SH NAME\n"
      << name << " \\- " << to_roff(page.summary) << "\n.SH SYNOPSIS\n";
  const char* between = "";
  for (const std::string& line : page.synopsis) {
    out << between << ".B " << name << "\n" << to_roff(line) << '\n';
    between = ".br\n";
  }
  out << ".SH DESCRIPTION\n";
  between = "";
  for (const std::string& paragraph : page.description) {
    out << between << paragraph_to_roff(paragraph);
    between = ".PP\n";
  }
  print_options(out, command_line);
  for (const Manual_page::Section& section : page.sections) {
    out << ".SH " << capitals(section.title) << '\n';
    for (const auto& [term, text] : section.terms)
      out << ".TP\n.B " << to_roff(term) << '\n' << paragraph_to_roff(text);
    for (const std::string& paragraph : section.paragraphs)
      out << ".PP\n" << paragraph_to_roff(paragraph);
  }
  out << ".SH SEE ALSO\n"
      << "C. Xiao, Y. Miao, S. Liu and Q. Peng,\n"
      << ".I A dynamic balanced flow for filtering point\\-sampled geometry,\n"
      << "The Visual Computer 22, 2006.\n";
}

} // namespace balanced_flow_smooth
