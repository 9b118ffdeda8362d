#include "tools/playback/csv_files.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "recording/recording_file.hpp"
#include "signals/cdr.hpp"
#include "signals/sequence_of.hpp"
#include "tools/playback/csv_reader.hpp"
#include "tools/playback/csv_row.hpp"
#include "tools/playback/new_files.hpp"

namespace farrier::playback {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFirstColumns[] = {"index", "log_time_ns", "publish_time_ns"};
constexpr const char* kMetadata = "metadata.json";
constexpr std::uint64_t kAskEvery = 10'000;  // samples

/// Functions of a topic's file that depend on its signal type.
struct Format {
  std::string (*header)();
  bool (*append)(std::string& row, std::span<const std::uint8_t> cdr);
  /// Number of the cell that cannot be read; none: all could.
  std::optional<std::size_t> (*parse)(const std::vector<std::string>& cells, std::vector<std::uint8_t>& cdr,
                                      std::uint32_t& sequence);
};

template <class Signal>
std::string header_of() {
  std::string row;
  for (const char* name : kFirstColumns) {
    row += (row.empty() ? "" : ",") + std::string(name);
  }
  Signal signal;
  visit_all_columns(signal, [&](const std::string& name, const auto&) { row += ',' + name; });
  return row;
}

template <class Signal>
bool append_signal(std::string& row, std::span<const std::uint8_t> cdr) {
  Signal signal;
  if (!signals::from_cdr(cdr, signal)) {
    return false;
  }
  visit_all_columns(signal, [&](const std::string&, const auto& field) {
    row += ',';
    append_cell(row, field);
  });
  return true;
}

template <class Signal>
std::optional<std::size_t> parse_signal(const std::vector<std::string>& cells, std::vector<std::uint8_t>& cdr,
                                        std::uint32_t& sequence) {
  Signal signal;
  std::size_t place = std::size(kFirstColumns);
  std::optional<std::size_t> wrong;
  visit_all_columns(signal, [&](const std::string&, auto& field) {
    if (!wrong && (place >= cells.size() || !parse_cell(cells[place], field))) {
      wrong = place;
    }
    ++place;
  });
  if (!wrong && place != cells.size()) {
    wrong = place;
  }
  signals::to_cdr(signal, cdr);
  sequence = static_cast<std::uint32_t>(signals::sequence_of(signal).value_or(0));
  return wrong;
}

#define FARRIER_FORMAT(Signal, file) \
  Format{&header_of<signals::Signal>, &append_signal<signals::Signal>, &parse_signal<signals::Signal>},
constexpr std::array<Format, bus::kTopicCount> kFormats{FARRIER_SIGNALS(FARRIER_FORMAT)};
#undef FARRIER_FORMAT

const Format& format_of(bus::TopicId topic) { return kFormats[static_cast<std::size_t>(topic)]; }

std::string path_of(const std::string& folder, const bus::TopicSpec& topic) {
  std::string name = topic.name;
  std::ranges::replace(name, '/', '_');
  return folder + "/" + name + ".csv";
}

/// One topic's file on the way back: its next sample.
class TopicFile {
 public:
  TopicFile(const std::string& path, bus::TopicId topic) : path_(path), topic_(topic), reader_(path) {}

  bool exists() const { return reader_.opened(); }
  Result<Done> begin() {
    if (!reader_.next(cells_)) {
      return Error{path_ + ":1: no header"};
    }
    std::string header;
    for (const std::string& cell : cells_) {
      header += (header.empty() ? "" : ",") + cell;
    }
    if (header != format_of(topic_).header()) {
      return Error{path_ + ":1: its columns are not those of this version: " + format_of(topic_).header()};
    }
    return advance();
  }
  Result<Done> advance() {
    present_ = reader_.next(cells_);
    if (!present_) {
      return Done{};
    }
    std::uint64_t* const numbers[] = {&index_, &sample_.log_time_ns, &sample_.publish_time_ns};
    for (std::size_t i = 0; i < std::size(numbers); ++i) {
      if (i >= cells_.size() || !parse_cell(cells_[i], *numbers[i])) {
        return wrong(i);
      }
    }
    if (const auto place = format_of(topic_).parse(cells_, cdr_, sample_.sequence)) {
      return wrong(*place);
    }
    sample_.topic = topic_;
    sample_.cdr = cdr_;
    return Done{};
  }
  bool present() const noexcept { return present_; }
  std::uint64_t index() const noexcept { return index_; }
  const recording::Sample& sample() const noexcept { return sample_; }
  std::uint64_t position() { return reader_.position(); }
  std::uint64_t size() const { return fs::file_size(path_); }

 private:
  Error wrong(std::size_t place) const {
    return {path_ + ":" + std::to_string(reader_.line()) + ": column " + std::to_string(place + 1) +
            (place < cells_.size() ? ": '" + cells_[place] + "' is not what stands there" : " is missing") +
            "; give a folder that farrier convert has written"};
  }

