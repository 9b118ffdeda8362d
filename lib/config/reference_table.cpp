#include "config/reference_table.hpp"

#include <cmath>
#include <utility>

#include "config/suggest.hpp"

namespace farrier::config {
namespace {

class TableWriter final : public Visitor {
 public:
  std::string text() && { return std::move(text_); }

 private:
  std::string path(const std::string& name) const { return paths_.empty() ? name : paths_.back() + "." + name; }

  void row(const Entry& entry, const std::string& unit, const std::string& values, const std::string& fallback) {
    text_ += "| `" + path(entry.name) + "` | " + unit + " | " + values + " | " + fallback + " | ";
    text_ += std::string(entry.sentence) + " |\n";
  }

  static std::string range_text(Range range) {
    return std::isinf(range.max) ? "by joint" : number_text(range.min) + " to " + number_text(range.max);
  }
  static std::string fallback_text(std::optional<double> fallback) {
    return !fallback ? kRequired : std::isnan(*fallback) ? "see meaning" : number_text(*fallback);
  }

  void visit_number(const Entry& entry, double&, Range range, std::optional<double> fallback) override {
    row(entry, unit_of(entry.name), range_text(range), fallback_text(fallback));
  }
  void visit_integer(const Entry& entry, int&, Range range, std::optional<int> fallback) override {
    row(entry, unit_of(entry.name), "whole, " + range_text(range), fallback ? std::to_string(*fallback) : kRequired);
  }
  void visit_flag(const Entry& entry, bool&, std::optional<bool> fallback) override {
    row(entry, "", "true, false", !fallback ? kRequired : *fallback ? "true" : "false");
  }
  void visit_name(const Entry& entry, std::string&, std::size_t longest, const char* fallback) override {
    row(entry, "", "name of at most " + std::to_string(longest), fallback != nullptr ? fallback : kRequired);
  }
  void visit_numbers(const Entry& entry, std::vector<double>&, Range range) override {
    row(entry, unit_of(entry.name), "list, each " + range_text(range), "empty");
  }
  void visit_text(const Entry& entry, std::string&, const TextRule& rule) override {
    row(entry, "", rule.what, kRequired);
  }
  void visit_names(const Entry& entry, std::vector<std::string>&, bool required) override {
    row(entry, "", "list of names", required ? kRequired : "empty");
  }
  void visit_pairs(const Entry& entry, Named<std::string>&, Place&, std::size_t) override {
    row(entry, "", "map of names", kRequired);
  }
  void visit_choice(const Entry& entry, int&, std::span<const char* const> names,
                    std::optional<int> fallback) override {
    std::string list;
    for (const char* name : names) {
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
    row(entry, "", list, fallback ? names[static_cast<std::size_t>(*fallback)] : kRequired);
  }
  bool enter_group(const Entry& entry, bool required, bool present) override {
    row(entry, "", "group", required ? kRequired : present ? "its defaults" : "absent");
    paths_.push_back(path(entry.name));
    return true;
  }
  bool enter_map(const Entry& entry, std::vector<std::string>& names, std::size_t, bool required) override {
    row(entry, "", "map of groups", required ? kRequired : "absent");
    paths_.push_back(path(entry.name));
    names = {"<name>"};
    return true;
  }
  bool enter_item(const std::string& name) override {
    paths_.push_back(path(name));
    return true;
  }
  void leave() override { paths_.pop_back(); }

  static constexpr const char* kRequired = "required";

  std::string text_ = "| parameter | unit | values | default | meaning |\n|---|---|---|---|---|\n";
  std::vector<std::string> paths_;
};

}  // namespace

std::string table_of_declared(const std::function<void(Visitor&)>& declare_all) {
  TableWriter writer;
  declare_all(writer);
  return std::move(writer).text();
}

}  // namespace farrier::config
