#include "config/reader.hpp"

#include <algorithm>
#include <set>

#include "config/scalar.hpp"
#include "config/suggest.hpp"

namespace farrier::config {
namespace {

class Reader final : public Visitor {
 public:
  Reader(const Value& root, std::string file) : file_(std::move(file)) {
    if (root.kind != Value::Kind::kMap) {
      report(root.line, "", "is " + shown(root) + ": give a map of parameters");
    }
    open(root, "", root.line);
  }

  Problems finish() {
    leave();
    return std::move(problems_);
  }

  void here(Place& place) override {
    const Frame& frame = frames_.back();
    place = {file_, frame.where, frame.line, {}};
    for (const Value::Entry& entry : frame.value->entries) {
      place.lines.emplace(entry.key, entry.line);
    }
  }

  void check(bool holds, const char* key, const std::string& message) override {
    const bool all_good = problems_.size() == frames_.back().problems_before && frames_.back().missing.empty();
    if (all_good && !holds) {
      const Value::Entry* entry = entry_of(key);
      report(entry != nullptr ? entry->line : frames_.back().line, path(key), message);
    }
  }

  void moved(const char* key, const char* remedy) override {
    if (const Value::Entry* entry = entry_of(key)) {
      report(entry->line, path(key), std::string("is no longer a parameter: ") + remedy);
      frames_.back().known.emplace_back(key);
    }
  }

 private:
  struct Missing {
    std::string key;
    std::string remedy;
  };
  struct Frame {
    const Value* value;
    std::string where;
    int line;
    std::size_t problems_before;
    bool any_key = false;  // a map of names the author chose
    std::vector<std::string> known;
    std::vector<Missing> missing;
  };

  void open(const Value& value, std::string where, int line) {
    frames_.push_back({&value, std::move(where), line, problems_.size(), false, {}, {}});
  }

  void report(int line, const std::string& where, std::string message) {
    problems_.push_back({file_, line, where, std::move(message)});
  }

  std::string path(const std::string& key) const {
    const std::string& where = frames_.back().where;
    return where.empty() || key.empty() ? where + key : where + "." + key;
  }

  const Value::Entry* entry_of(const std::string& key) const {
    const auto& entries = frames_.back().value->entries;
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.key == key; });
    return found == entries.end() ? nullptr : &*found;
  }

  // The value of a known key; null when the file does not give it, which is noted when it must.
  const Value::Entry* claim(const Entry& entry, bool required, const std::string& remedy) {
    frames_.back().known.emplace_back(entry.name);
    const Value::Entry* found = entry_of(entry.name);
    if (found == nullptr && required) {
      frames_.back().missing.push_back({entry.name, remedy + " (" + entry.sentence + ")"});
    }
    return found;
  }

  // Reports what is wrong with a value, if anything is.
  bool accept(int line, const std::string& where, std::string mistake) {
    if (mistake.empty()) {
      return true;
    }
    report(line, where, std::move(mistake));
    return false;
  }

  void visit_number(const Entry& entry, double& value, Range range, std::optional<double> fallback) override {
    value = fallback.value_or(value);
    if (const auto* found = claim(entry, !fallback, range_remedy(range))) {
      accept(found->line, path(entry.name), read_number(found->value, range, value));
    }
  }

  void visit_integer(const Entry& entry, int& value, Range range, std::optional<int> fallback) override {
    value = fallback.value_or(value);
    if (const auto* found = claim(entry, !fallback, range_remedy(range))) {
      accept(found->line, path(entry.name), read_integer(found->value, range, value));
    }
  }

  void visit_flag(const Entry& entry, bool& value, std::optional<bool> fallback) override {
    value = fallback.value_or(value);
    if (const auto* found = claim(entry, !fallback, "give true or false")) {
      accept(found->line, path(entry.name), read_flag(found->value, value));
    }
  }

  void visit_name(const Entry& entry, std::string& value, std::size_t longest, const char* fallback) override {
    value = fallback != nullptr ? fallback : value;
    if (const auto* found = claim(entry, fallback == nullptr, "give a name")) {
      accept(found->line, path(entry.name), read_name(found->value, longest, value));
    }
  }

  void visit_text(const Entry& entry, std::string& value, const TextRule& rule) override {
    if (const auto* found = claim(entry, true, rule.remedy)) {
      accept(found->line, path(entry.name), read_text_of(found->value, rule, value));
    }
  }

  void visit_choice(const Entry& entry, int& index, std::span<const char* const> names,
                    std::optional<int> fallback) override {
    index = fallback.value_or(index);
    if (const auto* found = claim(entry, !fallback, choice_remedy(names))) {
      accept(found->line, path(entry.name), read_choice(found->value, names, index));
    }
  }

  // Visits the items of a list; what is no list is reported.
  template <class Read>
  void read_list(const Value::Entry& found, const Entry& entry, Read read) {
    if (found.value.kind != Value::Kind::kList) {
      report(found.line, path(entry.name), shown(found.value) + " is not a list: give [ ..., ... ]");
      return;
    }
    for (std::size_t i = 0; i < found.value.items.size(); ++i) {
      const Value& item = found.value.items[i];
      accept(item.line, path(entry.name) + "[" + std::to_string(i) + "]", read(item));
    }
  }

