#include "renderer/window/presenter.h"

namespace foveola {

std::future<RgbImage> picture_of(ShownFrame& frame) {
  frame.picture = std::make_shared<std::promise<RgbImage>>();
  return frame.picture->get_future();
}

}  // namespace foveola
