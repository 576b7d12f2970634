#include "study/tables/protocol_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/numbers/aligned_rows.h"
#include "renderer/base/transformed.h"
#include "study/design/orders.h"
#include "study/design/participant_code.h"

namespace foveola::study {
namespace {

std::vector<std::string> scene_names(const Protocol& protocol) {
  return transformed(protocol.scenes, &SceneEntry::name);
}

/// Returns "" "1st" ... "after od" ...
TextRow balance_header(const std::string& what, const std::vector<std::string>& names) {
  TextRow header{what};
  for (std::size_t position = 1; position <= names.size(); ++position) {
    header.push_back(fmt::format("at {}", position));
  }
  for (const std::string& name : names) {
    header.push_back("after " + name);
  }
  return header;
}

void add_counts(std::vector<TextRow>& rows, const std::string& what,
                const std::vector<std::string>& names, const Counts& at, const Counts& after) {
  rows.push_back(balance_header(what, names));
  for (std::size_t i = 0; i < names.size(); ++i) {
    TextRow row{names[i]};
    for (const int count : at[i]) {
      row.push_back(fmt::format("{}", count));
    }
    for (std::size_t before = 0; before < names.size(); ++before) {
      row.push_back(before == i ? "-" : fmt::format("{}", after[i][before]));
    }
    rows.push_back(row);
  }
}

int largest_in_one_scene(const Balance& balance) {
  int largest = 0;
  for (const Counts& counts : balance.method_at_in) {
    largest = std::max(largest, largest_difference(counts));
  }
  return largest;
}

TextRow minutes(const std::string& name, const std::string& count, const Duration& duration) {
  return {name, count, fmt::format("{:.1f}", duration.least_s / 60.0),
          fmt::format("{:.1f}", duration.most_s / 60.0)};
}

std::string objects_of(const SceneSource& source) {
  return fmt::format(
      "{}", fmt::join(source.objects | std::views::transform(&ObjectOfInterest::name), ", "));
}

/// Returns " (NAME)" of a profile; empty if there is none.
template <typename Profile>
std::string in_brackets(const std::optional<Profile>& profile) {
  return profile ? fmt::format(" ({})", profile->name) : "";
}

std::string text_of(const TrackerSettings& tracker) {
  return fmt::format("{} Hz, {:.4g} ms, {} degrees of noise{}", tracker.simulated.rate_hz,
                     1e3 * tracker.simulated.latency_s, tracker.simulated.precision_deg,
                     in_brackets(tracker.profile));
}

std::string text_of(const ValidationSettings& validation) {
  return fmt::format("{} points{}, {} attempts: accuracy {} degrees, precision {} degrees, loss {}",
                     validation.points, validation.correct ? ", corrected" : "",
                     validation.attempts, validation.gate.max_accuracy_deg,
                     validation.gate.max_precision_deg, validation.gate.max_data_loss);
}

std::string text_of(const GazeFilterSettings& filter) {
  std::vector<std::string> parts;
  if (filter.one_euro) {
    parts.push_back(
        fmt::format("1-Euro (at least {} Hz, {} Hz more for each degree/s, velocity {} "
                    "Hz)",
                    filter.one_euro->min_cutoff_hz, filter.one_euro->beta_per_deg,
                    filter.one_euro->derivative_cutoff_hz));
  }
  if (filter.extrapolate_s) {
    parts.push_back(fmt::format("extrapolated by {} s", *filter.extrapolate_s));
  }
  if (filter.hold_s) {
    parts.push_back(fmt::format("held for {} s", *filter.hold_s));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Returns "random" or "williams, 6 rows".
std::string orders_of(Order order, std::size_t things) {
  const int rows = row_count(order, static_cast<int>(things));
  return rows > 1 ? fmt::format("{}, {} rows", name_of(order), rows) : name_of(order);
}

std::string text_of(const PhaseEntry& phase) { return name_of(phase); }

std::string text_of(const MarkEntry& mark) { return mark.id; }

std::string text_of(const Question& question) {
  switch (question.kind) {
    case QuestionKind::likert:
      return fmt::format("{} ({} to {})", question.id, question.minimum, question.maximum);
    case QuestionKind::number:
      return fmt::format("{} (a number from {} to {})", question.id, question.minimum,
                         question.maximum);
    case QuestionKind::choice:
      return fmt::format("{} ({} options)", question.id, question.options.size());
    case QuestionKind::text:
      break;
  }
  return fmt::format("{} (words)", question.id);
}

template <typename Things>
std::string texts_of(const Things& things) {
  const auto text = [](const auto& thing) { return text_of(thing); };
  return fmt::format("{}", fmt::join(things | std::views::transform(text), ", "));
}

std::string text_of(const FilmSettings& film) {
  return fmt::format("{} x {} pixels, {} surface vertices", film.width, film.height,
                     film.max_depth);
}

std::string text_of(const TrialSettings& settings) {
  const WhileRating picture = settings.timing.while_rating;
  return fmt::format("{}; marks within {} s, looking around for {} s{}{}", text_of(settings.film),
                     settings.timing.mark_timeout_s, settings.timing.rating_s,
                     picture == WhileRating::held    ? "; the picture is held while rating"
                     : picture == WhileRating::blank ? "; the picture is black while rating"
                                                     : "",
                     settings.fill_unsampled ? "; unsampled pixels filled" : "");
}

/// Returns the reasons for retiming a trial; empty if there are none.
std::string text_of(const LookingSettings& looking) {
  std::vector<std::string> reasons;
  if (looking.object_out_of_view == Remedy::retime) {
    reasons.emplace_back("a mark with the object out of view");
  }
  if (looking.gaze_elsewhere == Remedy::retime) {
    reasons.emplace_back("a gaze elsewhere for most of it");
  }
  return fmt::format("{}", fmt::join(reasons, ", "));
}

/// Returns the requirements before a session; empty if there are none.
std::string text_of(const PreflightGate& gate) {
  std::vector<std::string> limits;
  const auto limit = [&](const std::optional<double>& value, const char* words) {
    if (value) {
      limits.push_back(fmt::format(fmt::runtime(words), *value));
    }
  };
  limit(gate.max_late_percent, "at most {:g} % of the frames late");
  limit(gate.min_samples_per_second, "at least {:g} samples a second");
  limit(gate.min_gaze_rate_hz, "gaze at {:g} Hz or more");
  limit(gate.max_gaze_loss, "at most {:g} of it lost");
  limit(gate.max_gaze_age_s, "no older than {:g} s");
  limit(gate.min_free_gb, "{:g} GB free");
  const auto demand = [&](bool is_demanded, const char* words) {
    if (is_demanded) {
      limits.emplace_back(words);
    }
  };
  demand(gate.tracked_eye, "a tracked eye");
  demand(gate.stated_display, "the display as its profile states");
  if (gate.fov_deg) {
    limits.push_back(fmt::format("{:g} x {:g} degrees within {:g}", gate.fov_deg->x,
                                 gate.fov_deg->y, gate.fov_tolerance_deg));
  }
  demand(gate.full_screen, "full screen");
  demand(gate.same_machine, "the same machine for everybody");
  demand(gate.same_display, "the same display for everybody");
  demand(gate.set_clock, "a synchronised clock");
  return fmt::format("{}", fmt::join(limits, ", "));
}

void add_procedure(std::vector<TextRow>& rows, const Protocol& protocol) {
  rows.push_back({"phases", texts_of(protocol.phases)});
  rows.push_back({"scene order", orders_of(protocol.scene_order, protocol.scenes.size())});
  rows.push_back({"method order", orders_of(protocol.method_order, protocol.methods.size()) +
                                      " within each scene"});
  rows.push_back({"object", protocol.object_choice == ObjectChoice::per_scene
                                ? "one for each scene"
                                : "one for each trial"});
  rows.push_back({"marks", texts_of(protocol.marks)});
  rows.push_back({"ratings", texts_of(protocol.ratings)});
  for (const PracticeEntry& entry : protocol.practice) {
    rows.push_back({"practice", fmt::format("{} with {}", entry.scene, entry.method)});
  }
  if (const CatchTrials& trials = protocol.catch_trials; trials.count > 0) {
    rows.push_back({"catch trials", fmt::format("{}, {} s each", trials.count, trials.timeout_s)});
  }
  if (const auto& reaction = protocol.reaction) {
    rows.push_back({"reaction", fmt::format("{} presses after {} to {} s", reaction->presses,
                                            reaction->shortest_wait_s, reaction->longest_wait_s)});
  }
  if (const std::string remedies = text_of(protocol.looking); !remedies.empty()) {
    rows.push_back({"retimed", remedies});
  }
  if (const std::string gate = text_of(protocol.preflight); !gate.empty()) {
    rows.push_back({"preflight", gate});
  }
  for (const Questionnaire& questionnaire : protocol.questionnaires) {
    rows.push_back(
        {"questions", fmt::format("{}: {}", questionnaire.id, texts_of(questionnaire.questions))});
  }
}

double film_megabytes(const Protocol& protocol) {
  double most = memory_of(protocol.film);
  for (const auto& [cell, settings] : protocol.cells) {
    most = std::max(most, memory_of(settings.film));
  }
  return 1e-6 * most;
}

void add_settings(std::vector<TextRow>& rows, const Protocol& protocol) {
  rows.push_back({"trial", text_of(settings_of(protocol, "", ""))});
  rows.push_back({"memory", fmt::format("up to {:.0f} MB for the film, in addition to the scenes",
                                        std::ceil(film_megabytes(protocol)))});
  for (const auto& [cell, settings] : protocol.cells) {
    rows.push_back({"", fmt::format("{} with {}: {}", cell.first, cell.second, text_of(settings))});
  }
}

void add_analysis(std::vector<TextRow>& rows, const Protocol& protocol) {
  const AnalysisPlan& plan = protocol.analysis;
  if (plan.participants) {
    rows.push_back({"planned", fmt::format("{} participants", *plan.participants)});
  }
  for (const PlannedComparison& comparison : plan.primary) {
    rows.push_back({"primary", fmt::format("{}: {} against {}", comparison.measure,
                                           comparison.method, comparison.baseline)});
  }
  if (!plan.primary.empty()) {
    rows.push_back({"family", fmt::format("the {} primary comparison{}, by Holm's method; alpha {}",
                                          plan.primary.size(), plan.primary.size() == 1 ? "" : "s",
                                          plan.alpha)});
  }
  for (const auto& [measure, margin] : plan.equivalence_margins) {
    rows.push_back({"equivalent", fmt::format("{} within {}", measure, margin)});
  }
}

}  // namespace

std::string protocol_table(const Protocol& protocol, const std::vector<SceneSource>& sources) {
  std::vector<TextRow> rows = {
      {"protocol", protocol.name},
      {"title", protocol.title},
      {"sha256", protocol.sha256},
      {"language",
       fmt::format("{}, {} screen texts of its own", protocol.language, protocol.texts.size())},
      {"methods", fmt::format("{} (baseline {})", fmt::join(protocol.methods, ", "),
                              protocol.methods.front())},
      {"trials", fmt::format("{} per participant", sources.size() * protocol.methods.size())},
      {"machine", fmt::format("{} samples per second at {} Hz", protocol.machine.samples_per_second,
                              protocol.machine.frame_rate_hz)},
      {"display",
       fmt::format("{} x {} pixels, {:.4g} x {:.4g} degrees{}", protocol.display.view_width,
                   protocol.display.view_height, protocol.display.horizontal_fov_deg,
                   protocol.display.vertical_fov_deg, in_brackets(protocol.display.profile))},
      {"tracker", text_of(protocol.tracker)},
  };
  add_settings(rows, protocol);
  add_procedure(rows, protocol);
  if (protocol.tracker.validation) {
    rows.push_back({"validation", text_of(*protocol.tracker.validation)});
  }
  if (protocol.tracker.filter != GazeFilterSettings{}) {
    rows.push_back({"gaze filter", text_of(protocol.tracker.filter)});
  }
  for (const MethodFile& file : protocol.method_files) {
    rows.push_back({"file", fmt::format("{} of {}: {}", file.file, file.method, file.sha256)});
  }
  add_analysis(rows, protocol);
  for (const SceneSource& source : sources) {
    rows.push_back({"scene", fmt::format("{}: {}", source.name, objects_of(source))});
  }
  return aligned(rows);
}

std::string plan_table(const std::vector<Plan>& plans) {
  std::vector<TextRow> rows = {{"participant", "position", "scene", "methods"}};
  for (std::size_t index = 0; index < plans.size(); ++index) {
    const std::string code = participant_code(static_cast<int>(index));
    for (const PlannedTrial& trial : plans[index]) {
      if (trial.kind == TrialKind::practice) {
        rows.push_back({code, name_of(trial.kind), trial.scene, trial.method});
      } else if (trial.kind == TrialKind::catch_trial) {
        rows.back().back() += fmt::format(", ({})", name_of(trial.kind));
      } else if (trial.method_position == 0) {
        rows.push_back(
            {code, fmt::format("{}", trial.scene_position + 1), trial.scene, trial.method});
      } else {
        rows.back().back() += ", " + trial.method;
      }
    }
  }
  return aligned(rows);
}

std::string balance_table(const Protocol& protocol, const Balance& balance) {
  std::vector<TextRow> methods;
  add_counts(methods, "methods", protocol.methods, balance.method_at, balance.method_after);
  std::vector<TextRow> scenes;
  add_counts(scenes, "scenes", scene_names(protocol), balance.scene_at, balance.scene_after);
  const std::vector<TextRow> differences = {
      {"largest difference", "at positions", "in one scene", "after one another"},
      {"methods", fmt::format("{}", largest_difference(balance.method_at)),
       fmt::format("{}", largest_in_one_scene(balance)),
       fmt::format("{}", largest_difference_after(balance.method_after))},
      {"scenes", fmt::format("{}", largest_difference(balance.scene_at)), "",
       fmt::format("{}", largest_difference_after(balance.scene_after))}};
  return aligned(methods) + "\n" + aligned(scenes) + "\n" + aligned(differences);
}

std::string duration_table(const std::vector<SessionPart>& parts) {
  std::vector<TextRow> rows = {{"minutes of", "", "at least", "at most"}};
  for (const SessionPart& part : parts) {
    rows.push_back(minutes(part.name, fmt::format("{}", part.count), part.duration));
  }
  rows.push_back(minutes("a session", "", total_of(parts)));
  std::vector<TextRow> assumed = {{"assumed seconds", "at least", "at most"}};
  for (const AssumedDuration& assumption : assumed_durations()) {
    const double most_s = assumption.duration.most_s;
    assumed.push_back({std::string(assumption.of), fmt::format("{}", assumption.duration.least_s),
                       most_s > 0.0 ? fmt::format("{}", most_s) : ""});
  }
  return aligned(rows) + "\n" + aligned(assumed);
}

}  // namespace foveola::study
