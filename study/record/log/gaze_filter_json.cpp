#include "study/record/log/gaze_filter_json.h"

#include <nlohmann/json.hpp>

namespace foveola::study {

nlohmann::ordered_json json_of(const GazeFilterSettings& filter) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (filter.one_euro) {
    json["one_euro"] = {{"min_cutoff_hz", filter.one_euro->min_cutoff_hz},
                        {"beta_per_deg", filter.one_euro->beta_per_deg},
                        {"derivative_cutoff_hz", filter.one_euro->derivative_cutoff_hz}};
  }
  if (filter.extrapolate_s) {
    json["extrapolate_s"] = *filter.extrapolate_s;
  }
  if (filter.hold_s) {
    json["hold_s"] = *filter.hold_s;
  }
  return json;
}

}  // namespace foveola::study
