// `foveola bench sampling`: what drawing view samples and adding them to the film cost.
#pragma once

namespace CLI {
class App;
}

namespace foveola {

/// Adds `sampling` to the command `bench`; see add_bench_commands.
void add_bench_sampling(CLI::App& bench);

}  // namespace foveola
