#include "analysis/tables/html.h"

#include <fmt/format.h>

namespace foveola::analysis {
std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

std::string caption_html(std::string_view title, std::string_view notice) {
  const std::string tag =
      notice.empty() ? "" : fmt::format("<span class=\"tag\">{}</span>", escape_html(notice));
  return fmt::format("{}<strong>{}</strong> ", tag, escape_html(title));
}

std::string html_section(std::string_view title, std::string_view content_html) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escape_html(title), content_html);
}

}  // namespace foveola::analysis
