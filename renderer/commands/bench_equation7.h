// `foveola bench equation7`: how far the paper's equations are from what they stand for.
#pragma once

namespace CLI {
class App;
}

namespace foveola {

/// Adds `equation7` to the command `bench`; see add_bench_commands.
void add_bench_equation7(CLI::App& bench);

}  // namespace foveola
