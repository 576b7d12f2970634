#include "renderer/commands/bench_equation7.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/print.h"
#include "renderer/commands/bench_facts.h"
#include "renderer/view/equation7_errors.h"

namespace foveola {
namespace {

struct Figure {
  std::string what;
  double value = 0.0;
  int decimals = 0;
  std::string_view unit;
  std::string where;           ///< of a largest error; empty for others
  std::string_view published;  ///< what the paper says of it; empty if nothing
};

constexpr double to_percent = 100.0;

std::string place_of(const LargestError& largest) {
  return fmt::format("at u = {:.4f}, {:.4f} deg", largest.u, largest.eccentricity_deg);
}

std::vector<Figure> figures_of_equation7() {
  const Equation7Errors errors = equation7_errors();
  constexpr std::string_view largest = "1.8 % (maximum approximation error)";
  constexpr std::string_view integral = "< 0.04 % (integral of the difference)";
  const double mean_deg = errors.mean_radius_deg;
  return {
      {"equation 7, radius before its jump at u = 0.0965", errors.gap_begin_deg, 4, "deg", "", ""},
      {"equation 7, radius after its jump", errors.gap_end_deg, 4, "deg", "", ""},
      {"equation 7, radius at u = 1", errors.last_radius_deg, 2, "deg", "", "80 deg (upper limit)"},
      {"largest error of the radius, relative", to_percent * errors.radius_relative.error, 3, "%",
       place_of(errors.radius_relative), largest},
      {"largest error of the radius", errors.radius_deg.error, 4, "deg",
       place_of(errors.radius_deg), ""},
      {"largest error of the density, relative, outside the jump",
       to_percent * errors.density_relative.error, 2, "%", place_of(errors.density_relative),
       largest},
      {"largest error of the share of samples within a radius", to_percent * errors.share.error, 3,
       "%", place_of(errors.share), largest},
      {"mean radius, exact", mean_deg, 4, "deg", "", ""},
      {"mean absolute difference of the radius", errors.radius_difference_deg, 5, "deg", "", ""},
      {"mean absolute difference over the mean radius",
       to_percent * errors.radius_difference_deg / mean_deg, 4, "%", "", integral},
      {"mean difference over the mean radius",
       to_percent * errors.signed_radius_difference_deg / mean_deg, 4, "%", "", integral},
      {"mean absolute relative difference of the radius",
       to_percent * errors.relative_radius_difference, 4, "%", "", integral},
      {"integral of the densities' absolute difference", to_percent * errors.density_difference, 3,
       "%", "", integral},
      {"share of samples within 5.79 deg, exact", to_percent * errors.exact_foveal_share, 4, "%",
       "", ""},
      {"share of samples within 5.79 deg, equation 7", to_percent * errors.foveal_share, 4, "%", "",
       "9.65 % (where equation 7 switches)"}};
}

std::vector<Figure> figures_of_equation5() {
  const Equation5Errors errors = equation5_errors();
  return {{"equation 5, jump at 5.79 deg", errors.jump, 3, "deg^2", "", ""},
          {"normaliser G(80), exact", errors.exact_normaliser, 2, "deg^2", "", ""},
          {"normaliser G(80), by equation 5 as printed", errors.normaliser, 2, "deg^2", "", ""}};
}

std::vector<Figure> figures() {
  std::vector<Figure> all = figures_of_equation7();
  const std::vector<Figure> more = figures_of_equation5();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void print_table() {
  const auto print_row = [](std::string_view what, std::string_view figure,
                            std::string_view published) {
    print_text("{:<57} {:<38} {}\n", what, figure, published.empty() ? "-" : published);
  };
  print_row("what", "the program's figure", "the paper's");
  for (const Figure& figure : figures()) {
    print_row(figure.what,
              fmt::format("{:.{}f} {}{}{}", figure.value, figure.decimals, figure.unit,
                          figure.where.empty() ? "" : " ", figure.where),
              figure.published);
  }
  print_text(
      "The paper (section 3) does not say of what its two errors are: each reading of them stands "
      "beside its claim.\n");
}

void print_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Figure& figure : figures()) {
    list.push_back({{"what", figure.what},
                    {"value", figure.value},
                    {"unit", figure.unit},
                    {"where", figure.where},
                    {"published", figure.published}});
  }
  nlohmann::ordered_json json = bench_facts();
  json["figures"] = std::move(list);
  print_text("{}\n", json.dump(2));
}

}  // namespace

void add_bench_equation7(CLI::App& bench) {
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "equation7",
      "Compute how far the paper's equation 7, by which fv-paper samples, is from the exact "
      "inverse, by which fv does, beside what the paper says of it");
  command->add_flag("--json", *as_json, "Print the figures as JSON");
  command->footer("Example: foveola bench equation7");
  command->callback([as_json] { *as_json ? print_json() : print_table(); });
}

}  // namespace foveola
