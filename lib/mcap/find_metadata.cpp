#include <array>

#include "mcap/reader.hpp"
#include "mcap/record_bytes.hpp"

namespace farrier::mcap {
namespace {

constexpr std::uint64_t kHead = sizeof(std::uint8_t) + sizeof(std::uint64_t);
constexpr std::uint64_t kAskEvery = 1000;  // records

}  // namespace

std::optional<Metadata> find_metadata(const std::string& path, const std::string& name, const KeepOn& keep_on) {
  auto file = InputFile::open(path);
  if (!file) {
    return std::nullopt;
  }
  std::array<std::uint8_t, kHead> head{};
  file.value().skip(kMagic.size());
  for (std::uint64_t records = 0; file.value().read(head); ++records) {
    ByteReader in(head);
    const auto opcode = static_cast<Opcode>(in.number<std::uint8_t>());
    const auto length = in.number<std::uint64_t>();
    const double share = 1.0 - static_cast<double>(file.value().left()) / static_cast<double>(file.value().size());
    if (opcode == Opcode::kDataEnd || length > file.value().left() ||
        (keep_on && records % kAskEvery == 0 && !keep_on(share))) {
      break;
    }
    if (opcode != Opcode::kMetadata || length > Reader::kLargestRecord) {
      file.value().skip(length);
      continue;
    }
    std::vector<std::uint8_t> content(static_cast<std::size_t>(length));
    if (!file.value().read(content)) {
      break;
    }
    Metadata metadata = read_metadata(ByteReader(content));
    if (metadata.name == name) {
      return metadata;
    }
  }
  return std::nullopt;
}

}  // namespace farrier::mcap
