#include "study/participant/injected_effects/effect_on_protocol.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"
#include "study/participant/injected_effects/drawn_trial.h"
#include "study/protocol/measure.h"

namespace foveola::study {
namespace {

/// Minimum ratio of a mark's median time to the previous mark's: marks are made one after the
/// other, at least a glance apart.
constexpr double least_mark_ratio = 2.0;

/// Throws UsageError if `id` is not one of `there`, all ids of the protocol's `kind`.
void require_known(const std::string& where, const std::string& kind, const std::string& id,
                   const std::vector<std::string>& there) {
  if (std::ranges::find(there, id) == there.end()) {
    throw UsageError(where, fmt::format("the protocol has no {} '{}'", kind, id),
                     there.empty() ? fmt::format("the protocol has no {}; remove this effect", kind)
                                   : fmt::format("choose one of {}", fmt::join(there, ", ")));
  }
}

template <typename Entries>
std::vector<std::string> ids_of(const Entries& entries) {
  return transformed(entries, [&](const auto& entry) { return entry.id; });
}

void require_drawable_shifts(const std::string& where, const Question& rating,
                             const InjectedEffect::ByMethod& shifts) {
  if (!Measure{.kind = MeasureKind::rating, .questionnaire = {}, .question = rating}.is_numeric()) {
    throw UsageError(where, fmt::format("the answers to '{}' are not numbers", rating.id),
                     "shift a rating on a scale, a number, or a choice whose options have values");
  }
  const double scale = span_of(rating).width();
  const double shifted = span_of(shifts).width();
  if (!(shifted < scale)) {
    throw UsageError(where,
                     fmt::format("shifts {:g} apart do not fit on the scale of '{}', which "
                                 "is {:g} wide",
                                 shifted, rating.id, scale),
                     "use smaller shifts");
  }
}

double factor_of(const InjectedEffect& effect, const std::string& mark, const std::string& method) {
  const auto of_mark = effect.faster_marks.find(mark);
  if (of_mark == effect.faster_marks.end() || !of_mark->second.contains(method)) {
    return 1.0;
  }
  return of_mark->second.at(method);
}

void require_marks_in_order(const InjectedEffect& effect, const Protocol& protocol) {
  const double most = TimesModel{}.mark_ratio / least_mark_ratio;
  for (const std::string& method : protocol.methods) {
    for (std::size_t i = 1; i < protocol.marks.size(); ++i) {
      const std::string& mark = protocol.marks[i].id;
      const std::string& before = protocol.marks[i - 1].id;
      if (factor_of(effect, mark, method) > most * factor_of(effect, before, method)) {
        throw UsageError(
            "--inject faster-mark",
            fmt::format("with {} the mark '{}' would follow '{}' too soon", method, mark, before),
            fmt::format("use a factor of at most {:g} times that of '{}'", most, before));
      }
    }
  }
}

}  // namespace

void require_drawable(const InjectedEffect& effect, const Protocol& protocol) {
  for (const auto& [method, factor] : effect.faster) {
    require_known(fmt::format("--inject faster:{}:{}", method, factor), "method", method,
                  protocol.methods);
  }
  for (const auto& [mark, factors] : effect.faster_marks) {
    for (const auto& [method, factor] : factors) {
      const std::string where = fmt::format("--inject faster-mark:{}:{}:{}", mark, method, factor);
      require_known(where, "mark", mark, ids_of(protocol.marks));
      require_known(where, "method", method, protocol.methods);
    }
  }
  require_marks_in_order(effect, protocol);
  for (const auto& [id, shifts] : effect.shifted_ratings) {
    for (const auto& [method, points] : shifts) {
      const std::string where = fmt::format("--inject shift-rating:{}:{}:{}", id, method, points);
      const std::string& wanted = id;
      require_known(where, "rating", id, ids_of(protocol.ratings));
      require_known(where, "method", method, protocol.methods);
      require_drawable_shifts(where, *std::ranges::find(protocol.ratings, wanted, &Question::id),
                              shifts);
    }
  }
}

}  // namespace foveola::study
