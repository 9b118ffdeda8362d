#include "signals/from_idl/idl_file.hpp"

#include <fstream>
#include <stdexcept>

#include "core/pattern.hpp"

namespace farrier::from_idl {
namespace {

const Pattern kTopic(R"(^// Topic ([0-9]+): ([a-z_/]+), version ([0-9]+)\.$)");
const Pattern kReaders(R"(^[^>]* -> ([^:]+): )");
const Pattern kStruct(R"(^struct ([A-Za-z0-9_]+) \{$)");
// Groups: 1 the key, 2 the type, 3 the name, 5 the count of an array, 7 the comment.
const Pattern kField(R"(^  (@key )?(unsigned short|unsigned long|unsigned long long|short|long|long long|octet|char|)"
                     R"(double|sequence<octet, [0-9]+>) ([A-Za-z0-9_]+)(\[([0-9]+)\])?;(  // (.*))?$)");

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
    if (number == 1) {
      const auto topic = kTopic.find(line);
      if (!topic) {
        refuse(path, number, "the first line names the topic: // Topic 3: joint/measurement, version 1.");
      }
      file.number = std::stoi((*topic)[1]);
      file.topic = (*topic)[2];
      file.version = (*topic)[3];
    } else if (line.starts_with("// ")) {
      file.comment.push_back(line.substr(3));
      if (const auto readers = kReaders.find(line); number == 2 && readers) {
        file.readers = (*readers)[1];
      }
    } else if (line == "@final") {
      final_struct = true;
    } else if (const auto opened = kStruct.find(line); file.structure.empty() && opened) {
      file.structure = (*opened)[1];
    } else if (const auto field = kField.find(line); field && !closed && !file.structure.empty()) {
      const bool key = !(*field)[1].empty();
      if (key && !file.fields.empty() && !file.fields.back().key) {
        refuse(path, number, "key fields come first");
      }
      file.fields.push_back({key, (*field)[2], (*field)[3], (*field)[5], comment + (*field)[7]});
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
