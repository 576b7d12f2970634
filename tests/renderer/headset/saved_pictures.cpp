#include "tests/renderer/headset/saved_pictures.h"

#include <sstream>

#include "renderer/base/files/files.h"
#include "tests/waiting.h"

namespace foveola::test {

void wait_for_frame(const ScriptedHeadset& headset, std::int64_t number) {
  wait_until("a frame", [&] { return headset.newest_frame() >= number; });
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
