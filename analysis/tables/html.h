// Builds parts of the report's page, and escapes every text that comes from a study.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

/// Escapes `text` for use between tags and inside quoted attributes; control characters become
/// spaces.
std::string escape_html(std::string_view text);

/// Returns the HTML of a caption's beginning: whose data it shows, then its title. Both are plain;
/// an empty `notice` shows nothing.
std::string caption_html(std::string_view title, std::string_view notice);

/// Returns a section with a heading; `content_html` is HTML, `title` plain.
std::string html_section(std::string_view title, std::string_view content_html);

}  // namespace foveola::analysis
