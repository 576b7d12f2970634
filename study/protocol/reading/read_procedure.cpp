#include "study/protocol/reading/read_procedure.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/transformed.h"
#include "study/protocol/built_in_texts.h"
#include "study/protocol/reading/read_questions.h"
#include "study/protocol/reading/read_settings.h"
#include "study/protocol/texts.h"

namespace foveola::study {
namespace {

constexpr std::array orders{
    Word<Order>{"fixed", Order::fixed},
    Word<Order>{"random", Order::random},
    Word<Order>{"latin", Order::latin},
    Word<Order>{"williams", Order::williams},
};

/// Throws Error for names in braces that the built-in text of `id` does not have.
void require_known_names(const TomlReader& reader, const std::string& id, const std::string& text) {
  const std::vector<std::string> known = names_in(text_of({}, id));
  for (const std::string& name : names_in(text)) {
    if (std::ranges::find(known, name) == known.end()) {
      reader.fail(reader.source(id), fmt::format("{{{}}} is not a name of this text", name),
                  known.empty()
                      ? "remove it"
                      : fmt::format("the names of this text are {{{}}}", fmt::join(known, "}, {")));
    }
  }
}

Texts read_words(TomlReader reader) {
  Texts texts;
  for (const std::string& id : known_text_ids()) {
    std::string text = text_of({}, id);
    reader.read(id, text,
                id == "consent"
                    ? "The text that the participant agrees to. There is no built-in text "
                      "for it; with this key, a session begins by asking for consent."
                    : "");
    if (reader.has(id)) {
      require_known_names(reader, id, text);
      texts[id] = text;
    }
  }
  for (const std::string_view id : retired_text_ids()) {
    if (reader.has(id)) {
      reader.read(id, texts[std::string(id)]);
    }
  }
  reader.reject_unknown_keys();
  return texts;
}

bool is_language_tag(const std::string& text) {
  return !text.empty() && text.front() != '-' && text.back() != '-' &&
         std::ranges::all_of(text, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-';
         });
}

std::vector<PracticeEntry> read_practice(TomlReader& reader, const Protocol& protocol) {
  std::vector<PracticeEntry> practice;
  for (TomlReader& entry : reader.tables(
           "practice", "Practice trials before the first scene; they are never analysed.")) {
    practice.push_back({.scene = read_scene_name(entry, required("scene"), protocol,
                                                 "One of the protocol's scenes."),
                        .method = read_method_name(entry, required("method"), protocol,
                                                   "One of the protocol's methods.")});
    entry.reject_unknown_keys();
  }
  return practice;
}

CatchTrials read_catch_trials(TomlReader reader, int tests) {
  CatchTrials trials;
  reader.read("count", trials.count, 0, 1000,
              "Number of catch trials in a session, at random positions: never the first, no two "
              "in a row.");
  reader.read("timeout_s", trials.timeout_s, 0.5, 3600.0,
              "Seconds after which each ends by itself.");
  reader.reject_unknown_keys();
  if (trials.count > tests) {
    reader.fail(reader.source("count"),
                fmt::format("{} do not fit between {} trials", trials.count, tests),
                "use fewer: no two may be adjacent");
  }
  return trials;
}

ReactionSettings read_reaction(TomlReader reader) {
  constexpr double longest_s = 60.0;
  ReactionSettings reaction;
  reader.read("presses", reaction.presses, 1, 1000, "Number of presses; early ones are repeated.");
  reader.read("shortest_wait_s", reaction.shortest_wait_s, 0.1, longest_s,
              "The minimum wait in seconds; waits are drawn uniformly.");
  reader.read("longest_wait_s", reaction.longest_wait_s, 0.1, longest_s,
              "The maximum wait in seconds.");
  reader.reject_unknown_keys();
  if (reaction.longest_wait_s < reaction.shortest_wait_s) {
    const bool has_longest = reader.has("longest_wait_s");
    reader.fail(reader.source(has_longest ? "longest_wait_s" : "shortest_wait_s"),
                fmt::format("the range of waits from {} to {} seconds is empty",
                            reaction.shortest_wait_s, reaction.longest_wait_s),
                "make longest_wait_s longer than shortest_wait_s");
  }
  return reaction;
}

LookingSettings read_looking(TomlReader reader) {
  constexpr std::array remedies{Word<Remedy>{"flag", Remedy::flag},
                                Word<Remedy>{"retime", Remedy::retime}};
  LookingSettings looking;
  reader.read("object_out_of_view", looking.object_out_of_view, remedies,
              "The consequence if the view did not show the object at a mark; \"retime\" has the "
              "trial retimed, up to two times.");
  reader.read(
      "gaze_elsewhere", looking.gaze_elsewhere, remedies,
      "The consequence if the gaze was elsewhere for most of the time until the last mark.");
  reader.reject_unknown_keys();
  return looking;
}

bool has_consent(const Protocol& protocol) { return !text_of(protocol.texts, "consent").empty(); }

bool has_questionnaire(const Protocol& protocol, const std::string& id) {
  return std::ranges::any_of(protocol.questionnaires,
                             [&](const Questionnaire& known) { return known.id == id; });
}

/// Returns all possible phases of this protocol in their default order: questionnaires come last
/// except "background", which precedes the trials.
std::vector<PhaseEntry> possible_phases(const Protocol& protocol) {
  using Kind = PhaseEntry::Kind;
  std::vector<PhaseEntry> phases;
  const auto add_if = [&](bool is_possible, const PhaseEntry& phase) {
    if (is_possible) {
      phases.push_back(phase);
    }
  };
  add_if(has_consent(protocol), {Kind::consent});
  add_if(has_questionnaire(protocol, "background"), {Kind::questionnaire, "background"});
  add_if(protocol.tracker.validation.has_value(), {Kind::validation});
  add_if(protocol.reaction.has_value(), {Kind::reaction});
  phases.push_back({Kind::trials});
  add_if(has_questionnaire(protocol, "debrief"), {Kind::questionnaire, "debrief"});
  for (const Questionnaire& questionnaire : protocol.questionnaires) {
    add_if(questionnaire.id != "background" && questionnaire.id != "debrief",
           {Kind::questionnaire, questionnaire.id});
  }
  return phases;
}

std::vector<std::string> names_of(const std::vector<PhaseEntry>& phases) {
  return transformed(phases, [&](const PhaseEntry& phase) { return name_of(phase); });
}

std::string remedy_for(const std::string& phase, const std::vector<PhaseEntry>& possible) {
  if (phase == "consent") {
    return "write the text of the consent in [texts]: consent = \"...\"";
  }
  if (phase == "validation" || phase == "reaction") {
    return fmt::format("add a table [{}]", phase == "reaction" ? phase : "tracker.validation");
  }
  return fmt::format("choose one of {}, or give a [[questionnaire]] this id",
                     fmt::join(names_of(possible), ", "));
}

PhaseEntry chosen_phase(const TomlReader& reader, const TomlReader::Text& name,
                        const std::vector<PhaseEntry>& possible) {
  const auto found = std::ranges::find_if(
      possible, [&](const PhaseEntry& phase) { return name_of(phase) == name.value; });
  if (found == possible.end()) {
    reader.fail(name.source, fmt::format("'{}' is not a phase of this protocol", name.value),
                remedy_for(name.value, possible));
  }
  return *found;
}

/// Throws Error if no phase uses a part that the protocol describes.
void require_all_chosen(const TomlReader& reader, const std::vector<TomlReader::Text>& chosen,
                        const std::vector<PhaseEntry>& possible) {
  for (const std::string& name : names_of(possible)) {
    if (std::ranges::none_of(chosen,
                             [&](const TomlReader::Text& text) { return text.value == name; })) {
      reader.fail(reader.source("phases"), fmt::format("'{}' is in no phase", name),
                  "add it to phases, or remove its description");
    }
  }
}

MarkEntry read_mark(TomlReader& entry, const std::string& id) {
  const std::string instruction =
      entry.require_text("instruction", "The text that the participant reads before the trial.");
  constexpr std::array judgements{Word<std::string_view>{"outline", "outline"},
                                  Word<std::string_view>{"material", "material"}};
  // A mark with the id of a published one is judged likewise, unless it says otherwise.
  std::string_view simulated = id == "outline" || id == "material" ? std::string_view(id) : "";
  entry.read("simulated", simulated, judgements,
             "The judgement by which simulated participants make the mark. Default: that of its "
             "id, if it is one of these; otherwise they refuse the protocol.");
  return {.id = id, .instruction = instruction, .simulated = std::string(simulated)};
}

}  // namespace

