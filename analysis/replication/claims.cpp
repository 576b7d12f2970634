#include "analysis/replication/claims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fnmatch.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

/// Matches "19.5", "-0.55", "734 700".
const std::string number_pattern = R"((?:-|−)?\d+(?: \d{3})*(?:\.\d+)?)";

/// Matches {51}, or {51 [34, 75]} with its interval.
const std::regex& claimed_numbers() {
  static const std::regex pattern(fmt::format(R"(\{{({0}(?: \[{0}, {0}\])?)\}})", number_pattern));
  return pattern;
}

std::vector<std::string> numbers_in(const std::string& shown) {
  static const std::regex number(number_pattern);
  return {std::sregex_token_iterator(shown.begin(), shown.end(), number), {}};
}

double parse_number(std::string text) {
  std::erase(text, ' ');
  const std::string minus = "−";
  return text.starts_with(minus) ? -std::strtod(text.c_str() + minus.size(), nullptr)
                                 : std::strtod(text.c_str(), nullptr);
}

int decimals_of(const std::string& number) {
  const std::size_t point = std::min(number.find('.'), number.size() - 1);
  return static_cast<int>(number.size() - 1 - point);
}

std::string number_like(const std::string& shown, double value) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals_of(shown));
  for (std::size_t end = std::min(text.find('.'), text.size());
       end > 3 && shown.find(' ') != std::string::npos; end -= 3) {
    text.insert(end - 3, " ");
  }
  return (value >= 0.0 ? "" : shown.starts_with("−") ? "−" : "-") + text;
}

void read_text(TomlReader& reader, Claim& claim) {
  const std::string text = reader.require_text("text");
  claim.line = static_cast<int>(reader.source("text").begin.line);
  auto rest = text.begin();
  for (std::sregex_iterator i(rest, text.end(), claimed_numbers()), none; i != none; ++i) {
    claim.words.emplace_back(rest, (*i)[0].first);
    rest = (*i)[0].second;
    const std::string shown = (*i)[1];
    const std::vector<std::string> numbers = numbers_in(shown);
    ClaimValue value{parse_number(numbers[0])};
    if (numbers.size() == 3) {
      value.interval = Interval{parse_number(numbers[1]), parse_number(numbers[2])};
    }
    claim.numbers.push_back({shown, value, {}});
  }
  claim.words.emplace_back(rest, text.end());
  // Words around the numbers delimit them.
  if (claim.numbers.empty() || claim.words.front().empty() || claim.words.back().empty()) {
    reader.fail(reader.source("text"),
                "text must have numbers in braces, with words before and after",
                "write it as \"covers {94.4} %\" or \"takes {51 [34, 75]} s\"");
  }
}

void read_figures(TomlReader& reader, Claim& claim) {
  constexpr double largest = 1e9;
  reader.read("absolute", claim.tolerance.absolute, 0.0, largest);
  reader.read("relative", claim.tolerance.relative, 0.0, largest);
  reader.read("standard_errors", claim.tolerance.standard_errors, 0.0, largest);
  if (!reader.has("absolute") && !reader.has("relative") && !reader.has("standard_errors")) {
    reader.fail(reader.source(), fmt::format("claim '{}' has no tolerance", claim.id),
                "give absolute, relative or standard_errors");
  }
  const std::vector<TomlReader::Text> figures = reader.require_texts("figures");
  if (figures.size() != claim.numbers.size()) {
    reader.fail(reader.source("figures"), "figures do not match the numbers in braces",
                "name one figure per number");
  }
  for (std::size_t i = 0; i < figures.size(); ++i) {
    claim.numbers[i].figure = figures[i].value;
  }
}

ClaimStage read_stage(TomlReader& reader, const std::string& file) {
  constexpr double max_minutes = 100'000.0;
  ClaimStage stage{.id = reader.require_text("id")};
  for (const TomlReader::Text& command : reader.texts("run")) {
    stage.run.push_back(command.value);
  }
  reader.require(stage.run.empty() ? "needs" : "minutes");
  reader.read("result", stage.result);
  reader.read("needs", stage.needs);
  reader.read("minutes", stage.minutes, 0.0, max_minutes);
  reader.read("quick", stage.is_quick);
  for (TomlReader& inner : reader.tables("claim")) {
    Claim claim{.id = inner.require_text("id"), .place = place_of(file, inner.source())};
    claim.document = inner.require_text("document");
    read_text(inner, claim);
    if (!stage.run.empty()) {
      read_figures(inner, claim);
    }
    inner.reject_unknown_keys();
    stage.claims.push_back(std::move(claim));
  }
  reader.reject_unknown_keys();
  return stage;
}

