#include "renderer/scene/warnings.h"

#include <fmt/format.h>

namespace foveola {

void Warnings::add(const std::string& what, const std::string& where, std::size_t count) {
  if (count == 0) {
    return;
  }
  cases_ += count;
  const auto [known, is_new] = index_of_.try_emplace(what, kinds_.size());
  if (is_new) {
    kinds_.push_back({.what = what, .first_place = where, .count = count});
  } else {
    kinds_[known->second].count += count;
  }
}

std::vector<std::string> Warnings::lines() const {
  std::vector<std::string> lines;
  for (const Kind& kind : kinds_) {
    std::string line = kind.what;
    const bool has_place = !kind.first_place.empty();
    if (kind.count > 1) {
      line += fmt::format(" ({} times{}{})", kind.count, has_place ? ", first at " : "",
                          kind.first_place);
    } else if (has_place) {
      line += fmt::format(" ({})", kind.first_place);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace foveola
