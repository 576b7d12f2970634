#include "tests/openxr/monado/monado_service.h"

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/end_to_end/program.h"
#include "tests/waiting.h"

namespace foveola::test {
namespace {

/// What Monado 25's remote driver reads, byte for byte.
struct RemoteController {
  XrPosef pose;
  XrVector3f linear_velocity;
  XrVector3f angular_velocity;
  std::array<float, 5> finger_curls;
  float trigger_value;
  float squeeze_value;
  float squeeze_force;
  XrVector2f thumbstick;
  float trackpad_force;
  XrVector2f trackpad;
  bool is_hand_tracked;
  bool is_active;
  bool system_click;
  bool system_touch;
  bool a_click;
  bool a_touch;
  bool b_click;
  bool b_touch;
  bool trigger_click;
  bool trigger_touch;
  bool thumbstick_click;
  bool thumbstick_touch;
  bool trackpad_touch;
  std::array<bool, 3> unused;
};
static_assert(sizeof(RemoteController) == 120);

struct RemoteEye {
  XrFovf fov;
  XrPosef pose;
  std::uint32_t unused;
};

struct RemoteWearer {
  std::array<char, 8> header;
  std::array<RemoteEye, 2> eyes;
  XrPosef head;
  bool are_eyes_valid;
  std::array<bool, 3> unused;
  RemoteController left;
  RemoteController right;
};
static_assert(sizeof(RemoteWearer) == 376);

RemoteController controller_of(const HeldController& held, float x) {
  RemoteController controller{};
  controller.pose = {{0.0F, 0.0F, 0.0F, 1.0F}, {x, 1.3F, -0.5F}};
  controller.is_active = true;
  controller.trigger_value = held.trigger ? 1.0F : 0.0F;
  controller.trigger_click = held.trigger;
  controller.a_click = held.a;
  controller.b_click = held.b;
  controller.thumbstick = held.thumbstick;
  return controller;
}

sockaddr_in on_this_machine(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

int unused_port() {
  const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = on_this_machine(0);
  socklen_t size = sizeof(address);
  const bool is_found = ::bind(probe, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
                        ::getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  ::close(probe);
  if (!is_found) {
    throw std::runtime_error("no port for Monado");
  }
  return ntohs(address.sin_port);
}

}  // namespace

MonadoService::MonadoService(Devices devices) : port_(unused_port()) {
  folder_.write(
      "config/monado/config_v0.json",
      fmt::format(R"({{"remote": {{"version": 0, "port": {}, "view_count": 2}}}})", port_));
  ::setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);
  ::setenv("XR_RUNTIME_JSON", "/usr/share/openxr/1/openxr_monado.json", 1);
  start(devices);
  wait_until("Monado's socket", [&] {
    if (::waitpid(process_, nullptr, WNOHANG) != 0) {
      throw std::runtime_error("Monado does not start: " + folder_.content()["said"]);
    }
    return std::filesystem::exists(folder_ / "monado_comp_ipc");
  });
  if (devices == Devices::remote) {
    connect();
  }
}

MonadoService::~MonadoService() {
  if (connection_ >= 0) {
    ::close(connection_);
  }
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

void MonadoService::start(Devices devices) {
  const std::filesystem::path said = folder_.write("said", "");
  Environment environment = {{"XDG_CONFIG_HOME", folder_ / "config"},
                             {"XRT_COMPOSITOR_NULL", "1"},  // without a screen of its own
                             {"XRT_NO_STDIN", "1"}};
  if (devices == Devices::remote) {
    environment.emplace_back("P_OVERRIDE_ACTIVE_CONFIG", "remote");
  } else {
    environment.emplace_back("SIMULATED_ENABLE", "1");
  }
  process_ = ::fork();
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // if a test dies, so does its runtime
    const int to_file = ::open(said.c_str(), O_WRONLY);
    ::dup2(to_file, STDOUT_FILENO);
    ::dup2(to_file, STDERR_FILENO);
    become({"monado-service"}, environment);
  }
}

void MonadoService::connect() {
  const sockaddr_in address = on_this_machine(port_);
  wait_until("Monado's remote driver", [&] {
    connection_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (::connect(connection_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) {
      return true;
    }
    ::close(connection_);
    return false;
  });
}

void MonadoService::play(const Wearer& wearer) const {
  RemoteWearer remote{};
  std::memcpy(remote.header.data(), "mndrmt3", remote.header.size());
  for (std::size_t eye = 0; eye < remote.eyes.size(); ++eye) {
    remote.eyes[eye] = {.fov = wearer.fovs[eye], .pose = wearer.eyes[eye], .unused = 0};
  }
  remote.head = wearer.head;
  remote.are_eyes_valid = true;
  remote.left = controller_of({}, -0.2F);
  remote.right = controller_of(wearer.right_hand, 0.2F);
  if (::send(connection_, &remote, sizeof(remote), MSG_NOSIGNAL) != sizeof(remote)) {
    throw std::runtime_error("Monado does not take what is played");
  }
}

}  // namespace foveola::test
