// Since when the participant has seen a page, and when its picture is to be taken.
#pragma once

#include <optional>

#include "renderer/base/clock.h"

namespace foveola::study {

/// Has to be informed of every frame. All times are of one clock, whichever.
class PageWatch {
 public:
  /// The frame of a page by which its words have been measured and stand still.
  static constexpr int frame_to_keep = 3;

  /// The frames from the next one on show another page, even if one page follows the other between
  /// two looks at them.
  void turn_page();

  /// Before each frame. stands: nothing else is about to be shown. Returns the page's number, from
  /// 1, if this is the frame of which a picture is to be taken.
  std::optional<int> picture_due(bool stands);

  /// After each frame, with the time at which it was shown.
  void was_shown(Nanoseconds time) { since_ = since_.value_or(time); }

  /// What was pressed before the page could be seen was no answer to it.
  bool was_seen_at(Nanoseconds time) const { return since_ && time >= *since_; }

 private:
  std::optional<Nanoseconds> since_;
  int frames_ = 0;  ///< for which the page has been shown, until its picture was due
  bool has_picture_ = false;
  int pages_ = 0;  ///< how many pages had a picture due
};

}  // namespace foveola::study