  void visit_numbers(const Entry& entry, std::vector<double>& values, Range range) override {
    values.clear();
    if (const auto* found = claim(entry, false, "")) {
      read_list(*found, entry, [&](const Value& item) { return read_number(item, range, values.emplace_back()); });
    }
  }

  void visit_names(const Entry& entry, std::vector<std::string>& values, bool required) override {
    values.clear();
    if (const auto* found = claim(entry, required, "give [ name, ... ]")) {
      if (found->value.kind == Value::Kind::kList && found->value.items.empty()) {
        report(found->line, path(entry.name), "is empty: give at least one name");
      }
      read_list(*found, entry, [&](const Value& item) { return read_name(item, kLongestName, values.emplace_back()); });
    }
  }

  void visit_pairs(const Entry& entry, Named<std::string>& items, Place& place, std::size_t longest) override {
    std::vector<std::string> names;
    if (!enter_map(entry, names, longest, true)) {
      return;
    }
    here(place);
    items.clear();
    for (const std::string& name : names) {
      const Value::Entry* found = entry_of(name);
      items.emplace_back(name, "");
      accept(found->line, path(name), read_name(found->value, kLongestName, items.back().second));
    }
    leave();
  }

  bool enter_group(const Entry& entry, bool required, bool /*present*/) override {
    const auto* found = claim(entry, required, "give this group");
    if (found == nullptr) {
      return false;
    }
    if (found->value.kind != Value::Kind::kMap) {
      report(found->line, path(entry.name), "is " + shown(found->value) + ": give a group of parameters");
      return false;
    }
    open(found->value, path(entry.name), found->line);
    return true;
  }

  bool enter_map(const Entry& entry, std::vector<std::string>& names, std::size_t longest, bool required) override {
    if (!enter_group(entry, required, true)) {
      return false;
    }
    Frame& frame = frames_.back();
    frame.any_key = true;
    names.clear();
    for (const Value::Entry& item : frame.value->entries) {
      if (std::find(names.begin(), names.end(), item.key) != names.end()) {
        continue;  // leave() reports it
      }
      std::string name;
      const Value key{Value::Kind::kScalar, item.line, item.key, false, {}, {}};
      if (accept(item.line, frame.where, read_name(key, longest, name))) {
        names.push_back(name);
      }
    }
    if (frame.value->entries.empty()) {
      report(frame.line, frame.where, "is empty: give at least one entry");
    }
    return true;
  }

  bool enter_item(const std::string& name) override {
    const Value::Entry* found = entry_of(name);
    if (found->value.kind != Value::Kind::kMap) {
      report(found->line, path(name), "is " + shown(found->value) + ": give a group of parameters");
      return false;
    }
    open(found->value, path(name), found->line);
    return true;
  }

  // Closes a group: what is there twice, what is not known, what is not there.
  void leave() override {
    Frame& frame = frames_.back();
    std::map<std::string, int> first;
    std::set<std::string> explained;
    for (const Value::Entry& entry : frame.value->entries) {
      const auto [seen, is_new] = first.emplace(entry.key, entry.line);
      if (!is_new) {
        report(entry.line, path(entry.key),
               "is given twice, first in line " + std::to_string(seen->second) + ": remove one");
      } else if (!frame.any_key && std::find(frame.known.begin(), frame.known.end(), entry.key) == frame.known.end()) {
        report_unknown(frame, entry, explained);
      }
    }
    for (const Missing& missing : frame.missing) {
      if (!explained.contains(missing.key)) {
        report(frame.line, path(missing.key), "is missing: " + missing.remedy);
      }
    }
    frames_.pop_back();
  }

  // A key that was meant to be a missing one is one mistake, not two.
  void report_unknown(const Frame& frame, const Value::Entry& entry, std::set<std::string>& explained) {
    const Suggestion suggestion = suggest(entry.key, frame.known);
    std::string message = "is not a known parameter";
    if (!suggestion.unit.empty()) {
      message = "is given in " + suggestion.unit + ": " + suggestion.name;
    } else if (!suggestion.name.empty()) {
      message += ": did you mean " + suggestion.name + "?";
    } else {
      message += " here; known are";
      for (const std::string& name : frame.known) {
        message += (name == frame.known.front() ? " " : ", ") + name;
      }
    }
    explained.insert(suggestion.name);
    report(entry.line, path(shown({Value::Kind::kScalar, 0, entry.key, false, {}, {}})), message);
  }

  static constexpr std::size_t kLongestName = 23;  // of a name that refers to something

  std::string file_;
  Problems problems_;
  std::vector<Frame> frames_;
};

}  // namespace

Problems apply(const std::vector<Setting>& settings, const std::string& file, Value& root) {
  Problems problems;
  for (const Setting& setting : settings) {
    if (!override_scalar(root, setting.where, setting.value)) {
      problems.push_back({file, 0, setting.where, "cannot be set: the path leads through a value that is not a group"});
    }
  }
  return problems;
}

Problems read_document(const Value& root, const std::string& file, const std::function<void(Visitor&)>& declare_all) {
  Reader reader(root, file);
  declare_all(reader);
  return reader.finish();
}

}  // namespace farrier::config
