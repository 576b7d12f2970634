#include "analysis/r_models/models_plan.h"

namespace foveola::analysis {

Table models_plan(const Dataset& set, const std::vector<ComparedPair>& pairs,
                  study::SceneEffects scenes, ModelDetail detail) {
  using P = ComparedPair;
  const ColumnsOf<P> columns = {
      {"measure", "", "Id of the mark or rating",
       [&](const P& pair) { return set.measures[pair.measure].id(); }},
      {"kind", "", "Kind of measure: time; points: a rating with few; scale: a rating with many",
       [&](const P& pair) {
         const Measure& measure = set.measures[pair.measure];
         return measure.is_time() ? "time" : measure.points().empty() ? "scale" : "points";
       }},
      {"method", "", "Id of the method", [&](const P& pair) { return set.methods[pair.method]; }},
      {"reference", "", "Id of the reference method",
       [&](const P& pair) { return set.methods[pair.reference]; }},
      {"scenes", "", "Whether scenes are random or fixed, by the protocol",
       [&](const P& /*pair*/) { return scenes; }},
      {"detail", "",
       "Detail: full, with profile intervals and estimates without each participant; or p_only",
       [&](const P& /*pair*/) { return detail == ModelDetail::full ? "full" : "p_only"; }}};
  Table plan = tabulate("models_plan", "comparison that models.R fits", columns, pairs);
  plan.texts = CsvTexts::as_typed;
  return plan;
}

}  // namespace foveola::analysis
