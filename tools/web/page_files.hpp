#pragma once

#include <map>
#include <string>

#include "core/result.hpp"

namespace farrier::web {

/// One file of the page, as it is served.
struct PageFile {
  std::string type;   ///< of its content
  std::string bytes;
};

/// By the path in a URL; "/" is index.html.
using PageFiles = std::map<std::string, PageFile>;

/// Every file of a folder: nothing else can be asked for. Refuses a folder that lacks the page or its charts, which a
/// build without npm does.
Result<PageFiles> read_page(const std::string& directory);

}  // namespace farrier::web
