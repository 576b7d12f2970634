// Parts that the sections of the report share: pages, captions, figures, the baseline's name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/figures/figures.h"
#include "analysis/tables/printed_table.h"

namespace foveola::analysis {

/// The baseline as tables name it.
std::string baseline_label(const StudyTables& tables);

/// The plain text as a paragraph; nothing if it is empty.
std::string paragraph_html(const std::string& text);

/// "in this scene", "in these 5 scenes": those to which an interval over participants applies.
std::string in_these_scenes(const StudyTables& tables);

/// The sentence for figures that leave out the points of single participants.
std::string points_left_out();

/// The table as a part of the page, with a caption that says whose data it shows; empty if there
/// are no rows.
std::string table_html(const StudyTables& tables, const PrintedTable& table);

/// The figure of this name as a part of the page; empty if there is none. Texts are plain.
std::string figure_html(const StudyTables& tables, const std::vector<Figure>& figures,
                        std::string_view name, std::string_view title,
                        std::string_view explanation);

/// A whole page: what was studied, whose data it shows, then `content_html`. `page_name` says in a
/// few plain words what the page is.
std::string report_page(const StudyTables& tables, std::string_view page_name,
                        const std::string& content_html);

/// `svg` from gnuplot as an element inside an HTML page: colours of figure_palette.h become the
/// page's custom properties and a white ground becomes none, so that the figure follows the page's
/// light or dark style; ids start with `id`, so that they do not clash with another figure's;
/// `description` is its accessible name.
std::string inline_svg(std::string_view svg, std::string_view id, std::string_view description);

}  // namespace foveola::analysis
