#include "signals/from_idl/write_cpp.hpp"

#include <algorithm>
#include <map>
#include <ostream>
#include <stdexcept>

#include "core/pattern.hpp"

namespace farrier::from_idl {
namespace {

constexpr const char* kWritten = "// Written by from_idl from the files of idl/. Change those.\n#pragma once\n\n";

/// The file of whose fields this one has a copy: "Its fields are those of joint_model_estimate.idl." Null for none.
const IdlFile* copied(const Files& files, const IdlFile& file) {
  for (const IdlFile& other : files) {
    for (const std::string& line : file.comment) {
      if (line.find("Its fields are those of " + other.path.filename().string()) != std::string::npos) {
        return &other;
      }
    }
  }
  return nullptr;
}

/// Name of the enum of signals/words.hpp whose values the field has: "Phase" for "enum Phase: whose gains acted".
/// Empty for any other field.
std::string enum_of(const Field& field) {
  static const Pattern kEnum("^enum ([A-Za-z]+):");
  const auto found = kEnum.find(field.comment);
  return found && field.type == "octet" ? (*found)[1] : "";
}

/// The type of this field's numbers. A `long long` called tick or *_tick is a Tick.
std::string number_type(const Field& field) {
  static const std::map<std::string, std::string> kTypes{{"char", "char"},
                                                         {"double", "double"},
                                                         {"octet", "std::uint8_t"},
                                                         {"short", "std::int16_t"},
                                                         {"unsigned short", "std::uint16_t"},
                                                         {"long", "std::int32_t"},
                                                         {"long long", "std::int64_t"},
                                                         {"unsigned long", "std::uint32_t"},
                                                         {"unsigned long long", "std::uint64_t"}};
  const bool tick = field.name == "tick" || field.name.ends_with("_tick");
  return field.type == "long long" && tick ? "Tick" : kTypes.at(field.type);
}

std::string member(const Field& field) {
  if (field.type.starts_with("sequence")) {
    const std::size_t comma = field.type.find(", ");
    return "Octets<" + field.type.substr(comma + 2, field.type.size() - comma - 3) + "> " + field.name + ';';
  }
  if (const std::string type = enum_of(field); !type.empty()) {
    return type + ' ' + field.name + "{};";
  }
  const std::string type = number_type(field);
  if (!field.count.empty()) {
    return "std::array<" + type + ", " + field.count + "> " + field.name + "{};";
  }
  const std::string other_joint = field.name == "joint" && !field.key ? "kNoJoint" : "0";
  return type + ' ' + field.name + " = " + (type == "Tick" ? "kNoTick" : other_joint) + ';';
}

}  // namespace

Files read_all(std::span<char*> paths) {
  Files files;
  for (const char* path : paths) {
    files.push_back(read(path));
  }
  std::ranges::sort(files, {}, &IdlFile::number);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].number != static_cast<int>(i)) {
      throw std::runtime_error(files[i].path.string() + ":1: topics are numbered without a gap; the next is " +
                               std::to_string(i));
    }
  }
  for (const IdlFile& file : files) {
    const IdlFile* original = copied(files, file);
    if (original != nullptr &&
        !std::ranges::equal(original->fields, file.fields, {}, &Field::declaration, &Field::declaration)) {
      throw std::runtime_error(file.path.string() + ": its fields are not those of " + original->path.string());
    }
  }
  return files;
}

void write_structs(const Files& files, std::ostream& out) {
  out << kWritten
      << "#include <array>\n#include <cstdint>\n\n#include \"core/time.hpp\"\n#include \"signals/octets.hpp\"\n"
         "#include \"signals/words.hpp\"\n\nnamespace farrier::signals {\n";
  for (const IdlFile& file : files) {
    out << "\n/// " << file.topic << ", version " << file.version << ".\n";
    for (const std::string& line : file.comment) {
      out << "/// " << line << '\n';
    }
    out << "struct " << file.structure;
    if (const IdlFile* original = copied(files, file)) {
      out << " : " << original->structure << " {};\n";
      continue;
    }
    out << " {\n";
    for (const Field& field : file.fields) {
      const std::string comment =
          (field.key ? "key" : "") + std::string(field.key && !field.comment.empty() ? ": " : "") + field.comment;
      out << "  " << member(field) << (comment.empty() ? "" : "  ///< " + comment) << '\n';
    }
    out << "};\n";
  }
  out << "\n}  // namespace farrier::signals\n";
}

void write_field_lists(const Files& files, std::ostream& out) {
  out << kWritten
      << "#include \"signals/topic_text.hpp\"\n\n/// X(SignalType, idl_file_stem), in the order of the topics' "
         "numbers.\n"
         "#define FARRIER_SIGNALS(X)";
  for (const IdlFile& file : files) {
    out << " \\\n  X(" << file.structure << ", " << file.path.stem().string() << ')';
  }
  out << "\n\n";
  for (const IdlFile& file : files) {
    out << "#define FARRIER_FIELDS_" << file.structure << "(F)";
    for (const Field& field : file.fields) {
      out << " F(" << field.name << ')';
    }
    out << '\n';
  }
  out << "\nnamespace farrier::signals {\n\n";
  for (const IdlFile& file : files) {
    out << "template <>\ninline constexpr TopicText kTopicText<" << file.structure << ">{\n    \"" << file.topic
        << "\", \"wire::" << file.structure << "\", \"" << file.path.filename().string() << "\", \"" << file.readers
        << "\", \"" << file.key() << "\",\n    " << file.version << ", "
        << std::ranges::count(file.fields, true, &Field::key) << ",\n    \"" << file.structure << ':';
    for (const Field& field : file.fields) {
      out << "\"\n    \" " << field.declaration();
    }
    out << "\\n\"};\n";
  }
  out << "\n}  // namespace farrier::signals\n";
}

void write_includes(const Files& files, const std::string& suffix, std::ostream& out) {
  out << kWritten;
  for (const IdlFile& file : files) {
    out << "#include <" << file.path.stem().string() << suffix << ">\n";
  }
}

}  // namespace farrier::from_idl
