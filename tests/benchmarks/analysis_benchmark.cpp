// How long a study's analysis takes from its records to the report and all files, by the number of
// participants, each with 15 trials; and the most memory that the program has held by then.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "analysis/monte_carlo/expected_study.h"
#include "analysis/publication/analyze_study.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void analyse(benchmark::State& state) {
  const test::TemporaryFolder folder;
  const study::StudyRecords records =
      draw_study(example_study(), static_cast<std::size_t>(state.range(0)), 1);
  for ([[maybe_unused]] const auto& run : state) {
    benchmark::DoNotOptimize(analyze_records(records, {}, folder / "out").summary);
  }
  state.counters["trials"] = static_cast<double>(records.trials.size());
  state.counters["peak_memory_mb"] = peak_memory_mb();
}
BENCHMARK(analyse)->Unit(benchmark::kSecond)->Arg(16)->Arg(1000)->Arg(66'667);

}  // namespace
}  // namespace foveola::analysis
