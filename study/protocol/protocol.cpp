#include "study/protocol/protocol.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <functional>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <strings.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"
#include "renderer/base/transformed.h"
#include "study/protocol/built_in_texts.h"
#include "study/protocol/measure.h"
#include "study/protocol/protocol_places.h"
#include "study/protocol/reading/read_methods.h"
#include "study/protocol/reading/read_overrides.h"
#include "study/protocol/reading/read_procedure.h"
#include "study/protocol/reading/read_questions.h"
#include "study/protocol/reading/read_settings.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

void read_all_settings(TomlReader& reader, Protocol& protocol) {
  protocol.machine = read_machine(
      reader.table("machine",
                   "The machine's speed for simulated participants, independent of the "
                   "computer that runs the simulation. People see the real speed."));
  protocol.display = read_display(reader.table("display", "The display."), folder_of(protocol));
  protocol.film = read_film(
      reader.table("film", "The film: the 360-degree image that samples are summed in."), {});
  protocol.tracker = read_tracker(reader.table("tracker", "The eye tracker."), folder_of(protocol));
  protocol.timing = read_timing(reader.table("timing", "Time-outs and times."), {});
  protocol.reference = read_reference(reader.table(
      "reference", "The quality of the reference images that simulated participants expect."));
  protocol.preflight = read_preflight(
      reader.table("preflight",
                   "Requirements before a person's session begins. Quantities without a "
                   "requirement are measured and recorded only."));
  read_overrides(reader, protocol);
}

/// Rejects keys that protocols had before questionnaires had ids.
void refuse_old_tables(TomlReader& reader, const toml::table& table) {
  if (const toml::node* const background = table.get("background")) {
    reader.fail(background->source(),
                "[[background]] is a table of an older Foveola; questionnaires now have ids",
                "write [[questionnaire]] with id = \"background\", and each of these tables as a "
                "[[questionnaire.question]] below it");
  }
}

/// Returns the first single letter in brackets, as in "[J] Ja"; empty if there is none.
std::string letter_key_in(std::string_view words) {
  for (std::size_t open = words.find('['); open != std::string_view::npos;
       open = words.find('[', open + 1)) {
    const std::string_view rest = words.substr(open + 1);
    const std::string_view name = rest.substr(0, bytes_of_first(rest, 1));
    const auto first = static_cast<unsigned char>(name.empty() ? ' ' : name.front());
    constexpr unsigned char first_letter = 0xC3;  // of UTF-8's beyond ASCII
    constexpr unsigned char symbols = 0xE2;       // arrows among them
    const bool is_letter = std::isalpha(first) != 0 || (first >= first_letter && first != symbols);
    if (is_letter && rest.substr(name.size()).starts_with(']')) {
      return std::string(name);
    }
  }
  return {};
}

/// Throws Error for texts that name keys which no page accepts.
void require_true_keys(const Protocol& protocol) {
  const ProtocolPlaces places(protocol);
  const std::span<const std::string_view> retired = retired_text_ids();
  for (const auto& [id, words] : protocol.texts) {
    if (std::ranges::find(retired, id) != retired.end()) {
      throw Error(places.of("texts." + id),
                  "is not shown: that page has a list, which arrows and Enter answer",
                  "leave it out, and give consent_yes, consent_no, retiming_continue, "
                  "retiming_again, stopping_continue and stopping_stop the study's words");
    }
    if (const std::string letter = letter_key_in(words); !letter.empty()) {
      throw Error(places.of("texts." + id),
                  fmt::format("names the key [{}], which no page accepts", letter),
                  "name the keys of the built-in texts (foveola study keys)");
    }
  }
}

bool is_same_in_any_case(const std::string& a, const std::string& b) {
  return ::strcasecmp(a.c_str(), b.c_str()) == 0;
}

/// Adds the name of a column or a file. Throws Error if a known one differs in letter case only:
/// for SQLite, SPSS and many file systems they are one.
void add_name(const std::string& name, const std::string& place, std::vector<std::string>& known) {
  const auto same = std::ranges::find_if(
      known, [&](const std::string& other) { return is_same_in_any_case(other, name); });
  if (same != known.end()) {
    throw Error(place,
                fmt::format("'{}' differs from '{}' in letter case only, and so would the "
                            "analysis's columns or files",
                            name, *same),
                "give each a name of its own");
  }
  known.push_back(name);
}