  std::string path_;
  bus::TopicId topic_;
  CsvReader reader_;
  std::vector<std::string> cells_;
  std::vector<std::uint8_t> cdr_;
  recording::Sample sample_;
  std::uint64_t index_ = 0;
  bool present_ = false;
};

std::string unwritten(const std::string& folder) {
  return "cannot write all of " + folder + ": " + std::strerror(errno);
}

/// Content of metadata.json.
struct Metadata {
  mcap::Text facts;
  recording::TopicCounts lost{};
};

Result<Metadata> read_metadata(const std::string& path) {
  std::ifstream text(path);
  const Error wrong{path + " is missing or not what farrier convert writes: give a folder that it has written"};
  try {
    const json all = json::parse(text);
    Metadata metadata{.facts = all.value(recording::kRunFacts, mcap::Text{})};
    const mcap::Text losses = all.value(recording::kLosses, mcap::Text{});
    for (const bus::TopicSpec& topic : bus::topics()) {
      const auto found = losses.find(topic.name);
      if (found != losses.end() && !parse_cell(found->second, metadata.lost[static_cast<std::size_t>(topic.id)])) {
        return wrong;
      }
    }
    return metadata;
  } catch (const json::exception&) {
    return wrong;
  }
}

}  // namespace

Result<Converted> to_csv(const std::string& recording, const std::string& folder, const KeepOn& keep_on) {
  auto reader = FARRIER_TRY(recording::RunFileReader::open(recording));
  std::error_code refused;
  fs::create_directories(folder, refused);
  if (refused || !fs::is_empty(folder, refused)) {
    return Error{folder + (refused ? ": " + refused.message() : " is not empty: give a folder of its own")};
  }
  NewFiles made(folder);
  reader.ask(keep_on);
  std::array<std::ofstream, bus::kTopicCount> files;
  Converted converted;
  std::string row;
  for (recording::Sample sample; reader.next(sample); ++converted.samples) {
    std::ofstream& file = files[static_cast<std::size_t>(sample.topic)];
    if (!file.is_open()) {
      file.open(path_of(folder, bus::spec(sample.topic)));
      file << format_of(sample.topic).header() << '\n';
    }
    row = std::to_string(converted.samples) + ',' + std::to_string(sample.log_time_ns) + ',' +
          std::to_string(sample.publish_time_ns);
    format_of(sample.topic).append(row, sample.cdr);
    if (!(file << row << '\n')) {
      converted.refusal = unwritten(folder);
      return converted;
    }
  }
  converted.ending = reader.ending();
  if (converted.ending == recording::kInterrupted) {
    return Error{converted.ending};
  }
  if (std::string nothing = reader.nothing_of_farrier(); !nothing.empty()) {
    return Error{std::move(nothing)};
  }
  json metadata;
  for (const mcap::Metadata& one : reader.file().metadata()) {
    metadata[one.name] = one.values;
  }
  std::ofstream facts(folder + "/" + kMetadata);
  facts << metadata.dump(2, ' ', false, json::error_handler_t::replace) << '\n';
  facts.flush();
  for (std::ofstream& file : files) {
    file.flush();
    if (!file || !facts) {
      converted.refusal = unwritten(folder);
      return converted;
    }
  }
  made.keep();
  return converted;
}

Result<Converted> from_csv(const std::string& folder, const std::string& recording, const KeepOn& keep_on) {
  const auto metadata = FARRIER_TRY(read_metadata(folder + "/" + kMetadata));
  std::vector<std::unique_ptr<TopicFile>> files;
  for (const bus::TopicSpec& topic : bus::topics()) {
    auto file = std::make_unique<TopicFile>(path_of(folder, topic), topic.id);
    if (file->exists()) {
      FARRIER_TRY(file->begin());
      files.push_back(std::move(file));
    }
  }
  const auto share = [&files] {
    std::uint64_t read = 0, all = 0;
    for (const auto& file : files) {
      read += file->position();
      all += file->size();
    }
    return static_cast<double>(read) / static_cast<double>(all);
  };
  auto writer = FARRIER_TRY(recording::RunFileWriter::create(recording, metadata.facts));
  Converted converted;
  for (;; ++converted.samples) {
    TopicFile* first = nullptr;
    for (const auto& file : files) {
      first = file->present() && (first == nullptr || file->index() < first->index()) ? file.get() : first;
    }
    if (first == nullptr || writer.failed()) {
      break;
    }
    writer.write(first->sample());
    auto advanced = first->advance();
    if (advanced && keep_on && converted.samples % kAskEvery == 0 && !keep_on(share())) {
      advanced = Error{recording::kInterrupted};
    }
    if (!advanced) {
      std::remove(recording::path_while_written(recording).c_str());
      return advanced.error();
    }
  }
  if (auto finished = writer.finish(metadata.lost); !finished) {
    std::remove(recording::path_while_written(recording).c_str());
    converted.refusal = finished.error().message;
  }
  return converted;
}

}  // namespace farrier::playback
