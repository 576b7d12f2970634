#include "analysis/publication/methods_paragraph.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "analysis/publication/analysis_plan.h"
#include "analysis/publication/wording.h"
#include "renderer/base/toml_reader.h"
#include "study/protocol/analysed_measures.h"
#include "study/protocol/read_procedure.h"

namespace foveola::analysis {
namespace {

/// The parts of a protocol that the paragraph needs; empty where it says nothing.
struct ProtocolFacts {
  std::string scene_order;
  std::string method_order;
  std::string display;
  std::string tracker;
  std::optional<int> film_width;
  std::optional<int> film_height;
  std::optional<double> timeout_s;
  std::vector<std::string> marks;
  std::vector<std::string> not_analysed;  ///< Ids of marks and ratings.
};

template <typename Number>
std::optional<Number> number_under(TomlReader& table, const char* key) {
  Number value = 0;
  table.read(key, value, Number{0}, Number{1'000'000});
  return table.has(key) ? std::optional(value) : std::nullopt;
}

void add_measures(TomlReader& protocol, ProtocolFacts& facts) {
  const std::vector<study::MarkEntry> marks = study::read_marks(protocol);
  for (const study::MarkEntry& mark : marks) {
    (study::is_analysed(mark) ? facts.marks : facts.not_analysed).push_back(mark.id);
  }
  for (const study::Question& rating : study::read_ratings(protocol, marks)) {
    if (!study::is_analysed(rating)) {
      facts.not_analysed.push_back(rating.id);
    }
  }
}

ProtocolFacts facts_of(const std::string& protocol_text) {
  const std::string file = "the study's protocol";
  const toml::table toml = parse_toml(file, protocol_text, "restore the study's file");
  TomlReader protocol(file, toml, "");
  ProtocolFacts facts;
  protocol.read("scene_order", facts.scene_order);
  protocol.read("method_order", facts.method_order);
  protocol.table("display").read("profile", facts.display);
  protocol.table("tracker").read("profile", facts.tracker);
  TomlReader film = protocol.table("film");
  facts.film_width = number_under<int>(film, "width");
  facts.film_height = number_under<int>(film, "height");
  TomlReader timing = protocol.table("timing");
  facts.timeout_s = number_under<double>(timing, "mark_timeout_s");
  add_measures(protocol, facts);
  return facts;
}

/// The sentences on the analysed marks and ratings, which follow those on what was seen.
std::string measures_in_words(const ProtocolFacts& facts, const RatingScale& scale) {
  const auto has = [&](const char* mark) {
    return std::find(facts.marks.begin(), facts.marks.end(), mark) != facts.marks.end();
  };
  std::string text;
  if (has("outline") || has("material")) {
    text += fmt::format(", and marked when the {} could be judged",
                        !has("material")  ? "outline of a chosen object"
                        : !has("outline") ? "material of a chosen object"
                                          : "outline of a chosen object and when its material");
  }
  if (scale.is_analysed()) {
    const bool names_every_point = scale.question->labels.size() > 2;
    text += fmt::format("; then they rated artifacts in other areas {} {}",
                        names_every_point ? "as" : "from", points_in_brackets(scale));
  }
  text += scale.is_analysed() ? "." + notes_on(scale) : ".";
  if (!facts.not_analysed.empty()) {
    text += fmt::format(" Other marks and ratings ({}) are not analysed here.",
                        listed(facts.not_analysed));
  }
  return text;
}

std::string orders_in_words(const ProtocolFacts& facts) {
  if (facts.scene_order.empty() && facts.method_order.empty()) {
    return "";
  }
  const auto order = [](const std::string& name) {
    return name.empty() ? std::string("the protocol’s default") : name;
  };
  return fmt::format(" The order of scenes was {}, that of methods within a scene {}.",
                     order(facts.scene_order), order(facts.method_order));
}

std::string apparatus_in_words(const ProtocolFacts& facts) {
  std::string text;
  if (facts.film_width && facts.film_height) {
    text += fmt::format(" Images of the whole sphere had {} × {} pixels.", *facts.film_width,
                        *facts.film_height);
  }
  if (!facts.display.empty()) {
    text +=
        fmt::format(" The display was of profile {}{}.", facts.display,
                    facts.tracker.empty() ? "" : ", the eye tracker of profile " + facts.tracker);
  }
  if (facts.timeout_s) {
    text += fmt::format(" The time-out of a mark was {:g} s; later marks are right-censored.",
                        *facts.timeout_s);
  }
  return text;
}

std::string analysis_in_words(const StudyTables& tables, const Comparisons& comparisons) {
  std::string text = fmt::format(
      " Each participant’s mean logarithm of times over scenes was the unit of analysis; methods "
      "are "
      "compared by geometric means of ratios to {} with 95 % t intervals and paired t tests on "
      "logarithms, beside Wilcoxon signed-rank tests; ratings by Wilcoxon signed-rank tests.",
      method_label(tables.set.methods.front()));
  text += comparisons.plan.primary.empty()
              ? " No comparison was planned in the protocol; P-values are exploratory and adjusted "
                "by Holm’s method within each measure."
              : fmt::format(
                    " {} planned before data were collected, with Holm’s adjustment at a "
                    "level of {:g}; all others are exploratory.",
                    comparisons.plan.primary.size() == 1
                        ? std::string("One comparison was")
                        : fmt::format("{} comparisons were", comparisons.plan.primary.size()),
                    comparisons.plan.alpha);
  if (const std::size_t missing = planned_without_tables(comparisons.plan); missing > 0) {
    text += fmt::format(
        " {} of those planned {} not analysed here, and the adjustment is for the "
        "others alone.",
        missing, missing == 1 ? "is" : "are");
  }
  return text;
}

std::string amendments_in_words(const StudyTables& tables) {
  std::size_t analysed = 0;
  std::set<std::string> keys;
  for (const AmendedSession& session : tables.amended) {
    if (session.is_analysed) {
      ++analysed;
      keys.insert(session.changed_keys.begin(), session.changed_keys.end());
    }
  }
  if (analysed == 0) {
    return "";
  }
  return fmt::format(
      " {} of the {} followed a protocol that was amended after the study had begun ({}).",
      analysed, counted(tables.set.participants.size(), "analysed session"),
      keys.empty() ? std::string("comments or spaces only")
                   : "changed: " + listed({keys.begin(), keys.end()}));
}

}  // namespace

std::string methods_paragraph(const StudyTables& tables, const Comparisons& comparisons,
                              const std::string& protocol_text) {
  const ProtocolFacts facts = facts_of(protocol_text);
  const std::string warning = data_warning(tables);
  std::string text = warning.empty() ? "" : warning + " ";
  text += fmt::format("{} saw {} ({}), each with {} ({}) of progressive path tracing",
                      participants_in_words(tables), counted(tables.set.scenes.size(), "scene"),
                      listed(tables.set.scenes), counted(tables.set.methods.size(), "preview"),
                      listed(tables.set.methods));
  return text + measures_in_words(facts, tables.set.rating_scale) + orders_in_words(facts) +
         apparatus_in_words(facts) + amendments_in_words(tables) +
         analysis_in_words(tables, comparisons);
}

}  // namespace foveola::analysis
