// Tracks since when a page has been visible, and at which frame its picture is taken.
#pragma once

#include <optional>

#include "renderer/base/clock.h"

namespace foveola::study {

/// Must be told of every frame. All times are of one clock.
class PageWatch {
 public:
  /// The frame of a page at which its text has been measured and no longer moves.
  static constexpr int frame_to_keep = 3;

  /// Marks the frames from the next one on as another page, even if the old page is hidden and the
  /// new one shown between two frames.
  void turn_page();

  /// Call before each frame. stands: no other page is about to be shown. Returns the page's number,
  /// from 1, if its picture is to be taken at this frame; else empty.
  std::optional<int> picture_due(bool stands);

  /// Call after each frame, with the time at which it was shown.
  void was_shown(Nanoseconds time) { since_ = since_.value_or(time); }

  /// Returns whether the page was visible at `time`. Earlier key presses are not answers to it.
  bool was_seen_at(Nanoseconds time) const { return since_ && time >= *since_; }

 private:
  std::optional<Nanoseconds> since_;
  int frames_ = 0;  ///< number of frames of this page, until its picture was due
  bool has_picture_ = false;
  int pages_ = 0;  ///< number of pages whose picture was due
};

}  // namespace foveola::study
