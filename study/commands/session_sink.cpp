#include "study/commands/session_sink.h"

#include <utility>

namespace foveola::study {

void DurableSink::event(Nanoseconds time, const Event& event, const SessionState& before,
                        const SessionState& after) {
  store_.record_event(session_, time, event, before, after);
}

void DurableSink::frames(std::size_t trial, int attempt, std::uint64_t first_frame,
                         std::vector<FrameRow> frames) {
  store_.record_frames(session_, trial, attempt, first_frame, frames);
}

void DurableSink::gaze(std::size_t trial, int attempt, std::uint64_t first_sample,
                       std::vector<GazeSample> samples) {
  store_.record_gaze(session_, trial, attempt, first_sample, samples);
}

void DurableSink::film_hash(std::size_t trial, int attempt, const FilmHash& hash) {
  store_.record_film_hash(session_, trial, attempt, hash);
}

void SessionBuffer::event(Nanoseconds time, const Event& event, const SessionState& before,
                          const SessionState& after) {
  kept_.emplace_back([=](SessionSink& sink) { sink.event(time, event, before, after); });
}

void SessionBuffer::frames(std::size_t trial, int attempt, std::uint64_t first_frame,
                           std::vector<FrameRow> frames) {
  kept_.emplace_back([trial, attempt, first_frame, frames = std::move(frames)](SessionSink& sink) {
    sink.frames(trial, attempt, first_frame, frames);
  });
}

void SessionBuffer::gaze(std::size_t trial, int attempt, std::uint64_t first_sample,
                         std::vector<GazeSample> samples) {
  kept_.emplace_back([trial, attempt, first_sample, samples = std::move(samples)](
                         SessionSink& sink) { sink.gaze(trial, attempt, first_sample, samples); });
}

void SessionBuffer::film_hash(std::size_t trial, int attempt, const FilmHash& hash) {
  kept_.emplace_back([=](SessionSink& sink) { sink.film_hash(trial, attempt, hash); });
}

void SessionBuffer::write(StudyStore& store, const SessionFacts& facts, const Plan& plan) const {
  store.record_together([&] {
    DurableSink sink(store, store.begin_session(facts, plan));
    for (const auto& record : kept_) {
      record(sink);
    }
  });
}

}  // namespace foveola::study
