// A table for readers: a caption and texts, which HTML, LaTeX and the terminal format in their own
// ways.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foveola::analysis {

/// A heading above the headings of several columns.
struct ColumnGroup {
  std::string heading;
  int columns = 1;
};

/// Plain texts in UTF-8. The first column names the rows.
struct PrintedTable {
  std::string id;     ///< Also the label in LaTeX.
  std::string title;  ///< A short sentence, with its full stop.
  std::string note;   ///< Further sentences below or after the title.
  std::vector<ColumnGroup> groups;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  bool is_numeric = true;  ///< Whether all columns but the first are numbers, aligned to the right.
};

// `notice` says whose data a table shows, as "Simulated data"; empty for people's.

/// Returns an element with the table; empty if there are no rows.
std::string html_of(const PrintedTable& table, std::string_view notice);

/// Returns a table environment with the label tab:ID, at most as wide as the text: wider tables are
/// set smaller. Begins with comments on its packages.
std::string latex_of(const PrintedTable& table, std::string_view notice);

/// Returns the title, then the rows in aligned columns, then the note.
std::string plain_text_of(const PrintedTable& table, std::string_view notice);

}  // namespace foveola::analysis
