// Building blocks of the report's page; every text that comes from a study is escaped here.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

/// `text` for use between tags and inside quoted attributes; control characters become spaces.
std::string escape_html(std::string_view text);

/// HTML for the start of every caption: its title, and before it whose data it shows. Both are
/// plain; an empty `notice` shows nothing.
std::string caption_html(std::string_view title, std::string_view notice);

/// A section with a heading; `content_html` is HTML, `title` plain.
std::string html_section(std::string_view title, std::string_view content_html);

}  // namespace foveola::analysis
