// What the program loads before it knows what it is asked for.

#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

// OpenImageIO brings some 250 libraries along. With this variable set, the dynamic linker lists
// what it would load in place of starting the program (ld.so(8)).
TEST(StartUp, LoadsNoImageReader) {
  const ProgramResult result = run_foveola({"--help"}, {{"LD_TRACE_LOADED_OBJECTS", "1"}});
  EXPECT_THAT(result.output, AllOf(HasSubstr("libembree"), Not(HasSubstr("OpenImageIO"))));
}

}  // namespace
}  // namespace foveola::test
