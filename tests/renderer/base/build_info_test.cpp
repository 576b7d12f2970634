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

TEST(ArithmeticName, IsAllThatLastBitsDependOnButTheSource) {
  const BuildInfo build{.version = "0.1.0",
                        .compiler = "GNU 12.2.0",
                        .build_type = "Release",
                        .ray_tracer = "Embree 3.13.5",
                        .instruction_set = "x86-64-v3",
                        .ray_instructions = "avx2"};
  EXPECT_EQ(arithmetic_name(build),
            "GNU 12.2.0, Release, Embree 3.13.5 with x86-64-v3 and rays by avx2");
  EXPECT_EQ(exact_name(build), "Foveola 0.1.0 (" + arithmetic_name(build).insert(34, ")"));
  BuildInfo other = build;
  other.version = "0.2.0";
  EXPECT_EQ(arithmetic_name(other), arithmetic_name(build));
}

}  // namespace
}  // namespace foveola