std::string name_of(Order order) { return word_for(orders, order); }

void read_texts(TomlReader& reader, Protocol& protocol) {
  reader.read("language", protocol.language,
              "The language of the texts, as a BCP 47 tag: en, fi, pt-BR.",
              "^[A-Za-z0-9]+(-[A-Za-z0-9]+)*$");
  if (!is_language_tag(protocol.language)) {
    reader.fail(reader.source("language"),
                fmt::format("'{}' is not a language tag", protocol.language),
                "write one like en, fi, pt-BR");
  }
  protocol.texts =
      read_words(reader.table("texts",
                              "Texts of the participant's screens, which replace the built-in "
                              "English ones. Names in braces are replaced."));
}

std::vector<MarkEntry> published_marks() {
  return {{.id = "outline",
           .instruction = "Press as soon as you could tell whether moving or turning the object "
                          "succeeded: you see its outline.",
           .simulated = "outline"},
          {.id = "material",
           .instruction = "Press as soon as you could tell whether changing its material "
                          "succeeded: you see what it is made of.",
           .simulated = "material"}};
}

std::vector<Question> published_ratings() {
  return {{.id = "artifacts",
           .text = "How prevalent were disturbing artifacts in the other areas?",
           .labels = {"none", "not discernible at all"},
           .simulated = "artifacts"}};
}

