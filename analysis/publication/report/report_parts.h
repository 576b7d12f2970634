// Parts that the report's sections share: pages, captions, figures, the baseline's name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/figures/figures.h"
#include "analysis/tables/printed_table.h"

namespace foveola::analysis {

std::string baseline_label(const StudyTables& tables);

/// Returns the plain text as a paragraph; empty if it is empty.
std::string paragraph_html(const std::string& text);

/// Returns "in this scene" or "in these 5 scenes": the scenes to which an interval over
/// participants applies.
std::string in_these_scenes(const StudyTables& tables);

/// Returns the note of figures without the points of single participants.
std::string points_left_out();

/// Returns the table as a part of the page, with a caption that says whose data it shows; empty if
/// it has no rows.
std::string table_html(const StudyTables& tables, const PrintedTable& table);

/// Returns the named figure as a part of the page; empty if there is none. Texts are plain.
std::string figure_html(const StudyTables& tables, const std::vector<Figure>& figures,
                        std::string_view name, std::string_view title,
                        std::string_view explanation);

/// Returns a whole page: the study's facts, whose data it shows, then `content_html`. `page_name`:
/// the page's title in a few plain words.
std::string report_page(const StudyTables& tables, std::string_view page_name,
                        const std::string& content_html);

/// Returns `svg` from gnuplot as an element of an HTML page. Colours of figure_palette.h become the
/// page's custom properties and a white ground is removed, so that the figure follows the page's
/// light or dark style. Ids start with `id`, so that figures do not clash. `description`: its
/// accessible name.
std::string inline_svg(std::string_view svg, std::string_view id, std::string_view description);

}  // namespace foveola::analysis
