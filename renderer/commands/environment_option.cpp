#include "renderer/commands/environment_option.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "renderer/base/error.h"
#include "renderer/commands/arguments.h"

namespace foveola {

void replace_environment(const std::string& text, SceneSource& source) {
  constexpr std::string_view sky = "sky:";
  source.environment_radiance.reset();
  source.environment_file.reset();
  source.sky.reset();
  source.suns.clear();
  source.environment_strength = 1.0;
  source.environment_rotation_rad = 0.0;
  if (text.starts_with(sky)) {
    source.sky = parse_sky("--environment", text.substr(sky.size()));
  } else if (std::count(text.begin(), text.end(), ',') == 2) {
    const Rgb radiance = parse_vec3("--environment", text);
    if (!glm::all(glm::greaterThanEqual(radiance, Rgb(0.0F)))) {
      throw UsageError("--environment", "radiance must not be negative",
                       "give r,g,b of 0 or more, for instance 1,1,1");
    }
    source.environment_radiance = radiance;
  } else if (!std::filesystem::exists(text)) {
    throw Error(text, "does not exist",
                "give --environment r,g,b, sky:AZIMUTH,ELEVATION or a lat-long image file");
  } else {
    source.environment_file = text;
  }
}

}  // namespace foveola
