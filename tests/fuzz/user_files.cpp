// Files that users have beside their robots: times of logs, DDS settings, descriptions of robots.

#include <cmath>
#include <vector>

#include "bus/settings/user_settings.hpp"
#include "diagnosis/data/even_times.hpp"
#include "robot/description_format.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/input.hpp"

namespace farrier::fuzz {

void log_times(Bytes bytes) {
  Input input(bytes);
  const double period_s = input.below(2) == 0 ? 1e-3 : 2e-3;
  const double unit_s = period_s / static_cast<double>(1 + input.below(200));
  std::vector<double> time_s, position, current, swing;
  std::vector<std::size_t> line;
  double now_s = input.number(1e3);
  now_s = std::isfinite(now_s) && std::abs(now_s) < 1e10 ? now_s : 0.0;
  constexpr std::size_t kSamples = 1200;
  for (std::size_t i = 0; i < kSamples; ++i) {
    time_s.push_back(now_s);
    position.push_back(input.empty() ? std::sin(0.01 * static_cast<double>(i)) : 1e-3 * input.byte());
    current.push_back(1e-4 * static_cast<double>(i % 7));
    swing.push_back(i % 5 == 0 ? 1.0 : 0.0);
    line.push_back(i + 2);
    now_s += input.empty() ? period_s : unit_s * static_cast<double>(input.raw<std::int8_t>());
  }
  const std::size_t rows = time_s.size();
  const auto even = diagnosis::make_even(time_s, line,
                                         {{&position, diagnosis::Carry::kInterpolated, "position_m"},
                                          {&current, diagnosis::Carry::kHeld, "valve_current_A"},
                                          {&swing, diagnosis::Carry::kFlag, "swing"}});
  require(position.size() == time_s.size() && current.size() == time_s.size() && swing.size() == time_s.size() &&
              line.size() == time_s.size(),
          "all columns are equally long");
  if (!even.findings.empty()) {
    return require(time_s.size() == rows, "what is refused is not changed");
  }
  require(time_s.size() >= diagnosis::kFewestSamples, "a recording is long enough");
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    require(
        std::isfinite(position[i]) && current[i] >= 0.0 && current[i] <= 7e-4 && (swing[i] == 0.0 || swing[i] == 1.0),
        "values stay in their range");
    require(i == 0 || time_s[i] > time_s[i - 1], "times rise");
  }
}

void dds_settings(Bytes bytes) {
  const auto read = bus::cyclone_settings(std::string(text_of(bytes)), {});
  for (const bus::UserSetting& setting : read.settings) {
    require(!bus::to_string(setting).empty(), "a setting has its sentence");
  }
  for (const bus::UserSetting& setting : bus::cyclone_settings(read.config, {}).settings) {
    require(setting.use == bus::SettingUse::kHonoured, "what is handed on is well formed and honoured");
  }
}

void description(Bytes bytes) {
  if (const auto problem = robot::foreign_description(std::string(text_of(bytes)), "robot")) {
    require(!problem->message.empty() && problem->line >= 1, "a refusal has its line and sentence");
  }
}

}  // namespace farrier::fuzz
