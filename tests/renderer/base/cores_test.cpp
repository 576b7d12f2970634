#include "renderer/base/cores.h"

#include <gtest/gtest.h>
#include <sched.h>

#include "tests/temporary_folder.h"

namespace foveola {
namespace {

// The files' form: https://docs.kernel.org/admin-guide/cgroup-v2.html, "$MAX $PERIOD" in
// microseconds.
TEST(Cores, AQuotaOfTimeIsWorthCores) {
  const test::TemporaryFolder mount;
  EXPECT_FALSE(cgroup_cores(mount.path(), ""));
  mount.write("cpu.max", "max 100000\n");
  mount.write("user/cpu.max", "400000 100000\n");
  mount.write("user/job/cpu.max", "75000 50000\n");
  mount.write("user/job/step/cpu.max", "max 100000\n");
  EXPECT_FALSE(cgroup_cores(mount.path(), "other"));
  EXPECT_EQ(cgroup_cores(mount.path(), "user"), 4.0);
  EXPECT_EQ(cgroup_cores(mount.path(), "user/job/step"), 1.5);
}

TEST(Cores, AreThoseOfTheAffinity) {
  cpu_set_t before;
  ASSERT_EQ(::sched_getaffinity(0, sizeof before, &before), 0);
  int first = 0;
  while (!CPU_ISSET(first, &before)) {
    ++first;
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(usable_cores(), 1);
  ASSERT_EQ(::sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_LE(usable_cores(), CPU_COUNT(&before));
}

}  // namespace
}  // namespace foveola
