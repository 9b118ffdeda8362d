#include "ros_messages/from_idl/write_structs.hpp"

#include <cctype>
#include <map>
#include <stdexcept>
#include <vector>

namespace farrier::ros_from_idl {
namespace {

/// Words of the file, without comments: names with "::", numbers, and single characters.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const auto in_name = [&](std::size_t i) {
      return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_' || text[i] == ':');
    };
    if (text.compare(at, 2, "//") == 0) {
      at = text.find('\n', at);
    } else if (std::isspace(static_cast<unsigned char>(text[at]))) {
      ++at;
    } else if (std::size_t end = at; in_name(at)) {
      while (in_name(end)) {
        ++end;
      }
      words.push_back(text.substr(at, end - at));
      at = end;
    } else {
      words.emplace_back(1, text[at++]);
    }
  }
  return words;
}

/// "geometry_msgs::Pose" of "geometry_msgs::msg::dds_::Pose_".
std::string cpp_name(std::string scoped) {
  const std::string middle = "::msg::dds_::";
  const std::size_t at = scoped.find(middle);
  if (at == std::string::npos || scoped.back() != '_') {
    throw std::runtime_error("no type of ROS: " + scoped);
  }
  scoped.pop_back();
  return scoped.replace(at, middle.size(), "::");
}

class Writer {
 public:
  Writer(std::vector<std::string> words, std::ostream& out) : words_(std::move(words)), out_(out) {}

  void write() {
    out_ << "// Written by ros_from_idl from lib/ros_messages/ros.idl.\n#pragma once\n\n"
            "#include \"ros_messages/field_types.hpp\"\n\nnamespace farrier::ros_messages {\n";
    while (at_ < words_.size()) {
      const std::string word = next();
      if (word == "module") {
        modules_.push_back(next());
        expect("{");
      } else if (word == "struct") {
        write_struct();
      } else if (word == "}") {
        modules_.pop_back();
        expect(";");
      } else if (word == "@") {
        next();
      } else {
        throw std::runtime_error("unexpected word: " + word);
      }
    }
    out_ << "\n/// List<...> of every message.\ntemplate <template <class...> class List>\nusing AllMessages = List<"
         << all_ << ">;\n\n}  // namespace farrier::ros_messages\n";
  }

 private:
  std::string next() { return at_ < words_.size() ? words_[at_++] : throw std::runtime_error("the file ends early"); }
  void expect(const std::string& word) {
    if (const std::string found = next(); found != word) {
      throw std::runtime_error("expected " + word + ", found " + found);
    }
  }
  bool comes(const std::string& word) {
    const bool here = at_ < words_.size() && words_[at_] == word;
    at_ += here ? 1 : 0;
    return here;
  }

  std::string type() {
    static const std::map<std::string, std::string> kPlain = {{"boolean", "bool"},         {"octet", "std::byte"},
                                                              {"uint8", "std::uint8_t"},   {"int32", "std::int32_t"},
                                                              {"uint32", "std::uint32_t"}, {"double", "double"}};
    const std::string word = next();
    if (word == "string") {
      if (!comes("<")) {
        return "std::string";
      }
      const std::string bound = next();
      expect(">");
      return "BoundedString<" + bound + ">";
    }
    if (word == "sequence") {
      expect("<");
      const std::string element = type();
      expect(">");
      return "std::vector<" + element + ">";
    }
    const auto plain = kPlain.find(word);
    return plain == kPlain.end() ? cpp_name(word) : plain->second;
  }

  void write_struct() {
    std::string name = next();
    name.pop_back();  // the underscore that rosidl appends
    const std::string& package = modules_.front();
    all_ += (all_.empty() ? "" : ", ") + package + "::" + name;
    out_ << "\nnamespace " << package << " {\nstruct " << name << " {\n  static constexpr const char* kRosName = \""
         << package << "/msg/" << name << "\";\n";
    expect("{");
    std::string visits;
    while (!comes("}")) {
      std::string of = type();
      const std::string field = next();
      if (comes("[")) {
        of = "std::array<" + of + ", " + next() + ">";
        expect("]");
      }
      expect(";");
      out_ << "  " << of << ' ' << field << "{};\n";
      visits += "    visitor(\"" + field + "\", self." + field + ");\n";
    }
    expect(";");
    out_ << "  /// Calls visitor(name, field) with each field of `self`, in the order of the wire.\n"
            "  template <class Self, class Visitor>\n  static void visit(Self& self, Visitor&& visitor) {\n"
         << visits << "  }\n  friend bool operator==(const " << name << "&, const " << name
         << "&) = default;\n};\n}  // namespace " << package << "\n";
  }

  std::vector<std::string> words_;
  std::size_t at_ = 0;
  std::vector<std::string> modules_;
  std::string all_;  // names of all structs
  std::ostream& out_;
};

}  // namespace

void write_structs(const std::string& idl, std::ostream& out) { Writer(words_of(idl), out).write(); }

}  // namespace farrier::ros_from_idl
