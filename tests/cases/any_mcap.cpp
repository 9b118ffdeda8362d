#include "tests/cases/any_mcap.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>

#include "core/ensure.hpp"
#include "mcap/compression.hpp"
#include "recording/recording_file.hpp"
#include "report/figures/recording_facts.hpp"
#include "signals/cdr.hpp"

namespace farrier::test {
namespace {

constexpr Tick kTicksPerSummary = 20;
constexpr std::size_t kSamplesPerChunk = 300;

using Bytes = std::vector<std::uint8_t>;

Bytes zstd_without_size(std::span<const std::uint8_t> data) {
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  FARRIER_ENSURE(ZSTD_isError(ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0)) == 0, "a known parameter");
  Bytes out(ZSTD_compressBound(data.size()));
  const std::size_t size = ZSTD_compress2(context, out.data(), out.size(), data.data(), data.size());
  ZSTD_freeCCtx(context);
  FARRIER_ENSURE(ZSTD_isError(size) == 0, "room enough");
  out.resize(size);
  return out;
}

/// A frame of literals alone, its block a stored one.
Bytes lz4_of_literals(std::span<const std::uint8_t> data) {
  mcap::ByteWriter out;
  out.number(std::uint32_t{0x184d2204});
  for (const int byte : {0x60, 0x70, 0x73}) {  // independent blocks of at most 4 MiB; checksum of the two
    out.number(static_cast<std::uint8_t>(byte));
  }
  if (!data.empty()) {
    out.number(static_cast<std::uint32_t>(data.size() | 0x80000000u));
    out.bytes(data);
  }
  out.number(std::uint32_t{0});
  return {out.view().begin(), out.view().end()};
}

Bytes packed(Packing packing, std::span<const std::uint8_t> data) {
  switch (packing) {
    case Packing::kNone:
      break;
    case Packing::kZstd: {
      mcap::Compressor compressor;
      const auto frame = compressor.compress(data);
      return {frame.begin(), frame.end()};
    }
    case Packing::kZstdWithoutSize:
      return zstd_without_size(data);
    case Packing::kZstdFrames: {
      Bytes both = zstd_without_size(data.first(data.size() / 2));
      const Bytes second = zstd_without_size(data.subspan(data.size() / 2));
      both.insert(both.end(), second.begin(), second.end());
      return both;
    }
    case Packing::kLz4:
      return lz4_of_literals(data);
  }
  return {data.begin(), data.end()};
}

const char* name_of(Packing packing) {
  return packing == Packing::kNone ? "" : packing == Packing::kLz4 ? "lz4" : "zstd";
}

template <class Signal>
PlacedSample placed(const Signal& signal, Tick tick, std::uint64_t log_time_ns) {
  PlacedSample sample{
      .topic = bus::TopicOf<Signal>::id, .sequence = static_cast<std::uint32_t>(tick), .log_time_ns = log_time_ns};
  signals::to_cdr(signal, sample.cdr);
  return sample;
}

}  // namespace

const robot::Robot& leg() {
  static const robot::Robot robot = robot::load_robot(FARRIER_ROBOTS "/fc1d.yaml").value();
  return robot;
}

std::vector<PlacedSample> bench_samples(const robot::Robot& robot, Tick ticks, std::uint64_t begin_ns) {
  std::vector<PlacedSample> samples;
  for (Tick tick = 0; tick < ticks; ++tick) {
    const std::uint64_t time_ns = begin_ns + static_cast<std::uint64_t>(tick) * 1'000'000;
    for (const robot::Joint& joint : robot.joints) {
      const double angle = 0.02 * static_cast<double>(tick);
      signals::JointMeasurement measurement{.joint = joint.number, .tick = tick};
      measurement.position_m_or_rad = joint.linkage.position(joint.home_angle_rad) + 0.001 * std::sin(angle);
      measurement.velocity_m_s_or_rad_s = 0.02 * std::cos(angle);
      measurement.force_N_or_Nm = 50.0 * std::sin(1.7 * angle);
      measurement.valve_current_A = 0.001 * std::cos(2.3 * angle);
      measurement.phase = signals::Phase::kStance;
      samples.push_back(placed(measurement, tick, time_ns));
      if (tick % kTicksPerSummary == 0) {
        signals::JointSummary summary;
        summary.joint = joint.number;
        summary.tick = tick;
        summary.ticks = static_cast<std::uint16_t>(kTicksPerSummary);
        samples.push_back(placed(summary, tick, time_ns));
      }
    }
  }
  return samples;
}

mcap::Channel channel_of(bus::TopicId topic, std::uint16_t id) {
  const bus::TopicSpec& spec = bus::spec(topic);
  return {.id = id,
          .schema_id = 0,
          .topic = spec.name,
          .message_encoding = "cdr",
          .metadata = {{recording::kVersionOfTopic, std::to_string(spec.version)}}};
}

