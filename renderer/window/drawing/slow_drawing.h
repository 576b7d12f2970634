// A window's timing: the patch that is measured, and drawing that is too slow.
#pragma once

#include <string>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/profiles.h"
#include "renderer/window/drawing/view_renderer.h"

namespace foveola {

/// Why frames cannot be in time, whatever is traced in them.
struct SlowDrawing {
  Nanoseconds drawing{0};   ///< time to draw a frame, on average
  Nanoseconds interval{0};  ///< between the display's refreshes
  IVec2 framebuffer{0};     ///< the window's size in pixels
  std::string graphics;     ///< the graphics card and its driver, in their own words
};

/// One line, without its end: what is slow, what follows and what helps.
std::string slow_drawing_line(const SlowDrawing& slow);

/// The same in short, for the window itself.
std::string slow_drawing_note(const SlowDrawing& slow);

/// The window's part that it fills, cut off by the window's edges.
WindowPart part_of(const TimingPatch& patch, const IVec2& framebuffer);

}  // namespace foveola
