#include "study/console/terminal.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cwchar>
#include <optional>

#include <fcntl.h>
#include <locale.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "renderer/base/text/utf8.h"
#include "study/console/line_writer.h"

#define NCURSES_NOMACROS
#define NCURSES_WIDECHAR 1
#include <curses.h>

namespace foveola::study {
namespace {

constexpr short warning_colours = 1;
/// Marks pasted text, in terminals that support it: xterm's mode 2004, "bracketed paste".
constexpr const char* mark_pasted = "\x1b[?2004h";
constexpr const char* mark_pasted_no_more = "\x1b[?2004l";
constexpr int paste_begins = KEY_MAX + 1;
constexpr int paste_ends = KEY_MAX + 2;
constexpr int escape_delay_ms = 25;  ///< longer than the intervals of a key sequence after Escape

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// Buffers the output of ncurses, because writing to a terminal may wait forever.
struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() {
    // More than any screen needs: it is emptied after each.
    constexpr int size = 1 << 20;
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
      ::fcntl(ends[1], F_SETPIPE_SZ, size);
    }
  }
  ~Pipe() {
    ::close(ends[0]);
    ::close(ends[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
};

ScreenSize size_of_terminal() {
  winsize found{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &found) != 0 || found.ws_col == 0 || found.ws_row == 0) {
    return {};
  }
  return {.columns = found.ws_col, .rows = found.ws_row};
}

std::optional<TypedKey> key_of(int kind, wint_t code) {
  using Kind = TypedKey::Kind;
  constexpr wint_t escape = 27;
  constexpr wint_t backspace = 8;
  constexpr wint_t erase = 127;
  constexpr wint_t first_printable = 32;
  if (kind == KEY_CODE_YES) {
    return code == KEY_BACKSPACE ? std::optional(TypedKey{Kind::erase, 0})
           : code == KEY_ENTER   ? std::optional(TypedKey{Kind::enter, 0})
                                 : std::nullopt;
  }
  switch (code) {
    case escape:
      return TypedKey{Kind::escape, 0};
    case L'\n':
    case L'\r':
      return TypedKey{Kind::enter, 0};
    case backspace:
    case erase:
      return TypedKey{Kind::erase, 0};
    default:
      return code >= first_printable
                 ? std::optional(TypedKey{Kind::character, static_cast<char32_t>(code)})
                 : std::nullopt;
  }
}

attr_t attributes_of(LineLook look) {
  switch (look) {
    case LineLook::title:
      return A_REVERSE;
    case LineLook::warning:
      return A_BOLD | static_cast<attr_t>(COLOR_PAIR(warning_colours));
    case LineLook::typed:
      return A_BOLD;
    case LineLook::plain:
      break;
  }
  return A_NORMAL;
}

/// Invalid UTF-8 becomes a question mark per byte. Only wide characters tell ncurses 6.5 that this
/// thread's locale is UTF-8.
std::wstring wide(const std::string& text) {
  std::wstring characters;
  std::mbstate_t state{};
  for (std::size_t at = 0; at < text.size();) {
    wchar_t character = L'?';
    const std::size_t length = std::mbrtowc(&character, &text[at], text.size() - at, &state);
    const bool is_one = length >= 1 && length <= text.size() - at;
    characters += is_one ? character : L'?';
    at += is_one ? length : 1;
    state = is_one ? state : std::mbstate_t{};
  }
  return characters;
}

}  // namespace

/// The terminal and signal settings that a session changes.
class Terminal::Modes {
 public:
  Modes() : locale_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    // For this thread only: text is UTF-8, whatever the environment.
    former_locale_ = locale_ != nullptr ? ::uselocale(locale_) : nullptr;
    // ncurses's handlers would run in other threads. The size is polled instead.
    former_size_handler_ = std::signal(SIGWINCH, SIG_IGN);
    former_stop_handler_ = std::signal(SIGTSTP, SIG_IGN);
    ::tcgetattr(STDIN_FILENO, &former_);
    termios changed = former_;
    changed.c_cc[VSUSP] = _POSIX_VDISABLE;
    changed.c_cc[VMIN] = 1;
    changed.c_cc[VTIME] = 0;
    changed.c_iflag &= ~static_cast<tcflag_t>(IXON);
    changed.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &changed);
  }
  ~Modes() {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &former_);
    std::signal(SIGTSTP, former_stop_handler_);
    std::signal(SIGWINCH, former_size_handler_);
    if (locale_ != nullptr) {
      ::uselocale(former_locale_);
      ::freelocale(locale_);
    }
  }
  Modes(const Modes&) = delete;
  Modes& operator=(const Modes&) = delete;

 private:
  locale_t locale_;
  locale_t former_locale_ = nullptr;
  sighandler_t former_size_handler_ = SIG_DFL;
  sighandler_t former_stop_handler_ = SIG_DFL;
  termios former_{};
};

