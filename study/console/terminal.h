// The terminal of standard input and output as a screen, by ncurses.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "study/console/screen_layout.h"

namespace foveola::study {

/// Belongs to the thread that makes it, as ncurses does. During its lifetime Ctrl+S and Ctrl+Z do
/// nothing, so that a slip does not stop the session; Ctrl+C is a signal as usual. Painting never
/// waits for the terminal.
class Terminal {
 public:
  /// Returns whether standard input and output are a terminal with this process in its foreground.
  static bool is_there();

  Terminal();
  /// Restores the terminal if it accepts data within a second.
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// False if the terminal's kind cannot be painted on.
  bool is_open() const { return screen_ != nullptr; }

  /// Waits for a key. Returns false if the terminal is closed.
  bool wait(std::chrono::milliseconds longest) const;
  /// Returns the keys since the last call.
  std::vector<TypedKey> keys();
  /// Returns whether the size has changed since the last call.
  bool has_new_size();
  ScreenSize size() const { return size_; }

  /// Sends as much of the painted text as the terminal accepts. Returns whether all was sent; until
  /// then, do not paint anew.
  bool send();
  void paint(const std::vector<ScreenLine>& lines);

 private:
  class Modes;
  struct Screen;

  void collect_painted();

  std::unique_ptr<Modes> modes_;  ///< first: restored last
  std::unique_ptr<Screen> screen_;
  ScreenSize size_;
  bool is_pasting_ = false;
  std::string painted_;  ///< output of ncurses that the terminal has not accepted yet
};

}  // namespace foveola::study
