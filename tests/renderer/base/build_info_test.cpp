#include "renderer/base/build_info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola {
namespace {

// In virtual machines many are called "AMD EPYC".
TEST(MachineInfoTest, TellsProcessorsOfOneNameApart) {
  EXPECT_THAT(machine_info().processor,
              testing::MatchesRegex(".+ \\(family [0-9]+, model [0-9]+\\)"));
}

}  // namespace
}  // namespace foveola
