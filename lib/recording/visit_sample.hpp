#pragma once

#include "recording/recording_file.hpp"
#include "signals/cdr.hpp"

namespace farrier::recording {

/// Calls use(signal) with what a sample's bytes say. False, and no call, for bytes that are no sample of its topic.
template <class Use>
bool visit_sample(const Sample& sample, Use&& use) {
  const auto decoded = [&]<class Signal>(Signal signal) {
    if (!signals::from_cdr(sample.cdr, signal)) {
      return false;
    }
    use(signal);
    return true;
  };
  switch (sample.topic) {
#define FARRIER_VISIT_SAMPLE(Signal, file) \
  case bus::TopicId::k##Signal: return decoded(signals::Signal{});
    FARRIER_SIGNALS(FARRIER_VISIT_SAMPLE)
#undef FARRIER_VISIT_SAMPLE
  }
  return false;
}

}  // namespace farrier::recording
