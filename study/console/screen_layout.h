// The experimenter's screen as lines of text: what stands where, at any size of the terminal.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/console/session_status.h"

namespace foveola::study {

enum class LineLook { plain, title, warning, typed };

struct ScreenLine {
  std::string text;
  LineLook look = LineLook::plain;
};

struct ScreenContent {
  SessionStatus status;
  std::span<const std::string> said;  ///< what happened and was answered, the newest last
  std::string typed;                  ///< the command that is being typed
};

struct ScreenSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// As many lines as the screen has rows, none with more characters than it has columns: the title,
/// how the session stands, its warnings, the newest of what was said, and last the commands, or
/// what is typed in their place. Where rows are few, what was said goes first.
std::vector<ScreenLine> screen_lines(const ScreenContent& content, const ScreenSize& size);

/// A text in lines of at most `columns` characters, broken at spaces where there are any.
std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

}  // namespace foveola::study
