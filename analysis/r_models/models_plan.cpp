#include "analysis/r_models/models_plan.h"

namespace foveola::analysis {

using enum ColumnType;

Table models_plan(const Dataset& set, const std::vector<ComparedPair>& pairs,
                  study::SceneEffects scenes, ModelDetail detail) {
  const ColumnsOf<ComparedPair> columns = {
      {{"measure", text, "", "Id of the mark or rating"},
       [&](const ComparedPair& pair) { return field(set.measures[pair.measure].id()); }},
      {{"kind", text, "", "time; points: a rating with few; scale: a rating with many"},
       [&](const ComparedPair& pair) {
         const Measure& measure = set.measures[pair.measure];
         return field(std::string(measure.is_time()          ? "time"
                                  : measure.points().empty() ? "scale"
                                                             : "points"));
       }},
      {{"method", text, "", "Id of the method"},
       [&](const ComparedPair& pair) { return field(set.methods[pair.method]); }},
      {{"reference", text, "", "Id of the method that it is compared with"},
       [&](const ComparedPair& pair) { return field(set.methods[pair.reference]); }},
      {{"scenes", text, "", "Whether scenes are random or fixed, by the protocol"},
       [&](const ComparedPair& /*pair*/) { return field(name_of(scenes)); }},
      {{"detail", text, "",
        "full: with profile intervals and estimates without each participant; p_only: without"},
       [&](const ComparedPair& /*pair*/) {
         return field(std::string(detail == ModelDetail::full ? "full" : "p_only"));
       }}};
  Table plan = tabulate("models_plan", "comparison that models.R fits", columns, pairs);
  plan.texts = CsvTexts::as_typed;
  return plan;
}

}  // namespace foveola::analysis
