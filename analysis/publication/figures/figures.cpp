#include "analysis/publication/figures/figures.h"

#include <functional>
#include <optional>
#include <utility>

#include "analysis/publication/figures/figure_drawing.h"
#include "analysis/publication/figures/rating_figures.h"
#include "analysis/publication/figures/scene_figure.h"
#include "analysis/publication/figures/time_figures.h"
#include "renderer/base/work/ordered_jobs.h"
#include "renderer/base/work/parallel.h"

namespace foveola::analysis {
std::string rating_figure_name(const Measure& rating) { return "ratings_" + rating.id(); }

bool draws_participants(const StudyTables& tables) {
  return tables.set.participants.size() <= max_dots;
}

std::vector<Figure> draw_figures(const StudyTables& tables) {
  using Drawing = std::function<std::optional<Figure>()>;
  std::vector<Drawing> drawings = {[&] { return relative_figure(tables); },
                                   [&] { return relative_scene_figure(tables); },
                                   [&] { return seconds_figure(tables); }};
  for (const std::size_t mark : tables.set.marks()) {
    drawings.emplace_back([&tables, mark] { return survival_figure(tables, mark); });
  }
  for (const std::size_t rating : tables.set.ratings()) {
    drawings.emplace_back([&tables, rating] { return rating_figure(tables, rating); });
  }
  const bool has_letters = has_font();
  std::vector<Figure> figures;
  OrderedJobs<std::optional<Figure>> jobs(drawings.size(), drawings.size(),
                                          [&](std::size_t index) { return drawings[index](); });
  jobs.run(usable_cores(), [&](std::size_t /*index*/, std::optional<Figure> figure) {
    if (figure) {
      figures.push_back(*std::move(figure));
      if (!has_letters) {
        figures.back().pdf.clear();
        figures.back().png.clear();
      }
    }
    return true;
  });
  return figures;
}

std::vector<TextFile> files_of_figures(const std::vector<Figure>& figures) {
  std::vector<TextFile> files;
  for (const Figure& figure : figures) {
    files.push_back({figure.name + ".svg", figure.svg});
    if (!figure.pdf.empty()) {
      files.push_back({figure.name + ".pdf", figure.pdf});
      files.push_back({figure.name + ".png", figure.png});
    }
  }
  return files;
}

}  // namespace foveola::analysis
