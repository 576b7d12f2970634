// One session on a page, for the experimenter who has just run it.
#pragma once

#include <filesystem>
#include <string>

namespace foveola::study {

/// The programs that recorded it; trials with their times, ratings and what is to be said about
/// them; frames, gaze, validations, reactions and notes. As plain text. Throws Error if the file at
/// `path` is no study, or there is no such participant.
std::string session_summary(const std::filesystem::path& path, const std::string& participant);

}  // namespace foveola::study
