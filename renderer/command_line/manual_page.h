// Writes a program's manual page, for section 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/command_line/command_description.h"

namespace foveola {

/// A paragraph, and the term above it that it explains, if any.
struct ManualEntry {
  std::string term;  ///< a variable, a file, an exit status; empty: none
  std::string text;
};

struct ManualSection {
  std::string title;  ///< in capitals
  std::vector<ManualEntry> entries;
};

/// A manual's text besides the command line's description.
struct ManualText {
  std::vector<std::string> description;  ///< paragraphs
  std::vector<ManualSection> sections;   ///< following the commands, in order
};

/// `text` escaped for roff, at any place of a line: "\-\-tone" for "--tone". Hyphens can be copied
/// into a shell, since descriptions name options and values.
std::string roff_text(std::string_view text);

/// The page in roff, for the macros `man` of groff and mandoc. Options of a command that the
/// program itself has too, such as --help, appear once, before the commands. version: "0.1.0".
std::string manual_page(const CommandDescription& program, const std::string& version,
                        const ManualText& text);

}  // namespace foveola
