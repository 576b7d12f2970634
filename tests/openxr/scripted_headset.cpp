#include "tests/openxr/scripted_headset.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace foveola::test {
namespace {

void set(const char* variable, const std::string& value) { ::setenv(variable, value.c_str(), 1); }

}  // namespace

ScriptedHeadset::ScriptedHeadset(const std::string& script, Validation validation) {
  play(script);
  set("XR_RUNTIME_JSON", OPENXR_MANIFEST);
  set("XR_ENABLE_API_LAYERS",
      validation == Validation::on ? "XR_APILAYER_LUNARG_core_validation" : "");
  set("XR_CORE_VALIDATION_EXPORT_TYPE", "text");
  set("XR_CORE_VALIDATION_FILE_NAME", folder_ / "invalid");
  set("FOVEOLA_OPENXR_SCRIPT", folder_ / "script.json");
  set("FOVEOLA_OPENXR_LOG", folder_ / "log");
  set("FOVEOLA_OPENXR_PICTURES", pictures_.path());
}

void ScriptedHeadset::play(const std::string& script) const {
  folder_.write("script.json", script);
}

std::vector<nlohmann::json> ScriptedHeadset::log(const std::string& kind) const {
  std::ifstream file(folder_ / "log");
  std::vector<nlohmann::json> lines;
  for (std::string text; std::getline(file, text);) {
    nlohmann::json line = nlohmann::json::parse(text);
    if (line.at("kind") == kind) {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::string ScriptedHeadset::found_invalid() const {
  std::istringstream said(folder_.content()["invalid"]);
  std::string invalid;
  for (std::string line; std::getline(said, line);) {
    // A newer one says, too, that it is there.
    invalid += line.find("[VALID_DEBUG ") == std::string::npos ? line + "\n" : "";
  }
  return invalid;
}

std::map<std::string, std::string> ScriptedHeadset::pictures() const { return pictures_.content(); }

}  // namespace foveola::test
