// Where a simulated session's record goes while it runs: to the disk at once, or into memory until
// the session is over.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "study/record/study_store.h"

namespace foveola::study {

/// Takes what one session records, in this order; trial and attempt as StudyStore counts them.
class SessionSink {
 public:
  virtual ~SessionSink() = default;
  virtual void event(Nanoseconds time, const Event& event, const SessionState& before,
                     const SessionState& after) = 0;
  virtual void frames(std::size_t trial, int attempt, std::uint64_t first_frame,
                      std::vector<FrameRow> frames) = 0;
  virtual void gaze(std::size_t trial, int attempt, std::uint64_t first_sample,
                    std::vector<GazeSample> samples) = 0;
  virtual void film_hash(std::size_t trial, int attempt, const FilmHash& hash) = 0;
};

/// Every call is on the disk when it returns.
class DurableSink final : public SessionSink {
 public:
  /// session: its row in `store`, which must outlive this.
  DurableSink(StudyStore& store, std::int64_t session) : store_(store), session_(session) {}

  void event(Nanoseconds time, const Event& event, const SessionState& before,
             const SessionState& after) override;
  void frames(std::size_t trial, int attempt, std::uint64_t first_frame,
              std::vector<FrameRow> frames) override;
  void gaze(std::size_t trial, int attempt, std::uint64_t first_sample,
            std::vector<GazeSample> samples) override;
  void film_hash(std::size_t trial, int attempt, const FilmHash& hash) override;

 private:
  StudyStore& store_;
  std::int64_t session_;
};

/// Keeps a whole session: 72 bytes a frame and 48 a sample of the gaze, 30 MB for the longest
/// published session (15 trials that all time out) and some hundred kilobytes for a predicted one.
class SessionBuffer final : public SessionSink {
 public:
  void event(Nanoseconds time, const Event& event, const SessionState& before,
             const SessionState& after) override;
  void frames(std::size_t trial, int attempt, std::uint64_t first_frame,
              std::vector<FrameRow> frames) override;
  void gaze(std::size_t trial, int attempt, std::uint64_t first_sample,
            std::vector<GazeSample> samples) override;
  void film_hash(std::size_t trial, int attempt, const FilmHash& hash) override;

  /// All that was kept, as the record of a new session: on the disk whole when this returns, or not
  /// at all.
  void write(StudyStore& store, const SessionFacts& facts, const Plan& plan) const;

 private:
  std::vector<std::function<void(SessionSink&)>> kept_;
};

}  // namespace foveola::study
