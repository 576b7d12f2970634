#include "analysis/publication/figures.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "analysis/publication/gnuplot.h"
#include "analysis/publication/rating_figures.h"
#include "analysis/publication/scene_figure.h"
#include "analysis/publication/survival_output.h"
#include "analysis/publication/time_figures.h"
#include "renderer/base/ordered_jobs.h"

namespace foveola::analysis {
namespace {

/// Blanks out when the PDF was made, so that the same study gives the same bytes; nothing moves,
/// since a PDF's table of contents counts bytes.
std::string without_date(std::string pdf) {
  const std::size_t begin = pdf.find("/CreationDate");
  const std::size_t end = begin == std::string::npos ? begin : pdf.find(')', begin);
  if (end != std::string::npos) {
    pdf.replace(begin, end + 1 - begin, end + 1 - begin, ' ');
  }
  return pdf;
}

/// Each waits for a gnuplot of its own.
int threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

}  // namespace

std::string rating_figure_name(const Measure& rating) { return "ratings_" + rating.id(); }

bool draws_participants(const StudyTables& tables) {
  return tables.set.participants.size() <= most_dots;
}

std::vector<Figure> draw_figures(const StudyTables& tables) {
  using Drawing = std::function<std::optional<Figure>()>;
  std::vector<Drawing> drawings = {[&] { return relative_figure(tables); },
                                   [&] { return relative_scene_figure(tables); },
                                   [&] { return seconds_figure(tables); }};
  for (const std::size_t mark : tables.set.times()) {
    drawings.emplace_back([&tables, mark] { return survival_figure(tables, mark); });
  }
  for (const std::size_t rating : tables.set.ratings()) {
    drawings.emplace_back([&tables, rating] { return rating_figure(tables, rating); });
  }
  std::vector<Figure> figures;
  OrderedJobs<std::optional<Figure>> jobs(drawings.size(), drawings.size(),
                                          [&](std::size_t index) { return drawings[index](); });
  jobs.run(threads(), [&](std::size_t /*index*/, std::optional<Figure> figure) {
    if (figure) {
      figures.push_back(*std::move(figure));
    }
    return true;
  });
  return figures;
}

std::vector<TextFile> files_of_figures(const std::vector<Figure>& figures) {
  constexpr std::size_t formats = 3;
  std::vector<TextFile> files;
  OrderedJobs<TextFile> drawings(formats * figures.size(), formats * figures.size(),
                                 [&](std::size_t index) -> TextFile {
                                   const Figure& figure = figures[index / formats];
                                   switch (index % formats) {
                                     case 0:
                                       return {figure.name + ".svg", figure.svg};
                                     case 1:
                                       return {figure.name + ".pdf", pdf_of(figure)};
                                     default:
                                       return {figure.name + ".png", png_of(figure)};
                                   }
                                 });
  drawings.run(threads(), [&](std::size_t /*index*/, TextFile file) {
    files.push_back(std::move(file));
    return true;
  });
  return files;
}

std::string pdf_of(const Figure& figure) {
  constexpr double units_per_inch = 96.0;
  const std::string terminal = fmt::format(
      "set terminal pdfcairo size {:.4f}in,{:.4f}in noenhanced font 'sans-serif,10.5' "
      "fontscale 1 linewidth 1 pointscale 1.2 background rgb 'white'\n",
      figure.width / units_per_inch, figure.height / units_per_inch);
  return without_date(run_gnuplot(terminal + figure.script));
}

std::string png_of(const Figure& figure) {
  const std::string terminal = fmt::format(
      "set terminal pngcairo size {},{} noenhanced font 'sans-serif,10.5' fontscale 2 "
      "linewidth 2 pointscale 2 background rgb 'white'\n",
      2 * figure.width, 2 * figure.height);
  return run_gnuplot(terminal + figure.script);
}

}  // namespace foveola::analysis