fs::path document_file(const Claims& claims, const Claim& claim) {
  return (claims.file.parent_path() / ".." / claim.document).lexically_normal();
}

/// The begin and the end of each of a claim's numbers in a document.
using NumberSpans = std::vector<std::pair<std::size_t, std::size_t>>;

/// Throws Error unless the claim is exactly once in the document, with line breaks anywhere.
NumberSpans find_claim(const fs::path& file, const Claim& claim) {
  std::string document = read_file(file);
  std::ranges::replace(document, '\n', ' ');
  std::string text = claim.words[0];
  NumberSpans spans;
  std::string missing = "text";
  std::size_t known = 0;  // the number of matching pieces
  for (std::size_t i = 0; i < claim.numbers.size(); ++i) {
    const std::string& shown = claim.numbers[i].shown;
    if (const std::size_t begin = document.find(text); begin != std::string::npos) {
      missing = shown;
      known = begin + text.size();
    }
    spans.emplace_back(text.size(), text.size() + shown.size());
    text += shown + claim.words[i + 1];
  }
  const std::size_t begin = document.find(text);
  if (begin == std::string::npos || document.find(text, begin + 1) != std::string::npos) {
    const std::string lines = read_file(file).substr(0, known);
    throw Error(fmt::format("{}:{}", file.string(), std::ranges::count(lines, '\n') + 1),
                fmt::format("{} of claim '{}'",
                            begin == std::string::npos ? "does not state the " + missing
                                                       : "states more than once the text",
                            claim.id),
                "see " + claim.place);
  }
  for (auto& [from, to] : spans) {
    from += begin;
    to += begin;
  }
  return spans;
}

/// New texts for parts of a text, by their begins and ends.
using Edits = std::map<std::pair<std::size_t, std::size_t>, std::string>;

/// Returns the figure that a pattern matches, in which * is any text; of several, after "min " or
/// "max ", the minimum or maximum. Throws Error if it matches none, or several.
const BenchFigure& find_figure(const std::string& term, const std::vector<BenchFigure>& figures) {
  const bool is_least = term.starts_with("min ");
  const bool is_extreme = is_least || term.starts_with("max ");
  std::string glob;
  for (const char c : std::string_view(term).substr(is_extreme ? 4 : 0)) {
    glob += std::string_view("?[]\\").find(c) == std::string_view::npos ? "" : "\\";
    glob += c;
  }
  const BenchFigure* found = nullptr;
  for (const BenchFigure& figure : figures) {
    if (::fnmatch(glob.c_str(), figure.place.c_str(), 0) != 0) {
      continue;
    }
    if (found != nullptr && !is_extreme) {
      throw Error(term, "matches several figures of the results", "correct the claim");
    }
    found = found == nullptr || (figure.value < found->value) == is_least ? &figure : found;
  }
  if (found == nullptr) {
    throw Error(term, "matches no figure of the results", "correct the claim");
  }
  return *found;
}

/// Evaluates patterns and numbers joined by " * " and " / " from left to right, and so its interval
/// at both limits of the figures' intervals.
ClaimValue make_value(const std::string& expression, const std::vector<BenchFigure>& figures) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::array<double, 3> value_low_high = {1.0, 1.0, 1.0};
  bool is_quotient = false;
  for (std::size_t begin = 0; begin < expression.size();) {
    const std::size_t end =
        std::min({expression.find(" * ", begin), expression.find(" / ", begin), expression.size()});
    const std::string term = expression.substr(begin, end - begin);
    char* rest = nullptr;
    const double number = std::strtod(term.c_str(), &rest);
    std::array<double, 3> factor = {number, number, number};
    if (*rest != '\0') {
      const BenchFigure& figure = find_figure(term, figures);
      const Interval interval = figure.interval.value_or(Interval{unknown, unknown});
      factor = {figure.value, interval.low, interval.high};
    }
    for (std::size_t i = 0; i < factor.size(); ++i) {
      value_low_high[i] *= is_quotient ? 1.0 / factor[i] : factor[i];
    }
    is_quotient = expression.compare(end, 3, " / ") == 0;
    begin = end + 3;
  }
  const auto [low, high] = std::minmax(value_low_high[1], value_low_high[2]);
  return {value_low_high[0], low <= high ? std::optional(Interval{low, high}) : std::nullopt};
}

}  // namespace

