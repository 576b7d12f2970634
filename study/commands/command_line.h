// What the command lines of `study` have in common.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace foveola::study {

inline constexpr int most_participants = 100'000;

/// A subcommand of `study` or `bench` with its example, without these: "check demo".
CLI::App* add_command(CLI::App& parent, const std::string& name, const std::string& purpose,
                      const std::string& example);

// Options that several commands have; what they write to must outlive the command's parsing.
void add_protocol(CLI::App* command, std::string& protocol);
void add_database(CLI::App* command, std::string& database);  ///< the file of a study that exists
void add_participants_and_seed(CLI::App* command, int& participants, std::uint64_t& seed);
void add_threads(CLI::App* command, int& threads);
void add_json(CLI::App* command, bool& json);

/// Throws Error unless a copy of the study can be put into the folder. Warns of a folder on the
/// study's own disk.
void require_backup_target(const std::filesystem::path& folder, const std::filesystem::path& study);

}  // namespace foveola::study
