// An attempt's frames on their way to the disk, in chunks: writing one must not delay the next.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/preview/preview.h"
#include "study/record/study_store.h"

namespace foveola::study {

class FrameLog {
 public:
  FrameLog(StudyStore& store, std::int64_t session, std::size_t trial, int attempt)
      : store_(store), session_(session), trial_(trial), attempt_(attempt) {}

  void add(const FrameReport& report);
  /// Writes what is not yet on the disk.
  void flush();

 private:
  static constexpr std::size_t frames_per_chunk = 4096;

  StudyStore& store_;
  std::int64_t session_;
  std::size_t trial_;
  int attempt_;
  std::uint64_t flushed_ = 0;
  std::vector<FrameRow> rows_;
};

}  // namespace foveola::study