/// Throws Error for names that cannot be parts of the names of an analysis's columns and files.
void require_names_of_columns(const Protocol& protocol) {
  constexpr std::size_t max_id_length = 64;
  const ProtocolPlaces places(protocol);
  std::vector<std::string> measures;
  const auto add_measure = [&](const std::string& id, const std::string& key) {
    if (id.size() > max_id_length) {
      throw Error(places.of(key),
                  fmt::format("the id '{}' has {} characters, and the analysis names files by it",
                              id, id.size()),
                  fmt::format("shorten it to at most {}", max_id_length));
    }
    const bool is_of_response = is_same_in_any_case(id, looking_around_id) ||
                                std::ranges::any_of(protocol.ratings, [&](const Question& rating) {
                                  return is_same_in_any_case(id, rating.id + response_suffix);
                                });
    if (is_of_response) {
      throw Error(places.of(key),
                  fmt::format("the id '{}' is that of a response time, in any letter case", id),
                  "choose another id");
    }
    add_name(id, places.of(key), measures);
  };
  for (std::size_t i = 0; i < protocol.marks.size(); ++i) {
    add_measure(protocol.marks[i].id, fmt::format("mark[{}].id", i));
  }
  for (std::size_t i = 0; i < protocol.ratings.size(); ++i) {
    add_measure(protocol.ratings[i].id, fmt::format("rating[{}].id", i));
  }
  // `key`: of the item's name, with {} for its number.
  const auto require_distinct = [&](const auto& items, const auto& name, const std::string& key) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < items.size(); ++i) {
      add_name(std::invoke(name, items[i]), places.of(fmt::format(fmt::runtime(key), i)), known);
    }
  };
  require_distinct(protocol.scenes, &SceneEntry::name, "scenes[{}]");
  require_distinct(protocol.methods, std::identity(), "methods[{}]");
  require_distinct(protocol.questionnaires, &Questionnaire::id, "questionnaire[{}].id");
  for (std::size_t i = 0; i < protocol.questionnaires.size(); ++i) {
    const Questionnaire& questionnaire = protocol.questionnaires[i];
    require_distinct(questionnaire.questions, &Question::id,
                     fmt::format("questionnaire[{}].{}", i,
                                 questionnaire.file.empty() ? "question[{}].id" : "file"));
  }
}

fs::path users_protocols() { return data_folder() / "protocols"; }

}  // namespace

fs::path find_protocol(const std::string& name_or_path) {
  std::error_code no_name_of_a_file;
  if (fs::exists(name_or_path, no_name_of_a_file)) {
    return name_or_path;
  }
  std::vector<std::string> names;
  for (const fs::path& folder : {users_protocols(), resource_folder() / "protocols"}) {
    const fs::path named = folder / (name_or_path + ".toml");
    if (name_or_path.find('/') == std::string::npos &&
        fs::is_regular_file(named, no_name_of_a_file)) {
      return named;
    }
    const std::vector<std::string> there = toml_names_or_none(folder);
    names.insert(names.end(), there.begin(), there.end());
  }
  throw Error(name_or_path, "is not a known protocol",
              did_you_mean(name_or_path, names,
                           fmt::format("give a .toml file or one of {}", fmt::join(names, ", "))));
}

Protocol load_protocol(const fs::path& path) {
  Protocol protocol = read_protocol(read_toml_file(path), path);
  require_true_keys(protocol);
  require_names_of_columns(protocol);
  return protocol;
}

Protocol read_protocol(const std::string& text, const fs::path& path, TomlKeys* keys) {
  Protocol protocol;
  protocol.path = path;
  protocol.text = text;
  protocol.sha256 = sha256(std::string_view(text));
  const toml::table table =
      parse_toml(path.string(), text, "see protocols/demo.toml for an example");
  TomlReader reader(path.string(), table, "", keys);
  refuse_old_tables(reader, table);
  protocol.name = reader.require_text("name", "The study's short name.");
  protocol.title = reader.require_text("title", "The study's title, for people.");
  protocol.scenes = read_scenes(reader);
  read_methods(reader, protocol);
  read_texts(reader, protocol);
  read_all_settings(reader, protocol);
  read_procedure(reader, protocol);
  protocol.questionnaires =
      read_questionnaires(reader, questionnaire_files_in(folder_of(protocol)));
  read_phases(reader, protocol);
  protocol.analysis = read_analysis(reader.table("analysis",
                                                 "The analysis that is planned before there are "
                                                 "data; any other comparison is exploratory."),
                                    protocol);
  require_computable(reader.table("analysis"), protocol.analysis);
  reader.reject_unknown_keys();
  protocol.notes = reader.notes();
  return protocol;
}

