#include "study/protocol/reference/protocol_reference.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/transformed.h"
#include "study/protocol/reference/protocol_keys.h"

namespace foveola::study {
namespace {

constexpr const char* before_the_smallest =
    R"md(# Protocols: every key

This page is what `foveola study keys` prints: it comes from the code that reads protocols, as does `protocols/foveola-protocol.schema.json` (`foveola study keys --schema`), from which editors show the same.

A protocol describes a study in one TOML file: which scenes are rendered with which methods, in which order, what participants mark and are asked, and what is analysed. This is the smallest one:

```toml
)md";

constexpr const char* after_the_smallest = R"md(```

Everything else has a default, mostly that of the published study (Koskela et al. 2018). `protocols/koskela2018.toml` is that study, with a comment on where each setting comes from, and `protocols/demo.toml` a small one.

`foveola study check PROTOCOL` reads a protocol and says what it asks for. A key that is not on this page, a wrong type, a value out of range or a design that cannot be is refused with file, line and column. So is a file of over 4 MB, a list of over 1000 entries, over 100 methods or questionnaires, or a session of over 1000 trials.

An editor that knows TOML schemas (Taplo, Even Better TOML) completes and explains every key if the file begins with the schema's place, for a protocol beside the program's own:

```toml
#:schema ./foveola-protocol.schema.json
```

## Where files are looked for

| what | where, in this order |
|---|---|
| a protocol by its name | `~/.local/share/foveola/protocols`, then the program's own `protocols` |
| a scene by its name | beside the protocol, in `~/.local/share/foveola/scenes`, then the program's own; [the whole order](../scenes/DESCRIPTORS.md#where-scenes-are-looked-for) |
| a questionnaire by its name | beside the protocol, in `~/.local/share/foveola/questionnaires`, then the program's own `protocols/questionnaires` |
| a profile by its name | the program's own `data/displays` or `data/trackers` |
| any of these by a path, and the image of a mask | a path begins in the protocol's folder |

A protocol given as a path is that file. `$XDG_DATA_HOME/foveola` takes the place of `~/.local/share/foveola` if that variable is set. Files of questionnaires, profiles and masks that are given by a path must lie in the protocol's folder or below. The protocols that come with the program mean the scenes and questionnaires that come with it.

## How to read the tables

A default of “none” means that nothing is asked for or set unless the key is there; one that “varies” depends on other keys, and what is “required of some” is required as other keys say: see the meaning. Units are in the keys' names: `_s` are seconds, `_deg` degrees, `_hz` hertz, `_m` metres, `_ms` milliseconds, `_px` pixels.
)md";

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string code(const std::string& text) { return '`' + text + '`'; }

bool is_text(const TomlKey& key) { return key.types.front() == "text"; }

/// Returns "[tracker.validation]", or "[[mark]]" for a list of tables.
std::string heading_of(const DescribedTable& table) {
  return table.is_list ? "[[" + table.name + "]]" : "[" + table.name + "]";
}

/// Returns the heading of a table's section. A file's own keys have the file's name.
std::string title_of(const DescribedTable& table) {
  if (table.file == "protocol") {
    return table.name.empty() ? "The protocol itself" : code(heading_of(table));
  }
  const std::string file = "a " + table.file;
  return table.name.empty() ? "The keys of " + file : code(heading_of(table)) + " of " + file;
}

/// Returns GitHub's anchor of a heading.
std::string anchor_of(const std::string& title) {
  std::string anchor;
  for (const unsigned char letter : title) {
    if (std::isalnum(letter) != 0 || letter == '_' || letter == '-') {
      anchor += static_cast<char>(std::tolower(letter));
    } else if (letter == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

std::string link_to(const DescribedTable& table) {
  return fmt::format("[{}](#{})", code(heading_of(table)), anchor_of(title_of(table)));
}

std::string number_text(double number) {
  constexpr double largest_counted = 1e15;
  return number == std::round(number) && std::abs(number) < largest_counted
             ? fmt::format("{:.0f}", number)
             : fmt::format("{}", number);
}

std::string range_of(const TomlKey& key) {
  const std::vector<std::string> words = transformed(
      key.words, [&](const std::string& word) { return code(is_text(key) ? quoted(word) : word); });
  if (!words.empty()) {
    return fmt::format("{}", fmt::join(words, ", "));
  }
  return key.minimum ? fmt::format("{} to {}", number_text(*key.minimum), number_text(*key.maximum))
                     : "";
}

std::string default_of(const TomlKey& key) {
  if (key.is_required) {
    return "required";
  }
  if (key.default_varies) {
    return "varies";
  }
  if (!key.default_text) {
    return key.is_sometimes_required ? "required of some" : "none";
  }
  return code(is_text(key) ? quoted(*key.default_text) : *key.default_text);
}

std::pair<std::string, std::string> first_sentence(const std::string& text) {
  constexpr std::size_t longest_cell = 120;
  const std::size_t end = text.size() > longest_cell ? text.find(". ") : std::string::npos;
  return end == std::string::npos ? std::pair(text, std::string())
                                  : std::pair(text.substr(0, end + 1), text.substr(end + 2));
}

std::string with_former_name(const TomlKey& key) {
  return key.former.empty() ? key.meaning
                            : fmt::format("{} Formerly `{}`.", key.meaning, key.former);
}

/// Returns the keys that are not tables. Cells are short: further sentences follow below.
std::string keys_in_markdown(const DescribedTable& table) {
  std::string rows;
  std::string rest;
  for (const TomlKey& key : table.keys) {
    if (is_table(key)) {
      continue;
    }
    const auto [first, further] = first_sentence(with_former_name(key));
    rows += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.key, fmt::join(key.types, " or "),
                        range_of(key), default_of(key), first);
    if (!further.empty()) {
      rest += fmt::format("\n`{}`: {}\n", key.key, further);
    }
  }
  return rows.empty()
             ? ""
             : "| key | type | range or words | default | meaning |\n|---|---|---|---|---|\n" +
                   rows + rest + "\n";
}

std::string texts_in_markdown(const DescribedTable& table) {
  std::string rows = "| key | the built-in words |\n|---|---|\n";
  for (const TomlKey& key : table.keys) {
    std::string words = key.default_text.value_or("");
    for (std::size_t at = words.find('\n'); at != std::string::npos; at = words.find('\n', at)) {
      words.replace(at, 1, " ");
    }
    rows += fmt::format("| `{}` | {} |\n", key.key, words);
  }
  return rows + "\n";
}

bool has_same_keys(const DescribedTable& one, const DescribedTable& other) {
  return std::equal(one.keys.begin(), one.keys.end(), other.keys.begin(), other.keys.end(),
                    [](const TomlKey& a, const TomlKey& b) {
                      return a.key == b.key && a.types == b.types && a.minimum == b.minimum &&
                             a.maximum == b.maximum && a.words == b.words &&
                             a.is_required == b.is_required && a.meaning == b.meaning;
                    });
}

std::string inner_tables(const DescribedTable& table, const std::vector<DescribedTable>& all) {
  std::vector<std::string> links;
  const std::string prefix = table.name.empty() ? "" : table.name + ".";
  for (const DescribedTable& other : all) {
    if (other.file == table.file && other.name.size() > prefix.size() &&
        other.name.starts_with(prefix) &&
        other.name.find('.', prefix.size()) == std::string::npos) {
      links.push_back(link_to(other));
    }
  }
  return links.empty() ? "" : fmt::format("Tables in it: {}.\n\n", fmt::join(links, ", "));
}

std::string section_of(std::size_t index, const std::vector<DescribedTable>& all) {
  const DescribedTable& table = all[index];
  std::string text = fmt::format("{} {}\n\n", table.name.empty() ? "##" : "###", title_of(table));
  if (!table.meaning.empty()) {
    text += table.meaning + "\n\n";
  }
  const auto before = all.begin() + static_cast<std::ptrdiff_t>(index);
  const auto same = std::find_if(all.begin(), before, [&](const DescribedTable& other) {
    return has_same_keys(table, other);
  });
  if (same != before) {
    return text + fmt::format("It has the keys of {}.\n\n", link_to(*same));
  }
  if (table.is_keyed_by_ids) {
    text += "The keys are ids of the study's own; for those of the published study they are:\n\n";
  }
  text += table.name == "texts" ? texts_in_markdown(table) : keys_in_markdown(table);
  return text + inner_tables(table, all);
}

nlohmann::ordered_json json_of(const TomlKey& key) {
  nlohmann::ordered_json json = {{"key", key.key},     {"types", key.types},
                                 {"minimum", nullptr}, {"maximum", nullptr},
                                 {"words", key.words}, {"required", key.is_required},
                                 {"default", nullptr}, {"default_varies", key.default_varies},
                                 {"former", nullptr},  {"meaning", key.meaning}};
  if (key.minimum) {
    json["minimum"] = *key.minimum;
    json["maximum"] = *key.maximum;
  }
  if (key.default_text) {
    json["default"] = is_text(key) ? nlohmann::ordered_json(*key.default_text)
                                   : nlohmann::ordered_json::parse(*key.default_text);
  }
  if (!key.former.empty()) {
    json["former"] = key.former;
  }
  return json;
}

}  // namespace

std::string protocol_reference() {
  std::vector<DescribedTable> tables = described_tables();
  // The longest table is for reference, not for reading.
  std::stable_partition(tables.begin(), tables.end(), [](const DescribedTable& table) {
    return table.file == "protocol" && table.name != "texts";
  });
  std::string text =
      std::string(before_the_smallest) + smallest_protocol + after_the_smallest + "\n";
  for (std::size_t i = 0; i < tables.size(); ++i) {
    text += section_of(i, tables);
  }
  text.pop_back();  // The last section's empty line.
  return text;
}

nlohmann::ordered_json protocol_reference_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DescribedTable& table : described_tables()) {
    nlohmann::ordered_json keys = nlohmann::ordered_json::array();
    for (const TomlKey& key : table.keys) {
      keys.push_back(json_of(key));
    }
    list.push_back({{"file", table.file},
                    {"table", table.name},
                    {"is_list", table.is_list},
                    {"keyed_by_ids", table.is_keyed_by_ids},
                    {"meaning", table.meaning},
                    {"keys", std::move(keys)}});
  }
  return {{"tables", std::move(list)}};
}

}  // namespace foveola::study
