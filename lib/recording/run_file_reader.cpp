#include <algorithm>

#include "core/text.hpp"
#include "recording/recording_file.hpp"
#include "signals/cdr.hpp"

namespace farrier::recording {
namespace {

constexpr std::size_t kMostForeignTopics = 1000;  // that are named
constexpr std::size_t kForeignTopicsInAText = 8;

const bus::TopicSpec* topic_named(const std::string& name) {
  const auto topics = bus::topics();
  const auto found = std::ranges::find_if(topics, [&](const bus::TopicSpec& topic) { return topic.name == name; });
  return found == topics.end() ? nullptr : &*found;
}

/// Form of a topic's samples.
struct SampleForm {
  bool (*fits)(std::span<const std::uint8_t> cdr);
  std::size_t (*size)();
};

#define FARRIER_SAMPLE_FORM(Signal, file) {&signals::is_cdr<signals::Signal>, &signals::cdr_size<signals::Signal>},
constexpr SampleForm kSampleForms[] = {FARRIER_SIGNALS(FARRIER_SAMPLE_FORM)};
#undef FARRIER_SAMPLE_FORM

}  // namespace

Result<RunFileReader> RunFileReader::open(const std::string& path) {
  auto file = FARRIER_TRY(mcap::Reader::open(path));
  return RunFileReader(std::move(file), path);
}

bool RunFileReader::next(Sample& sample) {
  if (ended_ || read(sample)) {
    return !ended_;
  }
  end();
  return false;
}

void RunFileReader::end() {
  ended_ = true;
  file_.ask(nullptr);
  if (file_.ending() == kInterrupted) {
    ending_ = kInterrupted;
    return;
  }
  std::vector<std::string> parts;
  for (const auto& [topic, other] : others_) {
    if (other.samples > 0) {
      parts.push_back(topic + " is of version " + other.version + ", this farrier's is of version " +
                      std::to_string(topic_named(topic)->version) + ": " + counted(other.samples, "sample") +
                      " left out, read with the farrier that wrote it");
    }
  }
  if (damaged_ > 0) {
    parts.push_back(counted(damaged_, "sample") + (damaged_ == 1 ? " is" : " are") +
                    " damaged and left out: " + (damaged_ == 1 ? "" : "first ") + first_damaged_);
  }
  if (!file_.ending().empty()) {
    parts.push_back(file_.ending());
  }
  ending_ = join(parts, "; ");
}

RunFileReader::Meaning RunFileReader::meaning_of(std::uint16_t channel) {
  if (redefinitions_ != file_.redefinitions()) {
    redefinitions_ = file_.redefinitions();
    meanings_.clear();
  }
  auto [meaning, added] = meanings_.try_emplace(channel);
  if (added) {
    const mcap::Channel& described = file_.channels().at(channel);
    const bus::TopicSpec* const topic = topic_named(described.topic);
    const auto version = described.metadata.find(kVersionOfTopic);
    if (topic != nullptr && version != described.metadata.end() && described.message_encoding == "cdr") {
      meaning->second.topic = topic;
      if (version->second != std::to_string(topic->version)) {
        meaning->second.other = &others_[topic->name];
        meaning->second.other->version = version->second;
      }
    }
  }
  return meaning->second;
}

bool RunFileReader::read(Sample& sample) {
  mcap::Message message;
  while (file_.next(message)) {
    const auto [topic, other] = meaning_of(message.channel_id);
    if (topic == nullptr) {
      count_foreign(message.channel_id);
      continue;
    }
    sample = {topic->id,           message.sequence,
              message.log_time_ns, message.publish_time_ns,
              message.data,        timeline_.elapsed_ns(message.channel_id, message.log_time_ns)};
    if (other != nullptr) {
      ++other->samples;
    } else if (kSampleForms[static_cast<std::size_t>(topic->id)].fits(sample.cdr)) {
      ++samples_;
      return true;
    } else {
      leave_out(sample);
    }
  }
  return false;
}

void RunFileReader::leave_out(const Sample& sample) {
  if (damaged_++ == 0) {
    const std::size_t size = kSampleForms[static_cast<std::size_t>(sample.topic)].size();
    first_damaged_ = std::string(bus::spec(sample.topic).name) + " with sequence " + std::to_string(sample.sequence) +
                     (sample.cdr.size() < size
                          ? ", of " + std::to_string(sample.cdr.size()) + " bytes instead of " + std::to_string(size)
                          : ", whose bytes are not those of its type");
  }
}

void RunFileReader::count_foreign(std::uint16_t channel) {
  const mcap::Channel& described = file_.channels().at(channel);
  if (foreign_.size() >= kMostForeignTopics && !foreign_.contains(described.topic)) {
    ++foreign_["(further topics)"].messages;
    return;
  }
  ForeignTopic& topic = foreign_[described.topic];
  if (topic.messages++ == 0) {
    const auto schema = file_.schemas().find(described.schema_id);
    topic.type = schema == file_.schemas().end() ? "" : schema->second.name;
    topic.encoding = described.message_encoding;
  }
}

std::string RunFileReader::nothing_of_farrier() const {
  const auto is_own = [](const auto& channel) {
    return topic_named(channel.second.topic) != nullptr && channel.second.metadata.contains(kVersionOfTopic);
  };
  if (!ended_ || ending_ == kInterrupted || samples_ + damaged_ > 0 || !metadata(kRunFacts).empty() ||
      std::ranges::any_of(file_.channels(), is_own)) {
    return "";
  }
  std::string what;
  std::size_t named = 0;
  for (const auto& [name, topic] : foreign_) {
    if (++named > kForeignTopicsInAText) {
      what += ", and " + std::to_string(foreign_.size() - kForeignTopicsInAText) + " further topics";
      break;
    }
    what += (what.empty() ? "" : ", ") + counted(topic.messages, "message") + " of " + name + " (" +
            (topic.type.empty() ? "" : topic.type + ", ") + topic.encoding + ")";
  }
  return path_ + " has nothing of Farrier in it: it holds " + (what.empty() ? "no messages" : what) +
         (file_.library().empty() ? "" : ", written by '" + file_.library() + "'") +
         (ending_.empty() ? "" : "; " + ending_) + ": give a recording of farrier record";
}

mcap::Text RunFileReader::metadata(const std::string& name) const {
  for (const mcap::Metadata& one : file_.metadata()) {
    if (one.name == name) {
      return one.values;
    }
  }
  return {};
}

}  // namespace farrier::recording
