#include "diagnosis/data/recording_sensors.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "diagnosis/data/derive_velocity.hpp"
#include "diagnosis/judge/finding_text.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kShortestAtExtreme = 20;  // samples at a time
constexpr std::size_t kShortestBetween = 50;
constexpr double kLeastShare = 0.01;  // of all samples
constexpr double kCurrentShare = 0.5;

/// One sensor.
struct SensorChannel {
  std::string column;
  std::span<const double> values;
  double least = 0.0, most = 0.0;
  double movement = 0.0;  ///< a larger range exceeds its noise and a tenth of its whole range

  SensorChannel(std::string name, std::span<const double> of, double significant)
      : column(std::move(name)), values(of) {
    const auto [low, high] = std::minmax_element(of.begin(), of.end());
    least = *low;
    most = *high;
    constexpr double kSigmas = 10.0;  // the range of a million samples of white noise
    movement = std::max({significant, kSigmas * white_noise(of), 0.1 * (most - least)});
  }

  bool constant() const { return most == least; }
  bool moves(std::size_t begin, std::size_t end) const {
    const auto part = values.subspan(begin, end - begin);
    const auto [low, high] = std::minmax_element(part.begin(), part.end());
    return *high - *low > movement;
  }
  bool moves() const { return most - least > movement; }
};

class SensorCheck {
 public:
  SensorCheck(const Recording& recording, const robot::Joint& joint) : recording_(recording), joint_(joint) {
    const plant::ActuatorParams& actuator = joint.actuator;
    const double force = std::max(joint.push_limit, joint.pull_limit);
    // Less than this of full scale may be drift of a joint at rest.
    channels_.emplace_back(position_column(recording.coordinates), recording.position, 0.005 * actuator.stroke);
    if (!recording.velocity_derived) {
      velocity_ = channels_.size();
      channels_.emplace_back(velocity_column(recording.coordinates), recording.velocity,
                             0.02 * robot::scales_of(joint).of(plant::Scale::kSpeed));
    }
    force_ = channels_.size();
    channels_.emplace_back(force_column(recording.coordinates), recording.force, 0.01 * force);
    if (!recording.pressure_a_Pa.empty() && !joint.electric) {
      channels_.emplace_back("pressure_a_Pa", recording.pressure_a_Pa, 0.01 * actuator.supply_pressure_Pa);
    }
    if (!recording.pressure_b_Pa.empty() && !joint.electric) {
      channels_.emplace_back("pressure_b_Pa", recording.pressure_b_Pa, 0.01 * actuator.supply_pressure_Pa);
    }
  }