AnyMcap::AnyMcap() {
  file_.bytes(mcap::kMagic);
  file_.record(mcap::Opcode::kHeader, [&] {
    file_.text("");
    file_.text("another writer");
  });
}

void AnyMcap::put(std::uint16_t channel, const PlacedSample& sample) {
  put(mcap::Message{.channel_id = channel,
                    .sequence = sample.sequence,
                    .log_time_ns = sample.log_time_ns,
                    .publish_time_ns = sample.log_time_ns,
                    .data = sample.cdr});
}

void AnyMcap::close_chunk(Packing packing, std::uint32_t crc) {
  const Bytes bytes = packed(packing, chunk_.view());
  file_.record(mcap::Opcode::kChunk, [&] {
    file_.number(std::uint64_t{0});
    file_.number(std::uint64_t{0});
    file_.number(static_cast<std::uint64_t>(chunk_.size()));
    file_.number(crc != 0 || chunk_.size() == 0 ? crc : mcap::crc32(chunk_.view()));
    file_.text(name_of(packing));
    file_.number(static_cast<std::uint64_t>(bytes.size()));
    file_.bytes(bytes);
  });
  chunk_.clear();
}

void AnyMcap::close_loose() {
  file_.bytes(chunk_.view());
  chunk_.clear();
}

void AnyMcap::put_metadata(const mcap::Metadata& metadata) { append(file_, metadata); }

void AnyMcap::put_with_hole(mcap::Opcode opcode, std::span<const std::uint8_t> head, std::uint64_t hole,
                            std::span<const std::uint8_t> tail) {
  file_.number(static_cast<std::uint8_t>(opcode));
  file_.number(static_cast<std::uint64_t>(head.size() + hole + tail.size()));
  file_.bytes(head);
  pieces_.push_back({{file_.view().begin(), file_.view().end()}, hole});
  file_.clear();
  file_.bytes(tail);
}

void AnyMcap::put_attachment(std::uint64_t size) {
  mcap::ByteWriter head, tail;
  head.number(std::uint64_t{1});
  head.number(std::uint64_t{1});
  head.text("camera.mp4");
  head.text("video/mp4");
  head.number(size);
  tail.number(std::uint32_t{0});
  put_with_hole(mcap::Opcode::kAttachment, head.view(), size, tail.view());
}

void AnyMcap::put_large_metadata(std::uint64_t size) {
  mcap::ByteWriter head;
  head.text("map of the building");
  put_with_hole(mcap::Opcode::kMetadata, head.view(), size, {});
}

void AnyMcap::put_large_message(std::uint16_t channel, std::uint64_t size) {
  mcap::ByteWriter head;
  head.number(channel);
  head.number(std::uint32_t{1});
  head.number(std::uint64_t{1});
  head.number(std::uint64_t{1});
  put_with_hole(mcap::Opcode::kMessage, head.view(), size, {});
}

void AnyMcap::put_large_chunk(std::uint64_t size) {
  mcap::ByteWriter head;
  head.number(std::uint64_t{0});
  head.number(std::uint64_t{0});
  head.number(size);
  head.number(std::uint32_t{0});
  head.text("");
  head.number(size);
  put_with_hole(mcap::Opcode::kChunk, head.view(), size, {});
}

void AnyMcap::put_data_end() {
  file_.record(mcap::Opcode::kDataEnd, [&] { file_.number(std::uint32_t{0}); });
}

void AnyMcap::put_footer() {
  file_.record(mcap::Opcode::kFooter, [&] {
    file_.number(std::uint64_t{0});
    file_.number(std::uint64_t{0});
    file_.number(std::uint32_t{0});
  });
  file_.bytes(mcap::kMagic);
}

void AnyMcap::save(const std::string& path) const {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  FARRIER_ENSURE(file >= 0, "a scratch file");
  const auto write_all = [&](std::span<const std::uint8_t> bytes) {
    FARRIER_ENSURE(::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()), "a disk with room");
  };
  for (const Piece& piece : pieces_) {
    write_all(piece.bytes);
    FARRIER_ENSURE(::lseek(file, static_cast<off_t>(piece.hole), SEEK_CUR) >= 0, "a file system with large files");
  }
  write_all(file_.view());
  ::close(file);
}

AnyMcap ordinary_file(const robot::Robot& robot, const std::vector<PlacedSample>& samples, Packing packing) {
  AnyMcap file;
  file.put_metadata({recording::kRunFacts, report::recording_facts(robot)});
  for (const bus::TopicSpec& topic : bus::topics()) {
    file.put(channel_of(topic.id, static_cast<std::uint16_t>(topic.id)));
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    file.put(static_cast<std::uint16_t>(samples[i].topic), samples[i]);
    if ((i + 1) % kSamplesPerChunk == 0) {
      file.close_chunk(packing);
    }
  }
  file.close_chunk(packing);
  return file;
}

}  // namespace farrier::test