struct Terminal::Screen {
  Pipe painted;
  File output{::fdopen(::dup(painted.ends[1]), "w")};
  File input{::fdopen(::dup(STDIN_FILENO), "r")};
  SCREEN* screen = ::newterm(nullptr, output.get(), input.get());

  Screen() = default;
  ~Screen() {
    if (screen != nullptr) {
      ::delscreen(screen);
    }
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// "dumb", as in many editors, cannot position the cursor.
  bool can_be_painted_on() const { return screen != nullptr && ::tigetstr("cup") != nullptr; }
};

bool Terminal::is_there() {
  // A background process that changes a terminal's modes is stopped.
  return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1 &&
         ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
}

Terminal::Terminal()
    : modes_(std::make_unique<Modes>()),
      screen_(std::make_unique<Screen>()),
      size_(size_of_terminal()) {
  if (!screen_->can_be_painted_on()) {
    screen_.reset();
    return;
  }
  ::resizeterm(static_cast<int>(size_.rows), static_cast<int>(size_.columns));
  ::nodelay(stdscr, true);
  ::keypad(stdscr, true);
  ::set_escdelay(escape_delay_ms);
  ::define_key("\x1b[200~", paste_begins);
  ::define_key("\x1b[201~", paste_ends);
  painted_ = mark_pasted;
  ::curs_set(0);
  if (::has_colors()) {
    ::start_color();
    ::use_default_colors();
    ::init_pair(warning_colours, COLOR_RED, -1);
  }
}

Terminal::~Terminal() {
  constexpr std::chrono::milliseconds moment(50);
  constexpr std::chrono::seconds patience(1);
  if (screen_ == nullptr) {
    return;
  }
  ::endwin();
  collect_painted();
  painted_ += mark_pasted_no_more;
  for (const auto end = std::chrono::steady_clock::now() + patience;
       !painted_.empty() && std::chrono::steady_clock::now() < end;) {
    painted_.erase(0, write_taken(STDOUT_FILENO, painted_, moment));
  }
}

bool Terminal::wait(std::chrono::milliseconds longest) const {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return ::poll(&input, 1, static_cast<int>(longest.count())) <= 0 ||
         (input.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
}

std::vector<TypedKey> Terminal::keys() {
  std::vector<TypedKey> typed;
  wint_t code = 0;
  for (int kind = ::get_wch(&code); kind != ERR; kind = ::get_wch(&code)) {
    if (kind == KEY_CODE_YES && (code == paste_begins || code == paste_ends)) {
      is_pasting_ = code == paste_begins;
    } else if (std::optional<TypedKey> key = key_of(kind, code)) {
      key->is_pasted = is_pasting_;
      typed.push_back(*key);
    }
  }
  return typed;
}

bool Terminal::has_new_size() {
  const ScreenSize size = size_of_terminal();
  if (size.columns == size_.columns && size.rows == size_.rows) {
    return false;
  }
  size_ = size;
  ::resizeterm(static_cast<int>(size.rows), static_cast<int>(size.columns));
  ::clearok(stdscr, true);
  return true;
}

bool Terminal::send() {
  constexpr std::chrono::milliseconds at_once(0);
  std::size_t taken = 0;
  do {
    taken = write_taken(STDOUT_FILENO, painted_, at_once);
    painted_.erase(0, taken);
  } while (taken > 0 && !painted_.empty());
  return painted_.empty();
}

void Terminal::collect_painted() {
  std::array<char, 4096> bytes{};
  for (ssize_t count = 1; count > 0;) {
    count = ::read(screen_->painted.ends[0], bytes.data(), bytes.size());
    painted_.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
}

void Terminal::paint(const std::vector<ScreenLine>& lines) {
  ::werase(stdscr);
  for (std::size_t row = 0; row < lines.size(); ++row) {
    const attr_t attributes = attributes_of(lines[row].look);
    ::wattr_set(stdscr, attributes & ~static_cast<attr_t>(A_COLOR),
                static_cast<short>(PAIR_NUMBER(attributes)), nullptr);
    ::wmove(stdscr, static_cast<int>(row), 0);
    std::string text = lines[row].text;
    if (lines[row].look == LineLook::title) {
      text.resize(std::max(text.size(), size_.columns), ' ');
    }
    ::waddnwstr(stdscr, wide(printable(text)).c_str(), -1);
  }
  ::wrefresh(stdscr);
  collect_painted();
  send();
}

}  // namespace foveola::study
