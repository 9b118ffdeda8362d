#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "recording/recording_file.hpp"
#include "signals/cdr.hpp"
#include "signals/sequence_of.hpp"
#include "tests/contract/random_signal.hpp"

namespace farrier::test {

/// Writes a recording of random samples, `each` of every topic; calls see(signal), which may change it, before each is
/// written.
template <class See>
void write_random_recording(const std::string& path, const mcap::Text& facts, const recording::TopicCounts& lost, int each,
                            See&& see) {
  auto file = recording::RunFileWriter::create(path, facts);
  ASSERT_TRUE(file.ok()) << file.error().message;
  std::mt19937_64 random(3);
  std::vector<std::uint8_t> cdr;
  std::uint64_t time_ns = 1'700'000'000'000'000'000;
  const auto write = [&]<class Signal>(const Signal&) {
    for (int i = 0; i < each; ++i) {
      auto signal = contract::random_signal<Signal>(random);
      see(signal);
      signals::to_cdr(signal, cdr);
      file.value().write({.topic = bus::TopicOf<Signal>::id,
                          .sequence = static_cast<std::uint32_t>(signals::sequence_of(signal).value_or(0)),
                          .log_time_ns = ++time_ns,
                          .publish_time_ns = time_ns - 7,
                          .cdr = cdr});
    }
  };
#define FARRIER_WRITE(Signal, file) write(signals::Signal{});
  FARRIER_SIGNALS(FARRIER_WRITE)
#undef FARRIER_WRITE
  ASSERT_TRUE(file.value().finish(lost).ok());
}

}  // namespace farrier::test
