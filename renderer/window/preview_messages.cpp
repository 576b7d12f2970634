#include "renderer/window/preview_messages.h"

#include <utility>

namespace foveola {
namespace {

constexpr std::size_t most_messages = 4;

std::optional<Nanoseconds> end_of(Nanoseconds now, MessageStay stay) {
  switch (stay) {
    case MessageStay::long_enough:
      return now + std::chrono::seconds(15);
    case MessageStay::until_key:
      return std::nullopt;
    case MessageStay::briefly:
      break;
  }
  return now + std::chrono::seconds(4);
}

}  // namespace

void PreviewMessages::tell(Nanoseconds now, std::string text, MessageStay stay) {
  std::erase_if(messages_, [&](const Message& one) {
    return one.text == text || (one.end && *one.end <= now);
  });
  messages_.push_back({.text = std::move(text), .end = end_of(now, stay)});
  if (messages_.size() > most_messages) {
    messages_.erase(messages_.begin());
  }
}

void PreviewMessages::answer_key() {
  std::erase_if(messages_, [](const Message& one) { return !one.end; });
}

std::vector<std::string> PreviewMessages::lines(Nanoseconds now) const {
  std::vector<std::string> lines;
  for (const Message& one : messages_) {
    if (!one.end || now < *one.end) {
      lines.push_back(one.text);
    }
  }
  return lines;
}

}  // namespace foveola
