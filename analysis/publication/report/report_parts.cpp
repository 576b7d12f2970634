#include "analysis/publication/report/report_parts.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figures/figure_drawing.h"
#include "analysis/publication/report/report_style.h"
#include "analysis/tables/html.h"
#include "renderer/base/build_info.h"

namespace foveola::analysis {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Removes every element `name`; its content must be text.
void remove_elements(std::string& svg, const std::string& name) {
  const std::string end_tag = "</" + name + ">";
  for (std::size_t begin = svg.find("<" + name + ">"); begin != std::string::npos;
       begin = svg.find("<" + name + ">", begin)) {
    const std::size_t end = std::min(svg.find(end_tag, begin), svg.size() - end_tag.size());
    svg.erase(begin, end + end_tag.size() - begin);
  }
}

/// Returns the page's colour for a figure's; gnuplot writes "rgb( 0,114,178)", with or without
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

std::string methods_in_words(const StudyTables& tables) {
  std::vector<std::string> methods;
  for (const std::string& method : tables.set.methods) {
    const std::string_view meaning = method_meaning(method);
    methods.push_back(meaning.empty() ? method
                                      : fmt::format("{} ({})", method_label(method), meaning));
  }
  return comma_list(methods);
}

std::string header_html(const StudyTables& tables, std::string_view page_name) {
  const std::string& title =
      tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title;
  const std::string warning = data_warning(tables);
  std::string html = fmt::format(
      "<header>\n<p class=\"eyebrow\">{}</p>\n<h1>{}</h1>\n{}", escape_html(page_name),
      escape_html(title),
      warning.empty()
          ? ""
          : fmt::format("<p class=\"notice\" role=\"note\">{}</p>\n", escape_html(warning)));
  const auto fact = [&](std::string_view term, const std::string& value_html) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, value_html);
  };
  html += "<dl class=\"facts\">\n";
  fact("Protocol", escape_html(tables.protocol_name));
  fact("SHA-256 of the protocol",
       fmt::format("<code>{}</code>", escape_html(tables.protocol_sha256)));
  fact("Analysed", escape_html(participants_in_words(tables)));
  fact("Scenes", escape_html(comma_list(tables.set.scenes)));
  fact("Methods",
       escape_html(methods_in_words(tables) + "; compared with " + baseline_label(tables)));
  return html + "</dl>\n</header>\n";
}

/// The line about the data at the foot of every printed page.
std::string page_mark(const std::string& notice) {
  return notice.empty() ? ""
                        : fmt::format("<p class=\"page-mark\" aria-hidden=\"true\">{}</p>\n",
                                      escape_html(notice));
}

}  // namespace

std::string baseline_label(const StudyTables& tables) {
  return method_label(tables.set.methods[baseline]);
}

std::string paragraph_html(const std::string& text) {
  return text.empty() ? "" : fmt::format("<p>{}</p>\n", escape_html(text));
}

std::string in_these_scenes(const StudyTables& tables) {
  const std::size_t scenes = tables.set.scenes.size();
  return scenes == 1 ? "in this scene" : fmt::format("in these {} scenes", scenes);
}

std::string points_left_out() {
  return fmt::format(
      "With more than {} participants, the points of single participants are left out.", max_dots);
}

std::string table_html(const StudyTables& tables, const PrintedTable& table) {
  return html_of(table, data_notice(tables));
}

std::string figure_html(const StudyTables& tables, const std::vector<Figure>& figures,
                        std::string_view name, std::string_view title,
                        std::string_view explanation) {
  const auto figure = std::ranges::find(figures, name, &Figure::name);
  if (figure == figures.end()) {
    return "";
  }
  const std::string notice = data_notice(tables);
  const std::string description =
      fmt::format("{}{}{} The table has the numbers.", title, notice.empty() ? "" : " ", notice);
  return fmt::format(
      "<figure>\n<div class=\"scroll\" role=\"group\" aria-label=\"Figure\" "
      "tabindex=\"0\">{}</div>\n<figcaption>{}{}</figcaption>\n</figure>\n",
      inline_svg(figure->svg, figure->name, description), caption_html(title, data_notice(tables)),
      escape_html(explanation));
}

std::string report_page(const StudyTables& tables, std::string_view page_name,
                        const std::string& content_html) {
  const std::string& title =
      tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title;
  const std::string notice = data_notice(tables);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}{} – {}</title>\n<link rel=\"icon\" href=\"data:,\">\n"
      "<style>{}</style>\n</head>\n<body>\n"
      "{}{}<main>\n{}</main>\n"
      "<footer>Foveola {}. The numbers are in the CSV files beside this report, at full "
      "precision.</footer>\n</body>\n</html>\n",
      escape_html(title), notice.empty() ? "" : escape_html(" (" + notice + ")"),
      escape_html(page_name), report_style(), page_mark(notice), header_html(tables, page_name),
      content_html, build_info().version);
}

std::string inline_svg(std::string_view svg, std::string_view id, std::string_view description) {
  std::string rest(svg.substr(std::min(svg.find("<svg"), svg.size())));
  remove_elements(rest, "title");
  remove_elements(rest, "desc");
  replace_all(rest, "<svg ",
              fmt::format("<svg role=\"img\" aria-label=\"{}\" ", escape_html(description)));
  // Only tags are changed: text between them may be a name from the study.
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