Protocol read_measured_part(const std::string& text, const std::string& where,
                            const QuestionnaireFiles& files) {
  const toml::table table = parse_toml(where, text, "restore the study's file");
  TomlReader reader(where, table, "");
  Protocol protocol;
  protocol.path = where;
  protocol.text = text;
  reader.read("name", protocol.name);
  reader.read("title", protocol.title);
  protocol.scenes = read_scenes(reader);
  for (const TomlReader::Text& method : reader.require_texts("methods")) {
    protocol.methods.push_back(method.value);
  }
  protocol.film = read_film(reader.table("film"), {});
  protocol.timing = read_timing(reader.table("timing"), {});
  read_procedure(reader, protocol);
  protocol.questionnaires = read_questionnaires(reader, files);
  protocol.analysis = read_analysis(reader.table("analysis"), protocol);
  return protocol;
}

DisplaySettings read_recorded_display(const std::string& text, const std::string& where,
                                      const std::string& profile_toml) {
  const toml::table table = parse_toml(where, text, "restore the study's file");
  return read_display(TomlReader(where, table, "").table("display"), [&](const std::string& name) {
    return display_profile_in(profile_toml, name);
  });
}

fs::path folder_of(const Protocol& protocol) { return fs::absolute(protocol.path).parent_path(); }

std::string name_of(const PhaseEntry& phase) {
  using Kind = PhaseEntry::Kind;
  constexpr auto kinds = std::to_array<Word<Kind>>({{"consent", Kind::consent},
                                                    {"validation", Kind::validation},
                                                    {"reaction", Kind::reaction},
                                                    {"trials", Kind::trials}});
  return phase.kind == Kind::questionnaire ? phase.questionnaire : word_for(kinds, phase.kind);
}

TrialSettings settings_of(const Protocol& protocol, const std::string& scene,
                          const std::string& method) {
  const auto cell = protocol.cells.find({scene, method});
  return cell != protocol.cells.end()
             ? cell->second
             : TrialSettings{.film = protocol.film,
                             .timing = protocol.timing,
                             .fill_unsampled = protocol.display.fill_unsampled};
}

const Questionnaire& questionnaire_of(const Protocol& protocol, const std::string& id) {
  const auto found = std::ranges::find(protocol.questionnaires, id, &Questionnaire::id);
  assert(found != protocol.questionnaires.end());
  return *found;
}

std::vector<NamedProfile> named_profiles(const Protocol& protocol) {
  std::vector<NamedProfile> profiles;
  if (const auto& display = protocol.display.profile) {
    profiles.push_back({.device = "display", .name = display->name, .toml = display->toml});
  }
  if (const auto& tracker = protocol.tracker.profile) {
    profiles.push_back({.device = "tracker", .name = tracker->name, .toml = tracker->toml});
  }
  for (const Questionnaire& questionnaire : protocol.questionnaires) {
    const bool is_named = std::ranges::any_of(profiles, [&](const NamedProfile& named) {
      return named.device == "questionnaire" && named.name == questionnaire.file;
    });
    if (!questionnaire.file.empty() && !is_named) {
      profiles.push_back(
          {.device = "questionnaire", .name = questionnaire.file, .toml = questionnaire.toml});
    }
  }
  return profiles;
}

std::size_t scene_index(const Protocol& protocol, const std::string& name) {
  const auto found = std::ranges::find(protocol.scenes, name, &SceneEntry::name);
  return static_cast<std::size_t>(found - protocol.scenes.begin());
}

std::size_t method_index(const Protocol& protocol, const std::string& name) {
  const auto found = std::ranges::find(protocol.methods, name);
  return static_cast<std::size_t>(found - protocol.methods.begin());
}

std::unique_ptr<ViewSampler> make_sampler(const Protocol& protocol, const std::string& method) {
  return make_view_sampler(method, [&](const std::string& file) {
    const MethodFile* known = find_method_file(protocol.method_files, method, file);
    assert(known != nullptr);
    return *known->weights;
  });
}

SceneSource find_scene_of(const Protocol& protocol, const SceneEntry& entry,
                          const SceneFinderBeside& find_scene) {
  const std::string place =
      fmt::format("{}:{}:{}", protocol.path.string(), entry.line, entry.column);
  SceneSource source;
  try {
    source = find_scene(entry.name, folder_of(protocol));
  } catch (const Error& error) {
    throw Error(place, error.what());
  }
  if (source.objects.empty()) {
    throw Error(place, fmt::format("the scene '{}' has no objects to choose", entry.name),
                "'foveola scene describe' writes a descriptor with [[object]] entries beside its "
                "file");
  }
  if (!source.camera_position) {
    throw Error(place, fmt::format("the scene '{}' has no viewpoint", entry.name),
                "'foveola scene describe' writes a descriptor with a camera beside its file");
  }
  return source;
}

std::vector<SceneSource> find_scenes(const Protocol& protocol,
                                     const SceneFinderBeside& find_scene) {
  return transformed(protocol.scenes, [&](const SceneEntry& entry) {
    return find_scene_of(protocol, entry, find_scene);
  });
}

}  // namespace foveola::study
