#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/result.hpp"
#include "tools/deploy/rendering.hpp"

namespace farrier::deploy {

/// Name of the list of its files that every rendered folder has, by which it is known.
inline constexpr const char* kManifest = "rendered.txt";

/// Returns the text of a file, or nothing if it cannot be read.
std::optional<std::string> text_of(const std::filesystem::path& path);

/// Puts the files, and a list of them, into a folder that appears whole or not at all: they are written beside it and
/// change places with it. A folder that is there already must be empty or one that this wrote, with nothing added.
/// `heading` is the beginning of the list.
Result<Done> write_folder(const std::string& path, const std::vector<RenderedFile>& files, const std::string& heading);

/// Names of those files that the folder lacks or has with another text.
std::vector<std::string> differing_files(const std::string& path, const std::vector<RenderedFile>& files);

}  // namespace farrier::deploy
