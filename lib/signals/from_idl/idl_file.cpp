#include "signals/from_idl/idl_file.hpp"

#include <fstream>
#include <regex>
#include <stdexcept>

namespace farrier::from_idl {
namespace {

const std::regex kTopic(R"(// Topic (\d+): ([a-z_/]+), version (\d+)\.)");
const std::regex kReaders(R"([^>]* -> ([^:]+): .*)");
const std::regex kStruct(R"(struct (\w+) \{)");
const std::regex kField(R"(  (@key )?((?:unsigned )?(?:short|long long|long)|octet|char|double|sequence<octet, \d+>) )"
                        R"((\w+)(?:\[(\d+)\])?;(?:  // (.*))?)");

[[noreturn]] void refuse(const std::filesystem::path& path, std::size_t line, const std::string& remedy) {
  throw std::runtime_error(path.string() + ':' + std::to_string(line) + ": " + remedy);
}

}  // namespace

std::string Field::declaration() const {
  return (key ? "@key " : "") + type + ' ' + name + (count.empty() ? "" : '[' + count + ']') + ';';
}

std::string IdlFile::key() const {
  std::string names;
  for (const Field& field : fields) {
    names += field.key ? (names.empty() ? "" : ", ") + field.name : "";
  }
  return names;
}

IdlFile read(const std::filesystem::path& path) {
  IdlFile file;
  file.path = path;
  std::ifstream in(path);
  std::string line;
  std::string comment;
  std::size_t number = 0;
  bool final_struct = false;
  bool closed = false;
  while (std::getline(in, line)) {
    ++number;
    std::smatch found;
    if (number == 1) {
      if (!std::regex_match(line, found, kTopic)) {
        refuse(path, number, "the first line names the topic: // Topic 3: joint/measurement, version 1.");
      }
      file.number = std::stoi(found[1]);
      file.topic = found[2];
      file.version = found[3];
    } else if (line.starts_with("// ")) {
      file.comment.push_back(line.substr(3));
      if (number == 2 && std::regex_match(line, found, kReaders)) {
        file.readers = found[1];
      }
    } else if (line == "@final") {
      final_struct = true;
    } else if (file.structure.empty() && std::regex_match(line, found, kStruct)) {
      file.structure = found[1];
    } else if (!closed && !file.structure.empty() && std::regex_match(line, found, kField)) {
      if (found[1].matched && !file.fields.empty() && !file.fields.back().key) {
        refuse(path, number, "key fields come first");
      }
      file.fields.push_back({found[1].matched, found[2], found[3], found[4], comment + found[5].str()});
      comment.clear();
    } else if (!file.structure.empty() && line.starts_with("  // ")) {
      comment += line.substr(5) + ' ';
    } else if (line == "};") {
      closed = true;
    } else if (!line.empty() && line != "module wire {") {
      refuse(path, number, "'" + line + "' is not in the subset of IDL that idl/README.md describes");
    }
  }
  if (file.readers.empty()) {
    refuse(path, 2, "the second line names writers and readers: // joint_node -> estimator_service: the measurement.");
  }
  if (!final_struct || file.fields.empty() || !file.fields.front().key) {
    refuse(path, number, "a topic is a @final struct whose first field is its @key");
  }
  return file;
}

}  // namespace farrier::from_idl
