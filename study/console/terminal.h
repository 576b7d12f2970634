// The terminal as a screen (ncurses), of standard input and output.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "study/console/screen_layout.h"

namespace foveola::study {

/// Belongs to the thread that makes it, as ncurses does. While it lives, Ctrl+S and Ctrl+Z do
/// nothing: neither may hold up a session by a slip. Ctrl+C is a signal as ever. Nothing waits for
/// what is painted to be taken.
class Terminal {
 public:
  /// Whether standard input and output are a terminal, and this process is in front of it.
  static bool is_there();

  Terminal();
  /// The terminal is as it was before, if it takes anything within a second.
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// False if it is of a kind that cannot be painted on.
  bool is_open() const { return screen_ != nullptr; }

  /// Waits for a key. Returns false if the terminal is closed.
  bool wait(std::chrono::milliseconds longest) const;
  /// Those that were typed since the last call.
  std::vector<TypedKey> keys();
  /// Whether it has another size than at the last call.
  bool has_new_size();
  ScreenSize size() const { return size_; }

  /// Hands on what was painted, as far as it is taken. Returns whether all was: before, painting
  /// anew would only add to it.
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
  std::string painted_;  ///< what ncurses wrote and the terminal did not take yet
};

}  // namespace foveola::study
