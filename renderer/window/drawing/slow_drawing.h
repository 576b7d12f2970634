// A window's timing: its timing patch, and warnings of slow drawing.
#pragma once

#include <string>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/profiles.h"
#include "renderer/window/drawing/view_renderer.h"

namespace foveola {

/// The reason why frames miss their refresh, however little is traced.
struct SlowDrawing {
  Nanoseconds drawing{0};   ///< mean time to draw a frame
  Nanoseconds interval{0};  ///< the display's refresh interval
  IVec2 framebuffer{0};     ///< the window's size in pixels
  std::string graphics;     ///< the graphics card's and its driver's own names
};

/// One line, without its end: the cause, the consequence and the remedy.
std::string slow_drawing_line(const SlowDrawing& slow);

/// A short form for the window itself.
std::string slow_drawing_note(const SlowDrawing& slow);

/// The patch's part of the window, clipped by the window's edges.
WindowPart part_of(const TimingPatch& patch, const IVec2& framebuffer);

}  // namespace foveola
