#pragma once

#include <tinyxml2.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace farrier::bus {

/// Vendors' settings. A text may be a fragment with several elements at its top level.
using XmlPtr = std::unique_ptr<tinyxml2::XMLDocument>;

/// True if two names are equal in any case of ASCII letters, as Cyclone compares them.
bool same_name(std::string_view left, std::string_view right);

/// Value of an attribute in any case of letters; empty for none.
std::string attribute_of(const tinyxml2::XMLElement& element, std::string_view name);

/// Text at the begin of an element, without white space at its ends.
std::string text_of(const tinyxml2::XMLElement& element);

/// Calls `use` with each element directly in a node, in order.
void for_each_element(const tinyxml2::XMLNode& node, const auto& use) {
  for (const tinyxml2::XMLElement* child = node.FirstChildElement(); child; child = child->NextSiblingElement()) {
    use(*child);
  }
}

/// Refuses a text that is not well formed: "it is not well formed XML (line 3: XML_ERROR_PARSING_ATTRIBUTE)". At most 1 MB
/// and 100 levels.
Result<XmlPtr> parse_xml(std::string_view text);

/// As parse_xml() of a file. Refuses one that cannot be read or is empty, too.
Result<XmlPtr> parse_xml_file(const std::string& path);

}  // namespace farrier::bus