std::vector<MarkEntry> read_marks(TomlReader& reader) {
  std::vector<MarkEntry> marks;
  std::vector<std::string> ids;
  for (TomlReader& entry :
       reader.tables("mark",
                     "The moments that the participant marks while a trial is rendered, in this "
                     "order. Default: outline, material, as published.")) {
    ids.push_back(read_new_id(
        entry,
        "The mark's name in records, tables and files: at most 64 letters, digits, - "
        "and _, and different from those of other marks and ratings by more than letter case.",
        ids));
    marks.push_back(read_mark(entry, ids.back()));
    entry.reject_unknown_keys();
  }
  return marks.empty() ? published_marks() : marks;
}

std::vector<Question> read_ratings(TomlReader& reader, const std::vector<MarkEntry>& marks) {
  std::vector<std::string> taken = transformed(marks, &MarkEntry::id);
  std::vector<Question> ratings =
      read_questions(reader, "rating", taken,
                     "Questions after the marks. Default: artifacts, from 1 to 5, as published.");
  if (!ratings.empty()) {
    return ratings;
  }
  ratings = published_ratings();
  const auto same = std::ranges::find(taken, ratings.front().id);
  if (same != taken.end()) {
    const TomlReader mark = reader.tables("mark")[static_cast<std::size_t>(same - taken.begin())];
    mark.fail(mark.source("id"), fmt::format("'{}' is the id of the built-in rating", *same),
              "give the mark another id, or write the ratings ([[rating]])");
  }
  return ratings;
}

void read_procedure(TomlReader& reader, Protocol& protocol) {
  constexpr std::array choices{Word<ObjectChoice>{"per scene", ObjectChoice::per_scene},
                               Word<ObjectChoice>{"per method", ObjectChoice::per_method}};
  reader.read("scene_order", protocol.scene_order, orders,
              "The order of scenes. fixed: as listed; random: drawn anew for every participant, "
              "as published; latin: the rows of a cyclic Latin square; williams: those of a "
              "Williams square, which is also balanced for carry-over.");
  reader.read("method_order", protocol.method_order, orders,
              "The order of methods within each scene. fixed: as listed; random: drawn anew for "
              "every participant, as published; latin: the rows of a cyclic Latin square; "
              "williams: those of a Williams square, which is also balanced for carry-over.");
  reader.read("object", protocol.object_choice, choices,
              "The scope of a participant's chosen object: all trials of a scene, or one trial.");
  protocol.marks = read_marks(reader);
  protocol.ratings = read_ratings(reader, protocol.marks);
  protocol.practice = read_practice(reader, protocol);
  protocol.catch_trials = read_catch_trials(
      reader.table("catch_trials",
                   "Catch trials, in which nothing is rendered: a mark in one shows that the "
                   "participant did not look. They are never analysed."),
      static_cast<int>(protocol.scenes.size() * protocol.methods.size()));
  reader.read_table("reaction", protocol.reaction, read_reaction,
                    "The reaction test: key presses at a stimulus, which measure the "
                    "participant's reaction time.");
  protocol.looking =
      read_looking(reader.table("looking",
                                "The consequences if a participant did not look at the trial's "
                                "object. The record and the analysis always note it."));
}

void read_phases(TomlReader& reader, Protocol& protocol) {
  const std::vector<PhaseEntry> possible = possible_phases(protocol);
  const std::vector<TomlReader::Text> chosen = reader.texts(
      "phases",
      "The phases of a session in their order: consent, validation, reaction, trials (with the "
      "practice right before them), and questionnaires by their ids. Everything that the protocol "
      "describes must occur. Default: consent if there is a text for it, the questionnaire "
      "background, validation, reaction, trials, the questionnaire debrief, any others.");
  for (const TomlReader::Text& name : chosen) {
    protocol.phases.push_back(chosen_phase(reader, name, possible));
  }
  if (reader.has("phases")) {
    require_all_chosen(reader, chosen, possible);
    return;
  }
  protocol.phases = possible;
}

}  // namespace foveola::study
