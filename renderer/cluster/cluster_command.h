// `foveola cluster`.
#pragma once

#include <stop_token>

namespace CLI {
class App;
}

namespace foveola {

/// Adds the command, which runs plans of long work by Slurm, or on this machine, in shards.
void add_cluster(CLI::App& app, const std::stop_token& stop);

}  // namespace foveola
