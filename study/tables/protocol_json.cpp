#include "study/tables/protocol_json.h"

#include <nlohmann/json.hpp>

#include "renderer/base/transformed.h"
#include "study/protocol/untranslated.h"
#include "study/record/log/gaze_filter_json.h"

namespace foveola::study {
namespace {

using Json = nlohmann::json;

Json json_profiles(const Protocol& protocol) {
  Json names = Json::object();
  for (const NamedProfile& profile : named_profiles(protocol)) {
    if (profile.device != "questionnaire") {
      names[profile.device] = profile.name;
    }
  }
  return names;
}

Json json_file(const MethodFile& file) {
  return {{"method", file.method}, {"file", file.file}, {"sha256", file.sha256}};
}

Json json_comparison(const PlannedComparison& comparison) {
  return {{"measure", comparison.measure},
          {"method", comparison.method},
          {"baseline", comparison.baseline}};
}

Json json_questionnaires(const Protocol& protocol) {
  Json questionnaires = Json::object();
  for (const Questionnaire& questionnaire : protocol.questionnaires) {
    questionnaires[questionnaire.id] = transformed(questionnaire.questions, &Question::id);
  }
  return questionnaires;
}

Json json_analysis(const AnalysisPlan& plan) {
  return {{"participants", plan.participants ? Json(*plan.participants) : Json()},
          {"alpha", plan.alpha},
          {"scenes", name_of(plan.scenes)},
          {"ratings", name_of(plan.ratings)},
          {"primary", transformed(plan.primary, json_comparison)},
          {"equivalence_margins", plan.equivalence_margins}};
}

Json json_of(const Duration& duration) {
  return {{"least_s", duration.least_s}, {"most_s", duration.most_s}};
}

}  // namespace

Json json_of(const Protocol& protocol) {
  return {{"protocol", protocol.path.string()},
          {"name", protocol.name},
          {"title", protocol.title},
          {"language", protocol.language},
          {"untranslated", untranslated_texts(protocol).keys},
          {"film_bytes", memory_of(protocol.film)},
          {"sha256", protocol.sha256},
          {"scenes", transformed(protocol.scenes, &SceneEntry::name)},
          {"methods", protocol.methods},
          {"scene_order", name_of(protocol.scene_order)},
          {"method_order", name_of(protocol.method_order)},
          {"design_rows", design_rows(protocol)},
          {"method_files", transformed(protocol.method_files, json_file)},
          {"profiles", json_profiles(protocol)},
          {"gaze_filter", json_of(protocol.tracker.filter)},
          {"phases",
           transformed(protocol.phases, [](const PhaseEntry& phase) { return name_of(phase); })},
          {"marks", transformed(protocol.marks, &MarkEntry::id)},
          {"ratings", transformed(protocol.ratings, &Question::id)},
          {"questionnaires", json_questionnaires(protocol)},
          {"trials_per_participant", protocol.scenes.size() * protocol.methods.size()},
          {"practice_trials", protocol.practice.size()},
          {"catch_trials", protocol.catch_trials.count},
          {"analysis", json_analysis(protocol.analysis)}};
}

Json json_of(const Protocol& protocol, const Balance& balance) {
  Json in_scenes = Json::object();
  for (std::size_t scene = 0; scene < protocol.scenes.size(); ++scene) {
    in_scenes[protocol.scenes[scene].name] = balance.method_at_in[scene];
  }
  return {{"method_at", balance.method_at},
          {"method_at_in", in_scenes},
          {"method_after", balance.method_after},
          {"scene_at", balance.scene_at},
          {"scene_after", balance.scene_after},
          {"largest_difference",
           {{"method_at", largest_difference(balance.method_at)},
            {"method_after", largest_difference_after(balance.method_after)},
            {"scene_at", largest_difference(balance.scene_at)},
            {"scene_after", largest_difference_after(balance.scene_after)}}}};
}

Json json_of(const std::vector<SessionPart>& parts) {
  Json all = json_of(total_of(parts));
  all["parts"] = transformed(parts, [](const SessionPart& part) {
    Json json = json_of(part.duration);
    json["part"] = part.name;
    json["count"] = part.count;
    return json;
  });
  return all;
}

Json json_of(const Plan& plan) {
  return transformed(plan, [](const PlannedTrial& trial) {
    return Json{{"scene", trial.scene}, {"method", trial.method}, {"kind", name_of(trial.kind)}};
  });
}

}  // namespace foveola::study
