#include "tools/foxglove/viewer.hpp"

#include <utility>

namespace farrier::foxglove {

bool Viewer::take(std::string_view part, bool last) {
  if (text_.size() + part.size() > kLargestText) {
    return false;
  }
  text_ += part;
  if (last) {
    const Subscriptions::Outcome outcome = subscriptions_.take(text_);
    text_.clear();
    begun_.insert(begun_.end(), outcome.begun.begin(), outcome.begun.end());
    for (const std::string& problem : outcome.problems) {
      say(status(StatusLevel::kError, problem));
    }
  }
  return true;
}

void Viewer::say(std::string text) {
  owed_bytes_ += text.size();
  owed_.push_back({true, {text.begin(), text.end()}});
}

void Viewer::offer(const std::shared_ptr<const SharedMessage>& message) {
  if (!subscriptions_.id(message->topic)) {
    return;
  }
  waiting_bytes_ += message->cdr.size();
  waiting_.push_back(message);
  while (waiting_bytes_ > kMostWaitingBytes) {
    waiting_bytes_ -= waiting_.front()->cdr.size();
    waiting_.pop_front();
    ++dropped_;
  }
}

void Viewer::owe(const SharedMessage& message) {
  if (const auto id = subscriptions_.id(message.topic)) {
    Owed owed{false, {}};
    append_message(owed.bytes, *id, message.time_ns, message.cdr);
    owed_bytes_ += owed.bytes.size();
    owed_.push_back(std::move(owed));
  }
}

bool Viewer::pop(std::vector<std::uint8_t>& bytes) {
  if (owed_.empty() && dropped_ > told_ && waiting_bytes_ < kMostWaitingBytes / 2) {
    told_ = dropped_;  // once it reads again
    say(status(StatusLevel::kWarning, std::to_string(dropped_) + " messages were dropped: this viewer is slow"));
  }
  if (!owed_.empty()) {
    const Owed owed = std::move(owed_.front());
    owed_.pop_front();
    owed_bytes_ -= owed.bytes.size();
    bytes.insert(bytes.end(), owed.bytes.begin(), owed.bytes.end());
    sent_ += owed.is_text ? 0 : 1;
    return owed.is_text;
  }
  while (!waiting_.empty()) {
    const auto message = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= message->cdr.size();
    if (const auto id = subscriptions_.id(message->topic)) {  // it may have unsubscribed since
      append_message(bytes, *id, message->time_ns, message->cdr);
      ++sent_;
      break;
    }
  }
  return false;
}

}  // namespace farrier::foxglove
