#include "renderer/base/text/similar_word.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace foveola {
namespace {

/// Maximum number of edits of a typing error. More of them lead to unrelated words.
constexpr std::size_t max_edits = 2;

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Row i has the distances of the first i letters of `a` from each beginning of `b`.
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

std::optional<std::string> similar_word(std::string_view word,
                                        const std::vector<std::string>& known) {
  constexpr std::size_t longest = 100;
  std::optional<std::string> nearest;
  std::size_t fewest = max_edits + 1;
  for (const std::string& candidate : known) {
    const std::size_t length = std::max(word.size(), candidate.size());
    if (length > longest) {
      continue;
    }
    const std::size_t edits = edit_distance(word, candidate);
    if (edits < fewest && 3 * edits <= length) {
      nearest = candidate;
      fewest = edits;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known,
                         const std::string& otherwise) {
  const std::optional<std::string> meant = similar_word(word, known);
  return meant ? fmt::format("did you mean '{}'?", *meant) : otherwise;
}

}  // namespace foveola
