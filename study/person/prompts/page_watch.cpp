#include "study/person/prompts/page_watch.h"

namespace foveola::study {

void PageWatch::turn_page() {
  since_.reset();
  // Reset here, because within an attempt a page may come and go between two frames.
  frames_ = 0;
  has_picture_ = false;
}

std::optional<int> PageWatch::picture_due(bool stands) {
  // Additions to a page, such as a note, need no new picture.
  if (has_picture_) {
    return std::nullopt;
  }
  frames_ = stands && since_ ? frames_ + 1 : 0;
  has_picture_ = frames_ == frame_to_keep;
  return has_picture_ ? std::optional(++pages_) : std::nullopt;
}

}  // namespace foveola::study
