#include "analysis/koskela2018/paper_notes.h"

#include "analysis/koskela2018/profile.h"

namespace foveola::analysis {

PaperNotes paper_notes(const Dataset& set) {
  if (!measures_what_was_published(set)) {
    return {};
  }
  return {.times_by_scene = "Table 2 of the published study.",
          .percentages =
              "The paper does not say how its percentages and percentage points were formed. Both "
              "readings are here: each participant’s own ratio, then the ratio of means.",
          .times_by_method = "Fig. 5 of the published study.",
          .ratings =
              "The rating artifacts is Fig. 6 of the published study: how disturbing artifacts "
              "were in the areas other than the chosen object.",
          .means_of_ratings = "The published study treated them so too.",
          .latency = "Fig. 7 of the published study.",
          .background =
              "The published study took graphics_3d and offline_rendering, and correlated their "
              "mean with OD − FV."};
}

}  // namespace foveola::analysis
