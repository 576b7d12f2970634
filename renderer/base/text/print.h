// Prints to standard output and standard error; all text of the program goes through it.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace foveola {

/// Writes `text`, escaped(), to stdout or stderr. Throws Error if standard output fails; failures
/// of standard error are ignored.
void print_escaped(std::FILE* stream, std::string_view text);

/// print_escaped of the values, formatted.
template <typename... Values>
void print_text(std::FILE* stream, fmt::format_string<Values...> format, Values&&... values) {
  print_escaped(stream, fmt::format(format, std::forward<Values>(values)...));
}

/// The same to standard output.
template <typename... Values>
void print_text(fmt::format_string<Values...> format, Values&&... values) {
  print_text(stdout, format, std::forward<Values>(values)...);
}

/// Print each text, as printable() has it, on a line of standard error, after "foveola: note: " or
/// "foveola: warning: ".
void print_notes(const std::vector<std::string>& notes);
void print_warnings(const std::vector<std::string>& warnings);

/// Throws Error if any earlier print to standard output could not be written.
void finish_printing();

/// Reserves the descriptors of closed standard streams. Otherwise the next opened file would get
/// one, and printed text would be written into it. To be called before files are opened.
void hold_closed_streams();

}  // namespace foveola
