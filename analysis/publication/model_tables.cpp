#include <utility>

#include "analysis/publication/comparison_tables.h"
#include "analysis/publication/result_tables.h"

namespace foveola::analysis {

using enum ColumnType;

Table models_table(const StudyTables& tables, const Comparisons& comparisons) {
  using M = FittedModel;
  using Fit = FittedModel::Fit;
  const auto of_fit = [](const char* name, const char* description, auto value) {
    return ColumnOf<M>{{name, number, "", description},
                       [=](const M& row) { return field_in(row.fit, value); }};
  };
  const auto end = [](const Fit& fit, double Interval::* which) {
    return fit.interval ? std::optional(*fit.interval.*which) : std::nullopt;
  };
  const ColumnsOf<M> columns = {
      {{"measure", text, "", "Id of the mark or rating"},
       [](const M& row) { return field(row.measure); }},
      {{"method", text, "", "Id of the method"}, [](const M& row) { return field(row.method); }},
      {{"reference", text, "", "Id of the method that it is compared with"},
       [](const M& row) { return field(row.reference); }},
      {{"model", text, "",
        "crossed: mixed model of log times, or of points on a scale with many; tobit: of log times "
        "with right-censored ones; ordinal: cumulative link mixed model of ratings"},
       [](const M& row) { return field(row.model); }},
      {{"scale", text, "", "ratio of times, odds ratio of a higher rating, or points"},
       [](const M& row) { return field(std::string(name_of(row.scale))); }},
      of_fit("estimate", "Natural logarithm of the ratio or odds ratio, or points",
             [](const Fit& fit) { return fit.estimate; }),
      of_fit("standard_error", "Its standard error",
             [](const Fit& fit) { return fit.standard_error; }),
      of_fit("df", "Its degrees of freedom", [](const Fit& fit) { return fit.degrees_of_freedom; }),
      of_fit("ci95_low", "Lower end of its 95 % interval",
             [=](const Fit& fit) { return end(fit, &Interval::low); }),
      of_fit("ci95_high", "Upper end of its 95 % interval",
             [=](const Fit& fit) { return end(fit, &Interval::high); }),
      of_fit("p", "Its two-sided P", [](const Fit& fit) { return fit.p; }),
      {{"trials", whole, "", "Trials of the model"},
       [](const M& row) { return field(row.trials); }},
      {{"participants", whole, "", "Participants of the model"},
       [](const M& row) { return field(row.participants); }},
      {{"scenes", whole, "", "Scenes of the model"},
       [](const M& row) { return field(row.scenes); }},
      {{"censored", whole, "", "Trials with a right-censored time"},
       [](const M& row) { return field(row.censored); }},
      {{"participant_sd", number, "",
        "Standard deviation between participants of the difference between the methods"},
       [](const M& row) { return field(row.participant_sd); }},
      {{"scene_sd", number, "",
        "Standard deviation between scenes of the difference between the methods"},
       [](const M& row) { return field(row.scene_sd); }},
      {{"residual_sd", number, "", "Standard deviation of the difference within a scene"},
       [](const M& row) { return field(row.residual_sd); }},
      {{"note", text, "", "Why there is no estimate, or warnings of R"},
       [](const M& row) { return field(row.note); }},
      kind_of_all<M>(tables)};
  return tabulate("models", "model that R fitted (--r)", columns, comparisons.models.models);
}

Table model_versions_table(const StudyTables& tables, const Comparisons& comparisons) {
  using V = std::pair<std::string, std::string>;
  const ColumnsOf<V> columns = {
      {{"name", text, "", "R or one of its packages"},
       [](const V& row) { return field(row.first); }},
      {{"version", text, "", "Its version"}, [](const V& row) { return field(row.second); }},
      kind_of_all<V>(tables)};
  return tabulate("model_versions", "program that fitted models (--r)", columns,
                  comparisons.models.versions);
}

}  // namespace foveola::analysis
