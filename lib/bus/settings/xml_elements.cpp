#include "bus/settings/xml_elements.hpp"

#include <algorithm>
#include <fstream>

#include "core/text.hpp"

namespace farrier::bus {
namespace {

constexpr std::size_t kLongest = 1u << 20;
// tinyxml2 stops without error at an end tag that ends no element and at a zero byte; this is then missing.
constexpr const char* kLast = "farrier.last";

Error malformed(int line, const std::string& what) {
  return Error{"it is not well formed XML (line " + std::to_string(line) + ": " + what + ")"};
}

}  // namespace

bool same_name(std::string_view left, std::string_view right) { return lower(left) == lower(right); }

std::string attribute_of(const tinyxml2::XMLElement& element, std::string_view name) {
  const tinyxml2::XMLAttribute* found = element.FirstAttribute();
  while (found != nullptr && !same_name(found->Name(), name)) {
    found = found->Next();
  }
  return found == nullptr ? "" : found->Value();
}

std::string text_of(const tinyxml2::XMLElement& element) {
  const std::string text = element.GetText() == nullptr ? "" : element.GetText();
  const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

Result<XmlPtr> parse_xml(std::string_view text) {
  if (text.size() > kLongest) {
    return malformed(1, "more than 1 MB");
  }
  const std::string whole = std::string(text) + "<" + kLast + "/>";
  auto document = std::make_unique<tinyxml2::XMLDocument>();
  if (document->Parse(whole.data(), whole.size()) != tinyxml2::XML_SUCCESS) {
    return malformed(std::max(1, document->ErrorLineNum()), document->ErrorName());
  }
  const tinyxml2::XMLElement* const last = document->LastChildElement();
  if (last == nullptr || !same_name(last->Name(), kLast)) {
    return malformed(last == nullptr ? 1 : last->GetLineNum(),
                     "behind this element comes an end tag without element or a zero byte");
  }
  document->DeleteChild(document->LastChild());
  for (const tinyxml2::XMLNode* node = document->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) {
      return malformed(node->GetLineNum(), "text outside of an element");
    }
  }
  return document;
}

Result<XmlPtr> parse_xml_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(file ? kLongest + 1 : 0, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.empty()) {
    return Error{"the file cannot be read or is empty"};
  }
  return parse_xml(text);
}

}  // namespace farrier::bus
