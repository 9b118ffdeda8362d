#include "bus_faults/arrow_fault.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "signals/fields.hpp"

namespace farrier::bus_faults {
namespace {

constexpr std::array<std::pair<std::string_view, Kind>, 10> kKinds{{{"loss", Kind::kLoss},
                                                                   {"burst", Kind::kBurst},
                                                                   {"duplicate", Kind::kDuplicate},
                                                                   {"reorder", Kind::kReorder},
                                                                   {"delay", Kind::kDelay},
                                                                   {"cut", Kind::kCut},
                                                                   {"frozen", Kind::kFrozen},
                                                                   {"noise", Kind::kNoise},
                                                                   {"offset", Kind::kOffset},
                                                                   {"nan", Kind::kNotANumber}}};

template <class Number>
bool read(std::string_view text, Number& number) {
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), number);
  if constexpr (std::is_floating_point_v<Number>) {
    return wrong == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
  }
  return wrong == std::errc{} && end == text.data() + text.size();
}

/// Returns the text before `mark` and the text after it; the second is empty if there is no mark.
std::pair<std::string_view, std::string_view> split(std::string_view text, std::string_view mark) {
  const auto place = text.find(mark);
  return place == std::string_view::npos
             ? std::pair{text, std::string_view{}}
             : std::pair{text.substr(0, place), text.substr(place + mark.size())};
}

std::vector<std::string> fields_of(bus::TopicId topic) {
  std::vector<std::string> names;
  const auto add = [&](const char* name, const auto& field) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, double>) {
      names.emplace_back(name);
    }
  };
  switch (topic) {
#define FARRIER_CASE(Signal, file)                        \
  case bus::TopicId::k##Signal:                           \
    signals::visit_fields(signals::Signal{}, add);        \
    break;
    FARRIER_SIGNALS(FARRIER_CASE)
#undef FARRIER_CASE
  }
  return names;
}

template <class List, class Name>
std::string listed(const List& list, Name&& name_of) {
  std::string text;
  for (const auto& one : list) {
    text += (text.empty() ? "" : ", ") + std::string(name_of(one));
  }
  return text;
}

Error refusal(const std::string& whole, std::string_view part, const std::string& remedy) {
  return Error{"fault '" + whole + "': '" + std::string(part) + "' " + remedy};
}

bool read_share(std::string_view text, double& share) { return read(text, share) && share >= 0.0 && share <= 1.0; }

bool read_milliseconds(std::string_view text, Nanoseconds& time) {
  constexpr double kLongest_ms = 60'000.0;
  double ms = 0.0;
  if (!read(text, ms) || ms < 0.0 || ms > kLongest_ms) {
    return false;
  }
  time = Nanoseconds(std::llround(ms * 1e6));
  return true;
}

Result<Done> read_value(const std::string& whole, std::string_view value, ArrowFault& fault) {
  switch (fault.kind) {
    case Kind::kLoss:
    case Kind::kDuplicate:
    case Kind::kReorder:
      return read_share(value, fault.probability) ? Result<Done>(Done{})
                                                  : refusal(whole, value, "is no probability: give 0 to 1");
    case Kind::kBurst: {
      const auto [share, length] = split(value, "x");
      const bool good = read_share(share, fault.probability) && read(length, fault.length) && fault.length > 0;
      return good ? Result<Done>(Done{}) : refusal(whole, value, "is no burst: give PROBABILITYxLENGTH, as 0.01x20");
    }
    case Kind::kDelay: {
      const auto [least, most] = split(value, "..");
      const bool good = read_milliseconds(least, fault.least) &&
                        read_milliseconds(most.empty() ? least : most, fault.most) && fault.least <= fault.most;
      return good ? Result<Done>(Done{}) : refusal(whole, value, "is no delay: give milliseconds up to 60000, as 1..5");
    }
    case Kind::kCut:
    case Kind::kFrozen:
      return value.empty() ? Result<Done>(Done{}) : refusal(whole, value, "is too much: this kind has no value");
    case Kind::kNoise:
    case Kind::kOffset:
    case Kind::kNotANumber:
      break;
  }
  const bool has_amount = fault.kind != Kind::kNotANumber;
  const auto sign = has_amount ? value.find_first_of("+-") : std::string_view::npos;
  fault.field = std::string(value.substr(0, sign));
  const std::vector<std::string> fields = fields_of(fault.topic);
  if (std::ranges::find(fields, fault.field) == fields.end()) {
    return refusal(whole, fault.field, "is no number of this topic: it has " + listed(fields, std::identity{}));
  }
  if (has_amount) {
    const std::string_view amount = sign == std::string_view::npos ? std::string_view{} : value.substr(sign);
    if (!read(amount.starts_with('+') ? amount.substr(1) : amount, fault.amount)) {
      return refusal(whole, value, "lacks how much: give FIELD+AMOUNT or FIELD-AMOUNT, SI");
    }
  }
  return Done{};
}

