// bench sampling: what a view sample costs before it is traced, and the film after.
#pragma once

namespace CLI {
class App;
}

namespace foveola {

/// Adds `sampling` to the command `bench`; see add_bench_commands.
void add_bench_sampling(CLI::App& bench);

}  // namespace foveola
