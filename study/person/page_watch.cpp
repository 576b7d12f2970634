#include "study/person/page_watch.h"

namespace foveola::study {

void PageWatch::turn_page() {
  since_.reset();
  // Here, for within an attempt a page may come and be shown between two looks at it.
  frames_ = 0;
}

std::optional<int> PageWatch::picture_due(bool stands) {
  if (frames_ > frame_to_keep) {
    return std::nullopt;
  }
  frames_ = stands && since_ ? frames_ + 1 : 0;
  if (frames_ != frame_to_keep) {
    return std::nullopt;
  }
  ++frames_;  // What comes without another page, such as a note, needs no other picture.
  return ++pages_;
}

}  // namespace foveola::study
