#include "study/record/verify/verification_json.h"

#include <nlohmann/json.hpp>

namespace foveola::study {
namespace {

nlohmann::ordered_json list_of(const std::vector<RecordFault>& faults) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const RecordFault& fault : faults) {
    list.push_back({{"participant", fault.participant}, {"what", fault.what}});
  }
  return list;
}

}  // namespace

nlohmann::ordered_json verification_json(const Verification& found) {
  return {{"sessions", found.sessions},  {"events", found.events},
          {"chunks", found.chunks},      {"faults", list_of(found.faults)},
          {"gaps", list_of(found.gaps)}, {"warnings", list_of(found.warnings)}};
}

}  // namespace foveola::study
