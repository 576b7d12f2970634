#include "study/console/screen_layout.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/text/utf8.h"
#include "study/console/console_command.h"

namespace foveola::study {
namespace {

/// Returns "1:02:03".
std::string clock_time(Nanoseconds time) {
  constexpr std::int64_t minute = 60;
  const std::int64_t all_s = std::chrono::duration_cast<std::chrono::seconds>(time).count();
  return fmt::format("{}:{:02}:{:02}", all_s / minute / minute, all_s / minute % minute,
                     all_s % minute);
}

std::string clipped(const std::string& text, std::size_t columns) {
  return text.substr(0, bytes_of_first(text, columns));
}

std::size_t less_one(std::size_t count) { return count - std::min<std::size_t>(count, 1); }

/// The beginning of a text, and its style.
struct TextStart {
  std::string first;  ///< further lines are indented by as many spaces
  LineLook look = LineLook::plain;
};

void append_wrapped(std::vector<ScreenLine>& lines, std::string_view text, const TextStart& start,
                    std::size_t columns) {
  const std::size_t indent = start.first.size();
  std::string begin = start.first;
  for (const std::string& line : wrapped(text, columns - std::min(columns, indent))) {
    lines.push_back({begin + line, start.look});
    begin = std::string(indent, ' ');
  }
}

ScreenLine title_line(const SessionStatus& status, std::size_t columns) {
  const std::string left = fmt::format(" Foveola, participant {}", status.participant);
  const std::string right = clock_time(status.time) + " ";
  const std::size_t used = count_characters(left) + right.size();
  const std::size_t gap = std::max<std::size_t>(1, columns - std::min(used, columns));
  return {left + std::string(gap, ' ') + right, LineLook::title};
}

std::vector<ScreenLine> status_lines(const SessionStatus& status, std::size_t columns) {
  std::vector<ScreenLine> lines;
  const auto add = [&](const char* name, const std::string& text, LineLook look = LineLook::plain) {
    append_wrapped(lines, text, {.first = fmt::format(" {:<11}", name), .look = look}, columns);
  };
  add("now", status.now);
  add("then", status.then);
  add("next key", status.next_key);
  add("frames", words_for(status.frames));
  add("gaze", words_for(status.gaze),
      status.gaze.eye == "tracked" ? LineLook::plain : LineLook::warning);
  add("last mark", status.last_mark.empty() ? "none yet" : status.last_mark);
  return lines;
}

/// Returns the warnings after an empty line; empty if there are none.
std::vector<ScreenLine> warning_lines(const SessionStatus& status, std::size_t columns) {
  std::vector<ScreenLine> lines;
  for (const StatusWarning& warning : status.warnings) {
    append_wrapped(lines, warning.text, {.first = " ! ", .look = LineLook::warning}, columns);
  }
  if (!lines.empty()) {
    lines.insert(lines.begin(), ScreenLine{});
  }
  return lines;
}

/// Returns the commands, or the typed text: as many lines as needed, at most `rows`.
std::vector<ScreenLine> last_lines(const ScreenContent& content, const ScreenSize& size) {
  std::vector<ScreenLine> lines;
  if (content.typed.empty()) {
    lines.push_back({" " + console_words(), LineLook::title});
  } else {
    append_wrapped(lines, content.typed + "_   (Enter does it, Escape clears it)",
                   {.first = " > ", .look = LineLook::typed}, size.columns);
  }
  // The end has the cursor.
  const std::size_t hidden = lines.size() - std::min(lines.size(), size.rows);
  lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(hidden));
  return lines;
}

/// Returns the newest messages for these rows; the first row stays empty.
std::vector<ScreenLine> said_lines(std::span<const std::string> said, const ScreenSize& room) {
  std::vector<ScreenLine> lines;
  for (const std::string& text : said) {
    append_wrapped(lines, text, {.first = " "}, room.columns);
  }
  const std::size_t shown = std::min(lines.size(), less_one(room.rows));
  lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(shown));
  lines.insert(lines.begin(), ScreenLine{});
  lines.resize(room.rows);
  return lines;
}

}  // namespace

std::vector<ScreenLine> lay_out_screen(const ScreenContent& content, const ScreenSize& size) {
  std::vector<ScreenLine> lines = {title_line(content.status, size.columns)};
  const auto append = [&](const std::vector<ScreenLine>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  append(status_lines(content.status, size.columns));
  append(warning_lines(content.status, size.columns));
  const std::vector<ScreenLine> last = last_lines(content, size);
  const std::size_t above_last = size.rows - last.size();
  append(said_lines(content.said, {.columns = size.columns,
                                   .rows = above_last - std::min(above_last, lines.size())}));
  lines.resize(above_last);
  append(last);
  for (ScreenLine& line : lines) {
    line.text = clipped(line.text, size.columns);
  }
  return lines;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  while (!text.empty() && columns > 0) {
    std::size_t end = bytes_of_first(text, columns);
    std::size_t next = end;
    if (end < text.size()) {
      const std::size_t space = text.rfind(' ', end);
      if (space != std::string_view::npos && space > 0) {
        end = space;
        next = space + 1;
      }
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(next);
  }
  return lines;
}

std::optional<EnteredLine> CommandEntry::follow(const TypedKey& key) {
  switch (key.kind) {
    case TypedKey::Kind::character:
      append_character(line_.text, key.character);
      break;
    case TypedKey::Kind::enter:
      if (!key.is_pasted) {
        return std::exchange(line_, {});
      }
      append_character(line_.text, U' ');
      break;
    case TypedKey::Kind::erase:
      erase_last_character(line_.text);
      break;
    case TypedKey::Kind::escape:
      line_.text.clear();
      break;
  }
  line_.is_pasted = !line_.text.empty() && (line_.is_pasted || key.is_pasted);
  return std::nullopt;
}

}  // namespace foveola::study