Claims read_claims(const fs::path& file) {
  const std::string text = read_toml_file(file);
  const toml::table table = parse_toml(file.string(), text, "see docs/howto/replicate.md");
  Claims claims{.file = file, .sha256 = sha256(std::regex_replace(text, claimed_numbers(), "{}"))};
  TomlReader top(file.string(), table, "");
  std::set<std::string> ids;
  for (TomlReader& reader : top.tables("stage")) {
    claims.stages.push_back(read_stage(reader, file.string()));
    bool is_new = ids.insert(claims.stages.back().id).second;
    for (const Claim& claim : claims.stages.back().claims) {
      is_new = ids.insert(claim.id).second && is_new;
    }
    if (!is_new) {
      reader.fail(reader.source(), "repeats the id of another claim", "choose another id");
    }
  }
  top.reject_unknown_keys();
  return claims;
}

std::vector<std::string> faults_of_documents(const Claims& claims) {
  std::vector<std::string> faults;
  for (const ClaimStage& stage : claims.stages) {
    for (const Claim& claim : stage.claims) {
      try {
        find_claim(document_file(claims, claim), claim);
      } catch (const Error& fault) {
        faults.emplace_back(fault.what());
      }
    }
  }
  return faults;
}

std::string shown_like(const std::string& shown, const ClaimValue& value) {
  const std::vector<std::string> numbers = numbers_in(shown);
  std::string text = number_like(numbers[0], value.value);
  if (numbers.size() == 3 && value.interval) {
    text += fmt::format(" [{}, {}]", number_like(numbers[1], value.interval->low),
                        number_like(numbers[2], value.interval->high));
  }
  return text;
}

bool is_within(const Tolerance& tolerance, const ClaimedNumber& number, const ClaimValue& made) {
  // A 95 % confidence interval is 2 × 1.96 standard errors wide.
  const auto standard_error = [](const std::optional<Interval>& interval) {
    return interval ? (interval->high - interval->low) / 3.92 : 0.0;
  };
  const auto& [value, interval] = number.claimed;
  const double error = std::hypot(standard_error(made.interval),
                                  standard_error(interval ? interval : made.interval));
  const int decimals = decimals_of(numbers_in(number.shown).front());
  return std::abs(made.value - value) <= tolerance.absolute + tolerance.relative * std::abs(value) +
                                             tolerance.standard_errors * error +
                                             0.5000001 * std::pow(10.0, -decimals);
}

JudgedNumber judge(const ClaimedNumber& number, const Tolerance& tolerance,
                   const std::vector<BenchFigure>& figures) {
  try {
    const ClaimValue value = make_value(number.figure, figures);
    return {value, fmt::format("{:g}", value.value), !is_within(tolerance, number, value)};
  } catch (const Error& fault) {
    return {.remark = fault.what(), .is_outside = true};
  }
}

void write_values(const Claims& claims, const std::vector<NewValues>& made) {
  const std::string source = read_file(claims.file);
  std::map<fs::path, Edits> edits;
  for (const auto& [claim, values] : made) {
    const fs::path file = document_file(claims, *claim);
    const NumberSpans spans = find_claim(file, *claim);
    std::size_t at = 0;
    for (int line = 1; line < claim->line; ++line) {
      at = source.find('\n', at) + 1;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string& shown = claim->numbers[i].shown;
      const std::string text = shown_like(shown, values[i]);
      edits[file][spans[i]] = text;
      at = source.find("{" + shown + "}", at) + 1;
      edits[claims.file][{at, at + shown.size()}] = text;
    }
  }
  for (const auto& [file, of_file] : edits) {
    std::string text = read_file(file);
    for (auto edit = of_file.rbegin(); edit != of_file.rend(); ++edit) {
      const auto [begin, end] = edit->first;
      text.replace(begin, end - begin, edit->second);
    }
    write_file(file, text);
  }
}

}  // namespace foveola::analysis
