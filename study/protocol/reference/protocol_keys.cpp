#include "study/protocol/reference/protocol_keys.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "renderer/gaze/profiles.h"
#include "study/protocol/protocol.h"
#include "study/protocol/reading/read_questions.h"

namespace foveola::study {
namespace {

constexpr const char* questions = R"([
  { id = "presence", text = "How present did you feel?" },
  { id = "years", text = "For how many years?", kind = "number", minimum = 0, maximum = 99 },
  { id = "hand", text = "With which?", kind = "choice", options = [{ label = "left" }, { label = "right" }] },
  { id = "comments", text = "Anything else?", kind = "text" },
  { id = "artifacts", text = "How many artifacts were there?" }])";

/// Returns a tracker's profile. source: its keys that depend on the source, and the source.
std::string tracker_from(const std::string& source) {
  return source + R"(
title = "A tracker"
rate_hz = 120
exposure = { duration_ms = 2, provenance = "assumed" }
transfer = { duration_ms = 2, provenance = "assumed" }
processing = { duration_ms = 2, provenance = "assumed" }
)";
}

struct FileKind {
  std::string name;
  std::string meaning;
  /// Reads a text as such a file.
  void (*read)(const std::string& toml, TomlKeys* keys);
  /// Files for which the readers ask for every key; the first is the smallest.
  std::vector<std::string> examples;
};

/// Keys of both monitors and headsets.
constexpr const char* screen = R"(
title = "A display"
width_px = 1920
height_px = 1080
refresh_rate_hz = 60
scan_out = { duration_ms = 16.7, provenance = "assumed" }
)";

constexpr const char* example_name = "example.toml";

std::vector<FileKind> file_kinds() {
  return {{.name = "protocol",
           .meaning = "A study of foveated previews: its scenes and methods, their order, the "
                      "participants' questions and the analysis. Settings cascade from the "
                      "protocol to the scene to the method.",
           .read = [](const std::string& toml,
                      TomlKeys* keys) { read_protocol(toml, example_name, keys); },
           .examples = {smallest_protocol, std::string(smallest_protocol) + R"(
mark = [{ id = "outline", instruction = "Press." }, { id = "shape", instruction = "Press." }]
practice = [{ scene = "arcade", method = "fv" }]
override = [{ scene = "arcade" }]
display = { fov_deg = [100, 90] }
tracker = { validation = {}, filter = { hold_s = 0.6, one_euro = {} } }
reaction = {}
analysis = { primary = [{ measure = "outline", method = "fv" }] }
rating = )" + questions + R"(
questionnaire = [{ id = "debrief", title = "Afterwards", question = )" +
                                               questions + "}]"}},
          {.name = "questionnaire file",
           .meaning = "A questionnaire in a file of its own, which a protocol names by `file` in "
                      "`[[questionnaire]]`.",
           .read = [](const std::string& toml,
                      TomlKeys* keys) { read_questionnaire_file(example_name, toml, keys); },
           .examples = {std::string("title = \"Afterwards\"\nquestion = ") + questions}},
          {.name = "display profile",
           .meaning = "The facts of a display. A protocol names it by `profile` in "
                      "`[display]`; the program's own are in `data/displays`.",
           .read = [](const std::string& toml,
                      TomlKeys* keys) { display_profile_in(toml, example_name, keys); },
           .examples = {"title = \"By OpenXR\"\nkind = \"openxr\"", std::string(screen) + R"(
kind = "headset"
horizontal_fov_deg = 100
vertical_fov_deg = 100
lens = { k1 = 0.1, k2 = 0.05 }
)",
                        std::string(screen) + R"(
kind = "monitor"
width_m = 0.5313
height_m = 0.2989
viewing_distance_m = 0.6
measured = { date = "2026-01-31" }
timing_patch = { corner = "bottom left" }
)"}},
          {.name = "tracker profile",
           .meaning = "The facts of an eye tracker. A protocol names it by `profile` in "
                      "`[tracker]`; the program's own are in `data/trackers`.",
           .read = [](const std::string& toml,
                      TomlKeys* keys) { tracker_profile_in(toml, example_name, keys); },
           .examples = {tracker_from(R"(source = "simulated")"),
                        tracker_from(R"(source = "open-gaze")"),
                        tracker_from("source = \"recorded\"\nrecording = \"gaze.csv\"")}}};
}

class TableWalk {
 public:
  explicit TableWalk(const FileKind& kind) : kind_(kind) {
    TomlKeys asked;
    for (const std::string& example : kind.examples) {
      kind.read(example, &asked);
      if (keys_of_smallest_.empty()) {
        keys_of_smallest_ = asked.keys();
      }
    }
    keys_ = asked.keys();
    add("", kind.meaning, "table");
  }

  std::vector<DescribedTable> tables() && { return std::move(tables_); }

 private:
  /// Adds the table, then its inner tables.
  void add(const std::string& name, const std::string& meaning, std::string_view type) {
    DescribedTable table{.file = kind_.name,
                         .name = name,
                         .is_list = type == "list of tables",
                         .is_keyed_by_ids = type == "table by ids",
                         .meaning = meaning,
                         .keys = {}};
    // Further examples may have further ids.
    std::ranges::copy_if(table.is_keyed_by_ids ? keys_of_smallest_ : keys_,
                         std::back_inserter(table.keys),
                         [&](const TomlKey& key) { return key.table == name; });
    const std::size_t index = tables_.size();
    tables_.push_back(std::move(table));
    for (const TomlKey& key : std::vector(tables_[index].keys)) {
      if (is_table(key)) {
        add(name.empty() ? key.key : name + "." + key.key, key.meaning, key.types.front());
      }
    }
  }

  const FileKind& kind_;
  std::vector<TomlKey> keys_;
  std::vector<TomlKey> keys_of_smallest_;
  std::vector<DescribedTable> tables_;
};

}  // namespace

bool is_table(const TomlKey& key) {
  return key.types.front().starts_with("table") || key.types.front() == "list of tables";
}

std::vector<DescribedTable> described_tables() {
  std::vector<DescribedTable> tables;
  for (const FileKind& kind : file_kinds()) {
    std::ranges::move(TableWalk(kind).tables(), std::back_inserter(tables));
  }
  return tables;
}

}  // namespace foveola::study
