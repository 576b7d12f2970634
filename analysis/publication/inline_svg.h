// Makes a gnuplot figure part of a page: its colours, its ids and its name for screen readers.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

/// `svg` from gnuplot as an element inside an HTML page: colours of figure_palette.h become the
/// page's custom properties and a white ground becomes none, so that the figure follows the page's
/// light or dark style; ids start with `id`, so that they do not clash with another figure's;
/// `description` is its accessible name.
std::string inline_svg(std::string_view svg, std::string_view id, std::string_view description);

}  // namespace foveola::analysis