std::string number_text(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string value_text(const ArrowFault& fault) {
  const auto ms = [](Nanoseconds time) { return number_text(static_cast<double>(time.count()) * 1e-6); };
  switch (fault.kind) {
    case Kind::kLoss:
    case Kind::kDuplicate:
    case Kind::kReorder:
      return "=" + number_text(fault.probability);
    case Kind::kBurst:
      return "=" + number_text(fault.probability) + "x" + std::to_string(fault.length);
    case Kind::kDelay:
      return "=" + ms(fault.least) + ".." + ms(fault.most);
    case Kind::kCut:
    case Kind::kFrozen:
      return "";
    case Kind::kNoise:
    case Kind::kOffset:
      return "=" + fault.field + (fault.amount < 0.0 ? "" : "+") + number_text(fault.amount);
    case Kind::kNotANumber:
      return "=" + fault.field;
  }
  return "";
}

}  // namespace

Result<ArrowFault> parse_arrow_fault(const std::string& text) {
  const auto [before_key, key] = split(text, "#");
  const auto [what, span] = split(before_key, "@");
  const auto [topic_name, how] = split(what, ":");
  const auto [kind_name, value] = split(how, "=");
  const auto topic = std::ranges::find(bus::topics(), topic_name, &bus::TopicSpec::name);
  if (topic == bus::topics().end()) {
    return refusal(text, topic_name, "is no topic: " + listed(bus::topics(), [](const auto& t) { return t.name; }));
  }
  const auto kind = std::ranges::find(kKinds, kind_name, [](const auto& one) { return one.first; });
  if (kind == kKinds.end()) {
    return refusal(text, kind_name, "is no kind of fault: " + listed(kKinds, [](const auto& k) { return k.first; }));
  }
  ArrowFault fault{.topic = topic->id, .kind = kind->second, .field = {}, .key = {}};
  FARRIER_TRY(read_value(text, value, fault));
  if (before_key.size() > what.size()) {
    const auto [from, until] = split(span, "..");
    if (!read(from, fault.from) || !read(until, fault.until) || fault.from < 0 || fault.until <= fault.from) {
      return refusal(text, span, "is no span of ticks: give FROM..UNTIL, as 2000..3000");
    }
  }
  if (text.size() > before_key.size()) {
    fault.key.emplace();
    if (!read(key, *fault.key)) {
      return refusal(text, key, "is no key: give a number");
    }
  }
  return fault;
}

std::string to_string(const ArrowFault& fault) {
  const auto kind = std::ranges::find(kKinds, fault.kind, [](const auto& one) { return one.second; });
  std::string text = std::string(bus::spec(fault.topic).name) + ":" + std::string(kind->first) + value_text(fault);
  if (fault.from != 0 || fault.until != std::numeric_limits<Tick>::max()) {
    text += "@" + std::to_string(fault.from) + ".." + std::to_string(fault.until);
  }
  return text + (fault.key ? "#" + std::to_string(*fault.key) : "");
}

}  // namespace farrier::bus_faults
