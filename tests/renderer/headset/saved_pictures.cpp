#include "tests/renderer/headset/saved_pictures.h"

#include <sstream>

#include "renderer/base/files.h"
#include "tests/waiting.h"

namespace foveola::test {

std::string all_frames() {
  constexpr int more_than_a_test_has = 2000;
  std::string numbers = "[0";
  for (int i = 1; i < more_than_a_test_has; ++i) {
    numbers += "," + std::to_string(i);
  }
  return numbers + "]";
}

std::int64_t newest_frame(const ScriptedHeadset& headset) {
  return headset.newest_log("frame").at("frame");
}

void wait_for_frame(const ScriptedHeadset& headset, std::int64_t number) {
  wait_until("a frame", [&] { return newest_frame(headset) >= number; });
}

RgbImage saved_picture(const ScriptedHeadset& headset, std::int64_t frame, int eye) {
  const std::string pixmap = read_file(headset.picture_file(frame, eye));
  std::istringstream header(pixmap);
  std::string kind;
  int width = 0;
  int height = 0;
  int most = 0;
  header >> kind >> width >> height >> most;
  header.get();
  const auto* bytes = reinterpret_cast<const unsigned char*>(pixmap.data() + header.tellg());
  RgbImage picture(width, height);
  for (Rgb& pixel : picture.pixels) {
    pixel = Rgb(bytes[0], bytes[1], bytes[2]) / 255.0F;
    bytes += 3;
  }
  return picture;
}

}  // namespace foveola::test
