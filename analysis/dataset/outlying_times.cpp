#include "analysis/dataset/outlying_times.h"

#include <cmath>

#include "analysis/dataset/participant_values.h"
#include "analysis/statistics/residual_outliers.h"

namespace foveola::analysis {

std::vector<OutlyingTime> outlying_times(const Dataset& set) {
  std::vector<OutlyingTime> outlying;
  for (const std::size_t mark : set.times()) {
    std::vector<TrialValue> logs;
    for (const OrderedValue& value : ordered_values(set, mark, OrderOf::trials)) {
      logs.push_back({value.participant, value.condition, value.value});
    }
    for (const ResidualOutlier& outlier : residual_outliers(logs)) {
      const TrialValue& trial = logs[outlier.index];
      outlying.push_back({.mark = set.measures[mark].id(),
                          .participant = set.participants[trial.participant],
                          .scene = set.scenes[trial.condition / set.methods.size()],
                          .method = set.methods[trial.condition % set.methods.size()],
                          .seconds = std::exp(trial.value),
                          .times_expected = std::exp(outlier.deviation),
                          .studentized = outlier.studentized});
    }
  }
  return outlying;
}

}  // namespace foveola::analysis
