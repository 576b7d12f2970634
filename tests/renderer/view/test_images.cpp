#include "tests/renderer/view/test_images.h"

#include <cmath>
#include <string>

#include "renderer/image/image_file.h"

namespace foveola::test {
namespace {

/// Whether `name` was found in `text` and replaced by `path`.
bool replace(std::string& text, const std::string& name, const std::filesystem::path& path) {
  const std::size_t place = text.find(name);
  if (place == std::string::npos) {
    return false;
  }
  text.replace(place, name.size(), path.string());
  return true;
}

}  // namespace

void write_weights(const std::filesystem::path& path, int width, int height,
                   const std::function<double(double x, double y)>& weight) {
  RgbImage image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = Rgb(static_cast<float>(weight((x + 0.5) / width, (y + 0.5) / height)));
    }
  }
  write_image(path, image, 0.0);
}

std::string with_images(std::string method, const std::filesystem::path& folder) {
  if (replace(method, "MAP", folder / "map.exr")) {
    write_weights(folder / "map.exr", 24, 18, [](double x, double y) {
      const double spot = std::exp(-8.0 * (x - 0.4) * (x - 0.4) - 6.0 * (y - 0.55) * (y - 0.55));
      return x > 0.8 && y < 0.3 ? 0.0 : spot + 0.1 * x;
    });
  }
  if (replace(method, "MASK", folder / "mask.exr")) {
    write_weights(folder / "mask.exr", 40, 20, [](double x, double y) {
      return x > 0.6 && x < 0.7 && y > 0.4 ? 0.0 : 1.5 + std::sin(9.0 * x) + y;
    });
  }
  return method;
}

}  // namespace foveola::test
