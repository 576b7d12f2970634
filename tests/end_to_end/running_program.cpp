#include "tests/end_to_end/running_program.h"

#include <array>
#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/waiting.h"

namespace foveola::test {

RunningProgram::RunningProgram(std::vector<std::string> arguments, const Environment& environment) {
  arguments.insert(arguments.begin(), FOVEOLA_PROGRAM);
  std::array<int, 2> to_it{};
  std::array<int, 2> from_it{};
  // Closed in every other child, which would keep this one's output from ending.
  if (::pipe2(to_it.data(), O_CLOEXEC) != 0 || ::pipe2(from_it.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipe");
  }
  process_ = ::fork();
  if (process_ == 0) {
    ::dup2(to_it[0], STDIN_FILENO);
    ::dup2(from_it[1], STDOUT_FILENO);
    ::dup2(from_it[1], STDERR_FILENO);
    become(arguments, environment);
  }
  ::close(to_it[0]);
  ::close(from_it[1]);
  input_ = to_it[1];
  output_ = from_it[0];
  reader_ = std::jthread([this] { read(); });
}

RunningProgram::~RunningProgram() {
  if (!has_ended()) {
    kill(SIGKILL);
    wait_for_end();
  }
  ::close(input_);
  if (reader_.joinable()) {  // it has ended, but nobody has waited for that
    reader_.join();
  }
  ::close(output_);
}

void RunningProgram::type_line(const std::string& line) const {
  const std::string typed = line + "\n";
  if (::write(input_, typed.data(), typed.size()) != static_cast<ssize_t>(typed.size())) {
    throw std::runtime_error("the program takes no input");
  }
}

std::string RunningProgram::wait_for(const std::string& words) {
  std::string line;
  const auto has_said = [&] {
    const std::scoped_lock lock(mutex_);
    const std::size_t found = said_.find(words, waited_for_);
    const std::size_t end = said_.find('\n', found);
    if (found == std::string::npos || end == std::string::npos) {
      return false;
    }
    const std::size_t begin = said_.rfind('\n', found) + 1;
    waited_for_ = end;
    line = said_.substr(begin, end - begin);
    return true;
  };
  try {
    wait_until("it says '" + words + "'", has_said);
  } catch (const std::runtime_error& in_vain) {
    throw std::runtime_error(std::string(in_vain.what()) + ", but said:\n" + said());
  }
  return line;
}

std::string RunningProgram::said() {
  const std::scoped_lock lock(mutex_);
  return said_;
}

void RunningProgram::kill(int signal) const {
  if (!status_) {  // otherwise its number may be another's by now
    ::kill(process_, signal);
  }
}

bool RunningProgram::has_ended() {
  int status = 0;
  if (!status_ && ::waitpid(process_, &status, WNOHANG) == process_) {
    status_ = status;
  }
  return status_.has_value();
}

int RunningProgram::wait_for_end() {
  if (!status_) {
    int status = 0;
    wait_until("the program's end", [&] { return ::waitpid(process_, &status, WNOHANG) != 0; });
    status_ = status;
  }
  if (reader_.joinable()) {
    reader_.join();  // what it said at last may still be in the pipe
  }
  return WIFEXITED(*status_) ? WEXITSTATUS(*status_) : 128 + WTERMSIG(*status_);
}

void RunningProgram::read() {
  std::array<char, 4096> bytes{};
  for (ssize_t count = ::read(output_, bytes.data(), bytes.size()); count > 0;
       count = ::read(output_, bytes.data(), bytes.size())) {
    const std::scoped_lock lock(mutex_);
    said_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace foveola::test
