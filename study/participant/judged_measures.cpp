#include "study/participant/judged_measures.h"

#include <string>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/participant/ratings.h"
#include "study/protocol/protocol_places.h"

namespace foveola::study {
namespace {

[[noreturn]] void refuse(const Protocol& protocol, const std::string& toml_path,
                         const std::string& what) {
  throw Error(ProtocolPlaces(protocol).of(toml_path), "simulated participants cannot judge " + what,
              "say which judgement simulates it (of a mark: simulated = \"outline\" or "
              "\"material\"; of a rating on a scale: simulated = \"artifacts\" or \"quality\"), or "
              "draw its values with study simulate --inject order:1");
}

}  // namespace

std::optional<Task> judgement_of(const MarkEntry& mark) {
  if (mark.simulated == "outline") {
    return Task::mark_outline;
  }
  return mark.simulated == "material" ? std::optional(Task::mark_material) : std::nullopt;
}

void require_judgements(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.marks.size(); ++i) {
    if (!judgement_of(protocol.marks[i])) {
      refuse(protocol, fmt::format("mark[{}].id", i), "the mark " + protocol.marks[i].id);
    }
  }
  for (std::size_t i = 0; i < protocol.ratings.size(); ++i) {
    const Question& rating = protocol.ratings[i];
    if (!is_judged(rating) && rating.kind != QuestionKind::text) {
      refuse(protocol, fmt::format("rating[{}].id", i), "the rating " + rating.id);
    }
  }
}

}  // namespace foveola::study
