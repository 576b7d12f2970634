#include "tests/openxr/scripted_headset.h"

#include <fstream>
#include <sstream>

namespace foveola::test {

ScriptedHeadset::ScriptedHeadset(const std::string& script, Validation validation) {
  const auto set = [this](const char* variable, const std::string& value) {
    environment_.emplace_back(variable, value);
  };
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

std::vector<std::string> ScriptedHeadset::log_lines(const std::string& kind) const {
  std::ifstream file(folder_ / "log");
  std::vector<std::string> lines;
  const std::string entry = "\"kind\":\"" + kind + "\"";
  // A line without its end is still being written.
  for (std::string line; std::getline(file, line) && !file.eof();) {
    if (line.find(entry) != std::string::npos) {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::vector<nlohmann::json> ScriptedHeadset::log(const std::string& kind) const {
  std::vector<nlohmann::json> entries;
  for (const std::string& line : log_lines(kind)) {
    entries.push_back(nlohmann::json::parse(line));
  }
  return entries;
}

nlohmann::json ScriptedHeadset::newest_log(const std::string& kind) const {
  return nlohmann::json::parse(log_lines(kind).back());
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

std::filesystem::path ScriptedHeadset::picture_file(std::int64_t frame, int eye) const {
  return pictures_ / (std::to_string(frame) + "-" + std::to_string(eye) + ".ppm");
}

}  // namespace foveola::test
