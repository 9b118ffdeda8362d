#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.hpp"

namespace farrier::bus {

/// One element of an XML text, as far as vendors' settings need it. Text and attributes are as written, with entities.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes = {};
  std::string text = {};         ///< directly in it, without white space at its ends
  int line = 1;                  ///< of its first tag
  std::string_view source = {};  ///< of the whole element, a part of the parsed text
  std::vector<XmlElement> children = {};

  /// Value of an attribute in any case of letters; empty for none.
  std::string attribute(std::string_view name) const;
};

/// True if two names are equal in any case of ASCII letters, as Cyclone compares them.
bool same_name(std::string_view left, std::string_view right) noexcept;

/// Text of a file. Refuses one that cannot be read or is empty.
Result<std::string> read_settings_file(const std::string& path);

/// The elements of a text at its top level, in order. Refuses a text that is not well formed: "it is not well formed XML (line
/// 3: ...)". At most 1 MB and 32 levels. The elements refer to `text`.
Result<std::vector<XmlElement>> parse_xml(std::string_view text);

}  // namespace farrier::bus
