#include "config/printer.hpp"

#include <cmath>
#include <utility>

namespace farrier::config {
namespace {

// Quoted, so that no name is taken for a number, a flag or nothing.
std::string in_quotes(const std::string& name) { return "\"" + name + "\""; }

class Printer final : public Visitor {
 public:
  std::string text() && { return std::move(text_); }

 private:
  void line(const std::string& key, const std::string& value) {
    text_.append(2 * depth_, ' ').append(key).append(value.empty() ? ":" : ": ").append(value).append("\n");
  }

  template <class Items, class Text>
  void list(const char* key, const Items& items, Text text_of) {
    std::string text;
    for (const auto& item : items) {
      text += (text.empty() ? "" : ", ") + text_of(item);
    }
    line(key, "[" + text + "]");
  }

  void visit_number(const Entry& entry, double& value, Range, std::optional<double>) override {
    if (!std::isnan(value)) {
      line(entry.name, number_text(value));
    }
  }
  void visit_integer(const Entry& entry, int& value, Range, std::optional<int>) override {
    line(entry.name, std::to_string(value));
  }
  void visit_flag(const Entry& entry, bool& value, std::optional<bool>) override {
    line(entry.name, value ? "true" : "false");
  }
  void visit_name(const Entry& entry, std::string& value, std::size_t, const char*) override {
    if (!value.empty()) {  // only the default of an absent key is empty
      line(entry.name, in_quotes(value));
    }
  }
  void visit_numbers(const Entry& entry, std::vector<double>& values, Range) override {
    list(entry.name, values, number_text);
  }
  void visit_text(const Entry& entry, std::string& value, const TextRule&) override {
    line(entry.name, in_quotes(value));
  }
  void visit_names(const Entry& entry, std::vector<std::string>& values, bool required) override {
    if (required || !values.empty()) {
      list(entry.name, values, in_quotes);
    }
  }
  void visit_pairs(const Entry& entry, Named<std::string>& items, Place&, std::size_t) override {
    line(entry.name, "");
    ++depth_;
    for (const auto& [name, value] : items) {
      line(in_quotes(name), in_quotes(value));
    }
    --depth_;
  }
  void visit_choice(const Entry& entry, int& index, std::span<const char* const> names, std::optional<int>) override {
    line(entry.name, names[static_cast<std::size_t>(index)]);
  }
  bool enter_group(const Entry& entry, bool, bool present) override {
    if (present) {
      line(entry.name, "");
      ++depth_;
    }
    return present;
  }
  bool enter_map(const Entry& entry, std::vector<std::string>& names, std::size_t, bool required) override {
    return enter_group(entry, required, required || !names.empty());
  }
  bool enter_item(const std::string& name) override {
    line(in_quotes(name), "");
    ++depth_;
    return true;
  }
  void leave() override { --depth_; }

  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace

std::string print_declared(const std::function<void(Visitor&)>& declare_all) {
  Printer printer;
  declare_all(printer);
  return std::move(printer).text();
}

}  // namespace farrier::config
