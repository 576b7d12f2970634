#include "analysis/publication/inline_svg.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "analysis/publication/figure_palette.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Removes every element `name`, which holds only text.
void remove_elements(std::string& svg, const std::string& name) {
  const std::string end_tag = "</" + name + ">";
  for (std::size_t begin = svg.find("<" + name + ">"); begin != std::string::npos;
       begin = svg.find("<" + name + ">", begin)) {
    const std::size_t end = std::min(svg.find(end_tag, begin), svg.size() - end_tag.size());
    svg.erase(begin, end + end_tag.size() - begin);
  }
}

/// The page's colour for one of the figure's; gnuplot writes "rgb(  0,114,178)", with or without
/// padding.
std::string themed_color(const std::string& color) {
  int red = 0;
  int green = 0;
  int blue = 0;
  if (std::sscanf(color.c_str(), "rgb(%d,%d,%d)", &red, &green, &blue) != 3) {
    return color;
  }
  const std::string rgb = fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
  const auto found = std::find_if(palette::all.begin(), palette::all.end(),
                                  [&](const FigureColor& entry) { return entry.rgb == rgb; });
  return found != palette::all.end() ? fmt::format("var({})", found->property) : color;
}

void theme_colors(std::string& tag) {
  replace_all(tag, "fill=\"#ffffff\"", "fill=\"none\"");
  replace_all(tag, "\"black\"", fmt::format("\"var({})\"", palette::ink.property));
  for (std::size_t begin = tag.find("rgb("); begin != std::string::npos;
       begin = tag.find("rgb(", begin + 1)) {
    const std::size_t end = tag.find(')', begin);
    if (end == std::string::npos) {
      return;
    }
    const std::size_t length = end + 1 - begin;
    tag.replace(begin, length, themed_color(tag.substr(begin, length)));
  }
}

void name_ids(std::string& tag, std::string_view id) {
  replace_all(tag, " id='", fmt::format(" id='{}-", id));
  replace_all(tag, " id=\"", fmt::format(" id=\"{}-", id));
  replace_all(tag, "href='#", fmt::format("href='#{}-", id));
}

}  // namespace

std::string inline_svg(std::string_view svg, std::string_view id, std::string_view description) {
  std::string rest(svg.substr(std::min(svg.find("<svg"), svg.size())));
  remove_elements(rest, "title");
  remove_elements(rest, "desc");
  replace_all(rest, "<svg ",
              fmt::format("<svg role=\"img\" aria-label=\"{}\" ", escape_html(description)));
  // Only tags are changed: a text between them may be a name from the study.
  std::string themed;
  std::size_t text_begin = 0;
  for (std::size_t begin = rest.find('<'); begin != std::string::npos;
       begin = rest.find('<', text_begin)) {
    const std::size_t end = std::min(rest.find('>', begin), rest.size() - 1);
    std::string tag = rest.substr(begin, end + 1 - begin);
    theme_colors(tag);
    name_ids(tag, id);
    themed += rest.substr(text_begin, begin - text_begin) + tag;
    text_begin = end + 1;
  }
  return themed + rest.substr(text_begin);
}

}  // namespace foveola::analysis
