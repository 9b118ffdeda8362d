#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace farrier::from_idl {

/// A field of a struct in idl/.
struct Field {
  bool key = false;
  std::string type;  ///< as IDL has it, such as "unsigned short"
  std::string name;
  std::string count;  ///< of an array; empty for a single value
  std::string comment;

  /// The declaration without a comment: "@key unsigned short joint;".
  std::string declaration() const;
};

/// A file of idl/: the topic that its first comment names, and its struct.
struct IdlFile {
  std::filesystem::path path;
  int number = -1;    ///< of the topic, from 0 on
  std::string topic;  ///< "joint/sensors"
  std::string version;
  std::string readers;               ///< for people: behind the arrow of the comment
  std::vector<std::string> comment;  ///< lines behind the first
  std::string structure;             ///< name of the struct
  std::vector<Field> fields;

  /// Names of the key fields with ", " between them.
  std::string key() const;
};

/// Reads a file. Throws std::runtime_error with path, line and remedy for anything but the subset of IDL that
/// idl/README.md describes.
IdlFile read(const std::filesystem::path& path);

}  // namespace farrier::from_idl
