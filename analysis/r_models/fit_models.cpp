#include "analysis/r_models/fit_models.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>
#include <map>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "renderer/base/transformed.h"
#include "renderer/base/work/programs.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

constexpr const char* models_file = "r_models.csv";
constexpr const char* versions_file = "r_versions.csv";

[[noreturn]] void fail(const std::string& where, const std::string& what) {
  throw Error(where, what, "report this fault: models.R writes this file for foveola");
}

class NamedRow {
 public:
  NamedRow(const CsvRow& heading, const CsvRow& row, const std::string& where) : where_(where) {
    if (row.size() != heading.size()) {
      fail(where,
           fmt::format("a row has {} fields, but the heading {}", row.size(), heading.size()));
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      fields_[heading[i]] = row[i];
    }
  }

  const std::string& text(const std::string& column) const {
    const auto found = fields_.find(column);
    if (found == fields_.end()) {
      fail(where_, fmt::format("has no column {}", column));
    }
    return found->second;
  }

  /// Returns a number; empty for an empty field. R writes infinite numbers as Inf and -Inf.
  std::optional<double> number(const std::string& column) const {
    const std::string& digits = text(column);
    if (digits.empty()) {
      return std::nullopt;
    }
    if (digits == "Inf" || digits == "-Inf") {
      const double infinity = std::numeric_limits<double>::infinity();
      return digits.front() == '-' ? -infinity : infinity;
    }
    double value = 0.0;
    const char* end = digits.data() + digits.size();
    if (std::from_chars(digits.data(), end, value).ptr != end) {
      fail(where_, fmt::format("\"{}\" in the column {} is not a number", digits, column));
    }
    return value;
  }

  std::size_t count(const std::string& column) const {
    const std::optional<double> value = number(column);
    constexpr double most = 1e15;
    if (!value || *value < 0.0 || *value > most) {
      fail(where_, fmt::format("\"{}\" in the column {} is not a count", text(column), column));
    }
    return static_cast<std::size_t>(*value);
  }

  EffectScale scale() const {
    const std::string& name = text("scale");
    for (const EffectScale scale :
         {EffectScale::ratio, EffectScale::odds_ratio, EffectScale::points}) {
      if (name == name_of(scale)) {
        return scale;
      }
    }
    fail(where_, fmt::format("\"{}\" is not a scale", name));
  }

 private:
  const std::string& where_;
  std::map<std::string, std::string> fields_;
};

std::optional<FittedModel::Fit> fit_of(const NamedRow& row) {
  const auto estimate = row.number("estimate");
  const auto low = row.number("low");
  const auto high = row.number("high");
  const auto p = row.number("p");
  if (!estimate || !p) {
    return std::nullopt;
  }
  return FittedModel::Fit{
      .estimate = *estimate,
      .standard_error = row.number("standard_error"),
      .degrees_of_freedom = row.number("degrees_of_freedom"),
      .interval = low && high ? std::optional(Interval{*low, *high}) : std::nullopt,
      .p = *p};
}

std::optional<Influence> influence_of(const NamedRow& row) {
  const auto low = row.number("without_one_low");
  const auto high = row.number("without_one_high");
  if (!low || !high) {
    return std::nullopt;
  }
  return Influence{{*low, *high}, row.text("low_without"), row.text("high_without")};
}

FittedModel model_of(const NamedRow& row) {
  return {.model = row.text("model"),
          .measure = row.text("measure"),
          .method = row.text("method"),
          .reference = row.text("reference"),
          .scale = row.scale(),
          .status = row.text("status"),
          .fit = fit_of(row),
          .trials = row.count("trials"),
          .participants = row.count("participants"),
          .scenes = row.count("scenes"),
          .censored = row.count("censored"),
          .participant_sd = row.number("participant_sd"),
          .scene_sd = row.number("scene_sd"),
          .residual_sd = row.number("residual_sd"),
          .influence = influence_of(row),
          .note = row.text("note")};
}

/// Calls `take` for every row below the heading.
template <typename Take>
void for_each_row(const std::string& text, const std::string& where, const Take& take) {
  const std::vector<CsvRow> rows = parse_csv(text, where);
  if (rows.empty()) {
    fail(where, "is empty");
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    take(NamedRow(rows.front(), rows[i], where));
  }
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) {
    return "it printed no message";
  }
  const std::size_t before = text.find_last_of('\n', end);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return text.substr(begin, end + 1 - begin);
}

}  // namespace

FittedModels read_models(const std::string& models_csv, const std::string& versions_csv) {
  FittedModels fitted;
  for_each_row(models_csv, models_file,
               [&](const NamedRow& row) { fitted.models.push_back(model_of(row)); });
  for_each_row(versions_csv, versions_file, [&](const NamedRow& row) {
    fitted.versions.emplace_back(row.text("name"), row.text("version"));
  });
  return fitted;
}

std::vector<FittedModels> fit_models(const fs::path& script, const std::vector<fs::path>& folders) {
  const auto without_models = [&](const std::string& why) {
    return std::vector<FittedModels>(folders.size(), FittedModels{.missing = why});
  };
  Command command{.words = {"Rscript", "--vanilla", script.string()}};
  std::transform(folders.begin(), folders.end(), std::back_inserter(command.words),
                 [](const fs::path& folder) { return folder.string(); });
  ProgramEnd end;
  try {
    end = run_to_end(command);
  } catch (const std::system_error&) {
    return without_models(fmt::format("R is not installed (apt-get install {})", r_packages));
  }
  if (end.status != 0) {
    return without_models(
        fmt::format("R ended with {}: {}", failure_named(end.status), last_line(end.errors)));
  }
  return transformed(folders, [&](const fs::path& folder) {
    if (!fs::exists(folder / models_file) || !fs::exists(folder / versions_file)) {
      return FittedModels{.missing = "R wrote no models, and reported no fault"};
    }
    return read_models(read_file(folder / models_file), read_file(folder / versions_file));
  });
}

FittedModels fit_models(const fs::path& folder) {
  return std::move(fit_models(folder / "models.R", {folder}).front());
}

std::string missing_for(const FittedModels& models) {
  if (!models.missing.empty()) {
    return models.missing;
  }
  std::vector<std::string> packages;
  for (const std::string package : {"lme4", "lmerTest", "survival", "ordinal"}) {
    if (std::ranges::none_of(models.versions,
                             [&](const auto& version) { return version.first == package; })) {
      packages.push_back(package);
    }
  }
  return packages.empty() ? ""
                          : fmt::format("R has no package {} (apt-get install {})",
                                        fmt::join(packages, " and no "), r_packages);
}

}  // namespace foveola::analysis
