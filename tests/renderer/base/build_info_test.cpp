#include "renderer/base/build_info.h"

#include "tests/matchers.h"

namespace foveola {
namespace {

// In virtual machines many are called "AMD EPYC".
TEST(MachineInfoTest, TellsProcessorsOfOneNameApart) {
  EXPECT_THAT(machine_info().processor, MatchesRegex(".+ \\(family [0-9]+, model [0-9]+\\)"));
}

}  // namespace
}  // namespace foveola
