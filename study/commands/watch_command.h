// foveola study watch.
#pragma once

#include <stop_token>

#include <CLI/CLI.hpp>

namespace foveola::study {

void add_watch(CLI::App& study, const std::stop_token& stop);

}  // namespace foveola::study
