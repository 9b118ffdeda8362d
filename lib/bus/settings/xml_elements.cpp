#include "bus/settings/xml_elements.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace farrier::bus {
namespace {

constexpr std::size_t kLongest = 1u << 20;
constexpr int kDeepest = 32;
constexpr std::string_view kSpace = " \t\r\n";

char lower(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Result<std::vector<XmlElement>> parse() {
    XmlElement root;
    const std::string problem = content(root, 0);
    if (!problem.empty()) {
      return Error{"it is not well formed XML (line " + std::to_string(line_at(at_)) + ": " + problem + ")"};
    }
    return std::move(root.children);
  }

 private:
  int line_at(std::size_t at) const {
    return 1 + static_cast<int>(std::ranges::count(text_.substr(0, std::min(at, text_.size())), '\n'));
  }
  bool begins(std::string_view mark) const { return text_.substr(at_).starts_with(mark); }
  void skip_space() { at_ = std::min(text_.find_first_not_of(kSpace, at_), text_.size()); }

  /// Goes behind `mark`; false if it does not come.
  bool skip_past(std::string_view mark) {
    const std::size_t found = text_.find(mark, at_);
    at_ = found == std::string_view::npos ? text_.size() : found + mark.size();
    return found != std::string_view::npos;
  }

  std::string name() {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n/>=<\"'", at_), text_.size());
    const std::string result(text_.substr(at_, end - at_));
    at_ = end;
    return result;
  }

  /// Reads up to the end tag of `element`, or at the top level up to the end. Returns what is wrong, empty for nothing.
  std::string content(XmlElement& element, int depth) {
    std::string text;
    while (at_ < text_.size()) {
      if (text_[at_] != '<') {
        const std::size_t end = std::min(text_.find('<', at_), text_.size());
        text += text_.substr(at_, end - at_);
        at_ = end;
      } else if (begins("<!--")) {
        if (!skip_past("-->")) {
          return "a comment without end";
        }
      } else if (begins("<?") || begins("<!")) {
        if (!skip_past(">")) {
          return "a declaration without end";
        }
      } else if (begins("</")) {
        at_ += 2;
        const std::string closed = name();
        skip_space();
        if (depth == 0 || closed != element.name || at_ >= text_.size() || text_[at_] != '>') {
          return "</" + closed + "> ends no element";
        }
        ++at_;
        set_text(element, text);
        return "";
      } else if (std::string problem = child(element, depth); !problem.empty()) {
        return problem;
      }
    }
    if (depth == 0 && text.find_first_not_of(kSpace) != std::string::npos) {
      return "text outside of an element";
    }
    return depth == 0 ? "" : "<" + element.name + "> without end";
  }

  std::string child(XmlElement& parent, int depth) {
    if (depth >= kDeepest) {
      return "elements nested deeper than " + std::to_string(kDeepest) + " levels";
    }
    const std::size_t begin = at_;
    ++at_;
    XmlElement element;
    element.name = name();
    element.line = line_at(begin);
    if (element.name.empty()) {
      return "a tag without name";
    }
    bool empty = false;
    if (std::string problem = attributes(element, empty); !problem.empty()) {
      return problem;
    }
    if (!empty) {
      if (std::string problem = content(element, depth + 1); !problem.empty()) {
        return problem;
      }
    }
    element.source = text_.substr(begin, at_ - begin);
    parent.children.push_back(std::move(element));
    return "";
  }

  std::string attributes(XmlElement& element, bool& empty) {
    for (skip_space(); at_ < text_.size(); skip_space()) {
      if (text_[at_] == '>') {
        ++at_;
        return "";
      }
      if (begins("/>")) {
        at_ += 2;
        empty = true;
        return "";
      }
      const std::string key = name();
      skip_space();
      if (key.empty() || at_ >= text_.size() || text_[at_] != '=') {
        return "<" + element.name + "> has an attribute without value";
      }
      ++at_;
      skip_space();
      const char quote = at_ < text_.size() ? text_[at_] : ' ';
      const std::size_t end = quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : std::string_view::npos;
      if (end == std::string_view::npos) {
        return "<" + element.name + "> has an attribute without value in quotes";
      }
      element.attributes.emplace_back(key, std::string(text_.substr(at_ + 1, end - at_ - 1)));
      at_ = end + 1;
    }
    return "<" + element.name + "> without end";
  }

  static void set_text(XmlElement& element, const std::string& text) {
    const std::size_t first = text.find_first_not_of(kSpace);
    element.text = first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

bool same_name(std::string_view left, std::string_view right) noexcept {
  return std::ranges::equal(left, right, [](char a, char b) { return lower(a) == lower(b); });
}

std::string XmlElement::attribute(std::string_view wanted) const {
  const auto found = std::ranges::find_if(attributes, [&](const auto& item) { return same_name(item.first, wanted); });
  return found == attributes.end() ? "" : found->second;
}

Result<std::string> read_settings_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file || text.empty()) {
    return Error{"the file cannot be read or is empty"};
  }
  return text;
}

Result<std::vector<XmlElement>> parse_xml(std::string_view text) {
  if (text.size() > kLongest) {
    return Error{"it is not well formed XML (line 1: more than 1 MB)"};
  }
  if (text.starts_with("\xEF\xBB\xBF")) {
    text.remove_prefix(3);
  }
  return Parser(text).parse();
}

}  // namespace farrier::bus
