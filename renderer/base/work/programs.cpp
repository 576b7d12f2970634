#include "renderer/base/work/programs.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string_view>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace fs = std::filesystem;

namespace foveola {
namespace {

void require(bool succeeded, int error_number, const char* what) {
  if (!succeeded) {
    throw std::system_error(error_number, std::generic_category(), what);
  }
}

/// An unnamed file in memory. Unlike a pipe it blocks neither side; unlike a file it leaves nothing
/// behind.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content = "")
      : descriptor_(::memfd_create("stream", MFD_CLOEXEC)) {
    require(descriptor_ >= 0, errno, "memfd_create");
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      require(count >= 0, errno, "write");
      content.remove_prefix(static_cast<std::size_t>(count));
    }
    ::lseek(descriptor_, 0, SEEK_SET);
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  std::string content() const {
    std::string content(static_cast<std::size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
    std::size_t known = 0;
    while (known < content.size()) {
      const ssize_t count = ::pread(descriptor_, content.data() + known, content.size() - known,
                                    static_cast<off_t>(known));
      require(count > 0, errno, "pread");
      known += static_cast<std::size_t>(count);
    }
    return content;
  }

 private:
  int descriptor_;
};

/// The new program's three streams.
class Streams {
 public:
  Streams(const MemoryFile& input, const MemoryFile& output, const MemoryFile& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors.descriptor(), STDERR_FILENO);
  }
  ~Streams() { posix_spawn_file_actions_destroy(&actions_); }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// The new program's blocked signals.
class Attributes {
 public:
  explicit Attributes(OnInterrupt on_interrupt) {
    posix_spawnattr_init(&attributes_);
    if (on_interrupt == OnInterrupt::ends) {
      sigset_t none;
      ::sigemptyset(&none);
      posix_spawnattr_setsigmask(&attributes_, &none);
      posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
    }
  }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

/// The dynamic linker's data of the program or library that contains this code.
using LoadedObject = std::unique_ptr<void, int (*)(void*)>;

LoadedObject this_object() {
  Dl_info here{};
  void* library = nullptr;
  if (::dladdr(reinterpret_cast<const void*>(&own_program), &here) != 0) {
    library = ::dlopen(here.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  }
  return {library != nullptr ? library : ::dlopen(nullptr, RTLD_LAZY), &::dlclose};
}

/// The folders of this object's libraries and modules.
std::vector<fs::path> library_folders() {
  const LoadedObject object = this_object();
  Dl_serinfo needed{};
  if (::dlinfo(object.get(), RTLD_DI_SERINFOSIZE, &needed) != 0) {
    return {};
  }
  // Whole elements of the type, so that it is aligned; the folders' names follow it.
  std::vector<Dl_serinfo> memory(1 + needed.dls_size / sizeof(Dl_serinfo), needed);
  if (::dlinfo(object.get(), RTLD_DI_SERINFO, memory.data()) != 0) {
    return {};
  }
  const Dl_serpath* folder = memory.front().dls_serpath;
  std::vector<fs::path> folders;
  for (unsigned i = 0; i < needed.dls_cnt; ++i) {
    folders.emplace_back(folder[i].dls_name);
  }
  return folders;
}

pid_t start(const Command& command, const Streams& streams) {
  std::vector<std::string> words = command.words;
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  const Attributes attributes(command.on_interrupt);
  pid_t process = 0;
  const int failure = ::posix_spawnp(&process, arguments.front(), streams.get(), attributes.get(),
                                     arguments.data(), environ);
  require(failure == 0, failure, arguments.front());
  return process;
}

}  // namespace

fs::path own_program() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown);
}

std::optional<fs::path> installation_prefix() {
  for (const fs::path& folder : library_folders()) {
    const fs::path prefix = (folder / FOVEOLA_PREFIX_FROM_MODULES).lexically_normal();
    if (folder.filename() == "foveola" && fs::is_directory(prefix / FOVEOLA_RESOURCES_IN_PREFIX)) {
      return prefix;
    }
  }
  return std::nullopt;
}

ProgramEnd run_to_end(const Command& command) {
  const MemoryFile input(command.input);
  const MemoryFile output;
  const MemoryFile errors;
  const pid_t process = start(command, Streams(input, output, errors));
  const std::stop_callback end_it(command.stop, [process] { ::kill(process, SIGTERM); });
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    require(errno == EINTR, errno, "waitpid");
  }
  return {.status = status, .output = output.content(), .errors = errors.content()};
}

std::string failure_named(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("signal {} ({})", WTERMSIG(status), ::sigdescr_np(WTERMSIG(status)));
  }
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

void keep_freed_memory() {
#if defined(__GLIBC__)
  // All from one heap, which never shrinks: other threads' heaps cannot hold large blocks.
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace foveola
