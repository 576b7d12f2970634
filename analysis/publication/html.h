// Building blocks of the report's page; every text that comes from a study is escaped here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foveola::analysis {

/// `text` for use between tags and inside quoted attributes; control characters become spaces.
std::string escape_html(std::string_view text);

struct HtmlHeading {
  std::string text;
  int columns = 1;  ///< More than one for the heading of a group.
};

/// A data table. Texts are plain and are escaped; the caption is HTML. The first column names the
/// rows. `groups` adds a row of headings above the columns' own.
struct HtmlTable {
  std::string caption_html;
  std::vector<HtmlHeading> groups;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  bool numeric = true;  ///< All columns but the first are numbers, aligned to the right.
};

std::string render(const HtmlTable& table);

/// A section with a heading; `content_html` is HTML, `title` plain.
std::string html_section(std::string_view title, std::string_view content_html);

}  // namespace foveola::analysis
