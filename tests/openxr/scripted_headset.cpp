#include "tests/openxr/scripted_headset.h"

#include <fstream>

namespace foveola::test {

ScriptedHeadset::ScriptedHeadset(const std::string& script, Validation validation) {
  const auto set = [this](const char* variable, const std::string& value) {
    environment_.emplace_back(variable, value);
  };
  folder_.write("script.json", script);
  set("XR_RUNTIME_JSON", OPENXR_MANIFEST);
  set("XR_ENABLE_API_LAYERS",
      validation == Validation::on ? "XR_APILAYER_LUNARG_core_validation" : "");
  set("XR_CORE_VALIDATION_EXPORT_TYPE", "text");
  set("XR_CORE_VALIDATION_FILE_NAME", folder_ / "invalid");
  set("FOVEOLA_OPENXR_FOLDER", folder_.path());
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

std::vector<nlohmann::json> ScriptedHeadset::frames() const {
  std::vector<nlohmann::json> frames;
  for (const std::string& line : log_lines("frame")) {
    frames.push_back(nlohmann::json::parse(line));
  }
  return frames;
}

std::int64_t ScriptedHeadset::newest_frame() const {
  return nlohmann::json::parse(log_lines("frame").back()).at("frame");
}

std::string ScriptedHeadset::found_invalid() const {
  std::ifstream said(folder_ / "invalid");
  std::string invalid;
  for (std::string line; std::getline(said, line);) {
    // A newer one says, too, that it is there.
    invalid += line.find("[VALID_DEBUG ") == std::string::npos ? line + "\n" : "";
  }
  for (const std::string& refusal : log_lines("refusal")) {
    invalid += refusal + "\n";
  }
  return invalid;
}

std::filesystem::path ScriptedHeadset::picture_file(std::int64_t frame, int eye) const {
  return folder_ / (std::to_string(frame) + "-" + std::to_string(eye) + ".ppm");
}

}  // namespace foveola::test
