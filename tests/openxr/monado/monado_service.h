// Monado, the free runtime of OpenXR, with a headset that is simulated, for as long as a test needs
// it.
#pragma once

#include <array>

#include <openxr/openxr.h>
#include <sys/types.h>

#include "tests/temporary_folder.h"

namespace foveola::test {

/// What somebody holds in one hand: a Valve Index controller.
struct HeldController {
  bool trigger = false;
  bool a = false;
  bool b = false;
  XrVector2f thumbstick{0.0F, 0.0F};  ///< to the right and up, each in [-1, 1]
};

/// Somebody who wears Monado's remotely driven headset.
struct Wearer {
  XrPosef head{{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 1.6F, 0.0F}};  ///< in the room, above its floor
  std::array<XrPosef, 2> eyes{XrPosef{{0.0F, 0.0F, 0.0F, 1.0F}, {-0.032F, 0.0F, 0.0F}},
                              XrPosef{{0.0F, 0.0F, 0.0F, 1.0F}, {0.032F, 0.0F, 0.0F}}};  ///< in it
  std::array<XrFovf, 2> fovs{XrFovf{-0.74F, 0.74F, 0.74F, -0.74F},
                             XrFovf{-0.74F, 0.74F, 0.74F, -0.74F}};
  HeldController right_hand;
};

class MonadoService {
 public:
  enum class Devices {
    simulated,  ///< a headset that sways by itself, and nothing else
    remote      ///< a headset and two controllers that do what `play` says
  };

  /// OpenXR's loader loads it in this process, and in those that it starts, from then on. Throws
  /// std::runtime_error, with what it said, if it does not start.
  explicit MonadoService(Devices devices);
  ~MonadoService();
  MonadoService(const MonadoService&) = delete;
  MonadoService& operator=(const MonadoService&) = delete;

  /// From now on. Only of remote devices.
  void play(const Wearer& wearer) const;

 private:
  void start(Devices devices);
  void connect();

  TemporaryFolder folder_;  ///< of its socket, its settings and what it says
  int port_ = 0;            ///< at which it takes what is played
  pid_t process_ = -1;
  int connection_ = -1;
};

}  // namespace foveola::test
