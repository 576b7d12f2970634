// What is chosen before a person's session begins, and what its experimenter is told first.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

#include "renderer/window/key_times.h"
#include "study/console/console.h"
#include "study/person/devices/session_display.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

/// A random seed, positive as SQLite's integers.
std::uint64_t draw_seed();

/// The row of the design for the next person: the least used one from `first_row` on; empty: from
/// that of the study's first person, or 0.
int next_design_row(const Protocol& protocol, const StudyStore& store,
                    const std::optional<int>& first_row);

void say_if_keys_are_late(KeyTimeSource source, Console& console);

/// Warns of each other participant whose code differs in small and capital letters only: they are
/// easily taken for one another.
void say_if_code_is_alike(const std::string& participant, const StudyStore& store,
                          Console& console);

/// Returns once the experimenter has pressed Enter, whose screen will cover what was said so far.
/// Throws Error if `stop` is requested first.
void wait_for_confirmation(SessionDisplay& display, const Texts& texts, Console& console,
                           const std::stop_token& stop);

}  // namespace foveola::study
