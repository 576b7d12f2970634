// What tests read of a runtime's log while the runtime writes it.
#include "tests/openxr/scripted_headset.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

namespace foveola::test {
namespace {

TEST(OpenXrLogTest, ALineIsReadOnceItHasItsEnd) {
  const ScriptedHeadset headset;
  std::ofstream log(std::getenv("FOVEOLA_OPENXR_LOG"));
  log << "{\"kind\":\"frame\",\"number\":1}\n{\"kind\":\"frame\",\"num" << std::flush;
  EXPECT_EQ(headset.log("frame").size(), 1U);
  log << "ber\":2}\n" << std::flush;
  EXPECT_EQ(headset.log("frame").size(), 2U);
}

}  // namespace
}  // namespace foveola::test
