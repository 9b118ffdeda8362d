#pragma once

#include <string>

#include "core/keep_on.hpp"
#include "core/result.hpp"

namespace farrier::playback {

// A recording as a folder: <topic>.csv of every topic that has samples, with "_" for "/", and metadata.json. Columns are
// index (the sample's place in the recording), log_time_ns, publish_time_ns and the fields of idl/, those of arrays as
// name[0], name[1], ...; numbers in their shortest form that reads back exactly. There and back nothing changes but the
// bytes behind the end of a text.

/// Number of converted samples, and why the conversion ended early: empty if the recording was read to its end.
struct Converted {
  std::uint64_t samples = 0;
  std::string ending;
  std::string refusal;  ///< reason if the disk did not take all; then nothing is left of the output
};

/// Refuses a file that is no recording, a folder that cannot be written or has files of another recording. If `keep_on`
/// returns false it also refuses, and leaves no file in the folder.
Result<Converted> to_csv(const std::string& recording, const std::string& folder, const KeepOn& keep_on = {});

/// Refuses, with file, line and column, text that to_csv does not write. If `keep_on` returns false it also refuses,
/// and leaves no recording.
Result<Converted> from_csv(const std::string& folder, const std::string& recording, const KeepOn& keep_on = {});

}  // namespace farrier::playback