  std::vector<Finding> check() && {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (channels_[i].constant()) {
        check_constant(i);
      } else {
        check_runs(i);
      }
    }
    check_current();
    return std::move(findings_);
  }

 private:
  static constexpr std::size_t kPosition = 0;

  std::size_t line(std::size_t sample) const { return recording_.line.empty() ? 0 : recording_.line[sample]; }

  void check_constant(std::size_t of) {
    const SensorChannel& channel = channels_[of];
    const auto moving =
        std::find_if(channels_.begin(), channels_.end(), [](const SensorChannel& c) { return c.moves(); });
    std::string evidence = moving == channels_.end() ? "" : moving->column;
    if (evidence.empty() && !recording_.valve_current_A.empty()) {
      const auto& current = recording_.valve_current_A;
      const auto [low, high] = std::minmax_element(current.begin(), current.end());
      // A joint that does not answer still has noise: a value that never changes is no sensor's.
      evidence = *high - *low > 0.1 * joint_.actuator.valve_current_max_A ? "valve_current_A" : "";
    }
    if (!evidence.empty()) {
      findings_.push_back({"frozen", 0,
                           "column " + channel.column + ": " + rounded(channel.least) + " in all samples while " +
                               evidence + " changes; check the sensor, or leave out a column that may be missing"});
    }
  }

  /// Channel that proves a constant channel wrong from `begin` to `end` - 1; null: none.
  const SensorChannel* evidence_against(std::size_t of, std::size_t begin, std::size_t end) const {
    if (of == velocity_) {
      // At a steady speed a good sensor is constant too: the position must say another speed.
      const SensorChannel& position = channels_[kPosition];
      const double seconds = static_cast<double>(end - 1 - begin) * recording_.period_s;
      const double error = position.values[end - 1] - position.values[begin] - channels_[of].values[begin] * seconds;
      return std::abs(error) > std::max(0.2 * std::abs(channels_[of].values[begin]) * seconds, position.movement)
                 ? &position
                 : nullptr;
    }
    if (of == kPosition && velocity_ < channels_.size()) {
      const SensorChannel& velocity = channels_[velocity_];  // forces change on a joint at its end stop, too
      return velocity.moves(begin, end) ? &velocity : nullptr;
    }
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (i != of && channels_[i].moves(begin, end)) {
        return &channels_[i];
      }
    }
    return nullptr;
  }

  /// Spells in which a channel keeps one value against the evidence.
  struct Spells {
    Places places;
    std::size_t samples = 0;
    std::size_t longest = 0;
    std::string evidence;
  };

  void check_runs(std::size_t of) {
    const SensorChannel& channel = channels_[of];
    const bool chamber = of > force_;
    const double cavitation = joint_.actuator.return_pressure_Pa + 0.01 * joint_.actuator.supply_pressure_Pa;
    Spells low, high, between;
    const std::size_t n = channel.values.size();
    for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
      const double value = channel.values[begin];
      for (end = begin + 1; end < n && channel.values[end] == value; ++end) {
      }
      Spells& spells = value == channel.most ? high : value == channel.least ? low : between;
      if (end - begin < (&spells == &between ? kShortestBetween : kShortestAtExtreme) ||
          (chamber && value <= cavitation)) {
        continue;
      }
      if (const SensorChannel* evidence = evidence_against(of, begin, end)) {
        spells.places.add(line(begin));
        spells.samples += end - begin;
        spells.longest = std::max(spells.longest, end - begin);
        spells.evidence = evidence->column;
      }
    }
    const std::string remedy = std::string("; widen the sensor's range, or ") +
                               (of == kPosition ? "keep the joint off its end stops" : "excite less");
    report(channel, "saturated", low, "at its lowest value, " + rounded(channel.least) + ",", remedy);
    report(channel, "saturated", high, "at its highest value, " + rounded(channel.most) + ",", remedy);
    report(channel, "frozen", between, "at an unchanging value", "; check its link for lost samples, or cut them out");
  }

  void report(const SensorChannel& channel, const char* what, const Spells& spells, const std::string& where,
              const std::string& remedy) {
    if (static_cast<double>(spells.samples) < kLeastShare * static_cast<double>(channel.values.size()) ||
        spells.samples == 0) {
      return;
    }
    const std::string place = spells.places.text();
    findings_.push_back({what, spells.places.first(),
                         (place.empty() ? "" : place + ", ") + "column " + channel.column + ": " +
                             counted(spells.samples, "sample") + " " + where + " up to " +
                             std::to_string(spells.longest) + " at a time, while " + spells.evidence + " changes" +
                             remedy});
  }

  void check_current() {
    const std::vector<double>& current = recording_.valve_current_A;
    const double limit = joint_.actuator.valve_current_max_A;
    Places places;
    for (std::size_t i = 0; i < current.size(); ++i) {
      if (std::abs(current[i]) >= (1.0 - 1e-6) * limit && std::abs(current[i]) <= 20.0 * limit) {
        places.add(line(i));
      }
    }
    if (static_cast<double>(places.count()) > kCurrentShare * static_cast<double>(current.size())) {
      findings_.push_back({"saturated", places.first(),
                           "column valve_current_A: " + counted(places.count(), "sample") + " of " +
                               std::to_string(current.size()) + " at the limit of " + rounded(limit) +
                               " A; record with smaller commands"});
    }
  }

  const Recording& recording_;
  const robot::Joint& joint_;
  std::vector<SensorChannel> channels_;
  std::size_t velocity_ = static_cast<std::size_t>(-1);  ///< none
  std::size_t force_ = 0;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> check_sensors(const Recording& recording, const robot::Joint& joint) {
  return recording.position.empty() ? std::vector<Finding>{} : SensorCheck(recording, joint).check();
}

}  // namespace farrier::diagnosis
