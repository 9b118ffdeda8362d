#include "bench/command/parts.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/replace_file.hpp"

namespace farrier::cli {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const report::Figures& figures) {
  Json json = Json::array();
  for (const report::Figure& figure : figures.all()) {
    json.push_back({{"name", figure.name}, {"value", figure.value}});  // null where not finite
    if (figure.bound) {
      json.back()["bound"] = *figure.bound;
    }
  }
  return json;
}

/// The figures of a part; nothing when this build would not add them. Throws what nlohmann::json throws.
std::optional<report::Figures> figures_of(const Json& json) {
  report::Figures figures;
  for (const Json& one : json) {
    const std::string name = one.at("name");
    const double value =
        one.at("value").is_null() ? std::numeric_limits<double>::quiet_NaN() : one.at("value").get<double>();
    const auto bound = one.contains("bound") ? std::optional(one.at("bound").get<double>()) : std::nullopt;
    const report::FigureSpec* spec = report::find_spec(name);
    if (spec == nullptr || figures.find(name) != nullptr || (bound && spec->relation == report::Relation::kNone)) {
      return std::nullopt;
    }
    figures.add(name, value, bound);
  }
  return figures;
}

void add_all(report::Figures& figures, const report::Figures& more) {
  for (const report::Figure& figure : more.all()) {
    figures.add(figure.name, figure.value, figure.bound);
  }
}

}  // namespace

std::vector<std::string> PartsRun::take_over() {
  std::vector<std::string> names;
  std::ifstream file(path_);
  try {
    const Json json = Json::parse(file);
    if (json.at("origin") != origin_) {
      return {};
    }
    for (const Json& part : json.at("parts")) {
      const std::string name = part.at("name");
      auto figures = figures_of(part.at("figures"));
      if (figures && !part.contains("failure") && find(name) == nullptr) {
        measured_.push_back({name, "", std::move(*figures)});
        names.push_back(name);
      }
    }
  } catch (const Json::exception&) {  // no file, or somebody else's: what came before is of this form
  }
  return names;
}

void PartsRun::run(std::span<const Part> parts, report::Outcome& outcome, const std::function<bool()>& stopped) {
  std::string unwritten;
  for (const Part& part : parts) {
    if (find(part.name) == nullptr && !stopped()) {
      measure(part);
      if (const auto written = write(); !written) {
        unwritten = written.error().message;
      }
    }
    const Measured* measured = find(part.name);
    if (measured == nullptr) {
      outcome.failures.push_back(part.name + ": not measured, interrupted");
      continue;
    }
    add_all(outcome.figures, measured->figures);
    if (!measured->failure.empty()) {
      outcome.failures.push_back(part.name + ": " + measured->failure);
    }
  }
  if (!unwritten.empty()) {
    outcome.failures.push_back("parts are not kept: " + unwritten);
  }
}

const PartsRun::Measured* PartsRun::find(const std::string& name) const {
  const auto found = std::ranges::find(measured_, name, &Measured::name);
  return found == measured_.end() ? nullptr : &*found;
}

void PartsRun::measure(const Part& part) {
  Measured measured{part.name, "", {}};
  try {
    if (const auto done = part.measure(measured.figures); !done) {
      measured.failure = done.error().message.empty() ? "failed" : done.error().message;
    }
  } catch (const std::exception& thrown) {
    measured.failure = thrown.what();
  }
  measured_.push_back(std::move(measured));
}

Result<Done> PartsRun::write() const {
  Json parts = Json::array();
  for (const Measured& measured : measured_) {
    Json part{{"name", measured.name}};
    if (!measured.failure.empty()) {
      part["failure"] = measured.failure;
    }
    part["figures"] = json_of(measured.figures);
    parts.push_back(std::move(part));
  }
  const Json json{{"origin", origin_}, {"parts", std::move(parts)}};
  constexpr int kIndent = 2;
  // Last words of a process may be no UTF-8: replaced rather than thrown about.
  return replace_file(path_, json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace farrier::cli
