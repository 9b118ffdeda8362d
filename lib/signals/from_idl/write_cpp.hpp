#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "signals/from_idl/idl_file.hpp"

namespace farrier::from_idl {

/// The files of idl/ in the order of their topics' numbers.
using Files = std::vector<IdlFile>;

/// Reads the files. Throws std::runtime_error, as read() does, also for a gap in the topics' numbers and for a file
/// that states the fields of another one but differs.
Files read_all(std::span<char*> paths);

/// Writes a struct per topic.
void write_structs(const Files& files, std::ostream& out);

/// Writes FARRIER_SIGNALS, the field list of every struct, and its TopicText.
void write_field_lists(const Files& files, std::ostream& out);

/// Writes an #include of `<file stem><suffix>` per topic: the header of a vendor's generator.
void write_includes(const Files& files, const std::string& suffix, std::ostream& out);

}  // namespace farrier::from_idl
