#include "analysis/dataset/fitted_model.h"

#include <algorithm>

namespace foveola::analysis {

const FittedModel* FittedModels::find(const std::string& model, const std::string& measure,
                                      const std::string& method,
                                      const std::string& reference) const {
  const auto found = std::ranges::find_if(models, [&](const FittedModel& row) {
    return row.model == model && row.measure == measure && row.method == method &&
           row.reference == reference;
  });
  return found != models.end() ? &*found : nullptr;
}

}  // namespace foveola::analysis
