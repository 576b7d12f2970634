// A table as people read it: a caption and texts, which HTML, LaTeX and the terminal set in their
// own ways.
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
  std::string note;   ///< Further sentences below or behind the title.
  std::vector<ColumnGroup> groups;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  bool is_numeric = true;  ///< All columns but the first are numbers, aligned to the right.
};

// `notice` says whose data a table shows, as "Simulated data"; empty for people's.

/// An element with the table in it; empty if there are no rows.
std::string html_of(const PrintedTable& table, std::string_view notice);

/// A table environment with the label tab:ID, as wide as its columns but no wider than the text:
/// what would be wider is set smaller. Begins with comments that say which packages it needs.
std::string latex_of(const PrintedTable& table, std::string_view notice);

/// The title, then the rows in aligned columns, then the note.
std::string plain_text_of(const PrintedTable& table, std::string_view notice);

}  // namespace foveola::analysis
