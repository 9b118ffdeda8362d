#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "core/noise.hpp"
#include "trials/blind/blind_trials.hpp"
#include "trials/truth/electric_truth.hpp"

namespace farrier::blind {
namespace {

constexpr int kNone = 60;
constexpr std::array<int, 4> kSets{60, 40, 24, 12};  // of two, three, four and five effects
constexpr int kOutside = 36;
// Trials of each electric joint.
constexpr int kElectricNone = 24;
constexpr std::array<int, 3> kElectricSets{12, 8, 4};  // of two, three and four effects

/// Different effects of medium or large size.
std::vector<truth::Hidden> drawn_set(const std::vector<std::string>& known, std::size_t size, std::uint64_t seed) {
  const NoiseStream draw(seed, "blind trials", "set");
  std::vector<truth::Hidden> hidden;
  for (Tick number = 0; hidden.size() < size; number += 2) {
    const auto index = static_cast<std::size_t>(draw.uniform(number) * static_cast<double>(known.size()));
    if (std::ranges::find(hidden, known[index], &truth::Hidden::name) == hidden.end()) {
      hidden.push_back({known[index], draw.uniform(number + 1) < 0.5 ? 1 : 2});
    }
  }
  return hidden;
}

}  // namespace

std::vector<TrialPlan> all_trials(std::size_t joints, std::uint64_t seed) {
  std::vector<TrialPlan> plans;
  const auto add = [&](Kind kind, std::vector<truth::Hidden> hidden, int excitation) {
    plans.push_back({kind,
                     plans.size() % joints,
                     {seed + plans.size(), static_cast<truth::Excitation>(excitation), std::move(hidden)}});
  };
  const std::vector<std::string> known = truth::known_effects();
  const std::vector<std::string> outside = truth::outside_effects();
  for (const std::string& name : known) {
    for (int magnitude = 0; magnitude < 3; ++magnitude) {
      for (int excitation = 0; excitation < 3; ++excitation) {
        add(Kind::kEffect, {{name, magnitude}}, excitation);
      }
    }
  }
  for (int i = 0; i < kNone; ++i) {
    add(Kind::kNone, {}, i % 3);
  }
  for (std::size_t more = 0; more < kSets.size(); ++more) {
    for (int i = 0; i < kSets[more]; ++i) {
      add(Kind::kSet, drawn_set(known, more + 2, seed + plans.size()), i % 3);
    }
  }
  for (int i = 0; i < kOutside; ++i) {
    const auto n = static_cast<std::size_t>(i);
    add(Kind::kOutside, {{outside[n % outside.size()], 1 + (i / static_cast<int>(outside.size())) % 2}}, i % 3);
  }
  return plans;
}

std::vector<TrialPlan> all_electric_trials(const std::vector<const robot::Joint*>& joints, std::uint64_t seed) {
  std::vector<TrialPlan> plans;
  const auto add = [&](Kind kind, std::size_t joint, std::vector<truth::Hidden> hidden, int excitation) {
    plans.push_back(
        {kind, joint, {seed + plans.size(), static_cast<truth::Excitation>(excitation), std::move(hidden)}});
  };
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const std::vector<std::string> known = truth::known_electric_effects(*joints[joint]);
    for (const std::string& name : known) {
      for (int magnitude = 0; magnitude < 3; ++magnitude) {
        for (int excitation = 0; excitation < 3; ++excitation) {
          add(Kind::kEffect, joint, {{name, magnitude}}, excitation);
        }
      }
    }
    for (int i = 0; i < kElectricNone; ++i) {
      add(Kind::kNone, joint, {}, i % 3);
    }
    for (std::size_t more = 0; more < kElectricSets.size(); ++more) {
      for (int i = 0; i < kElectricSets[more]; ++i) {
        add(Kind::kSet, joint, drawn_set(known, more + 2, seed + plans.size()), i % 3);
      }
    }
    const std::vector<std::string> outside = truth::outside_electric_effects();
    for (const std::string& name : outside) {
      for (int excitation = 0; excitation < 3; ++excitation) {
        add(Kind::kOutside, joint, {{name, 1 + excitation % 2}}, excitation);
      }
    }
  }
  return plans;
}

std::vector<TrialPlan> healthy_trials(std::size_t joints, std::size_t robots, std::uint64_t seed) {
  std::vector<TrialPlan> plans;
  for (std::size_t robot = 0; robot < robots; ++robot) {
    for (std::size_t joint = 0; joint < joints; ++joint) {
      plans.push_back(
          {Kind::kNone, joint, {(seed + robot) * joints + joint, static_cast<truth::Excitation>(robot % 3), {}}});
    }
  }
  return plans;
}

std::vector<TrialPlan> mixed(const std::vector<TrialPlan>& all, int count) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Multiples of the golden ratio, less their whole parts, lie evenly however many there are.
  const auto place = [](std::size_t i) {
    const double turns = std::numbers::phi * static_cast<double>(i);
    return turns - std::floor(turns);
  };
  std::ranges::sort(order, {}, place);
  if (count > 0 && static_cast<std::size_t>(count) < order.size()) {
    order.resize(static_cast<std::size_t>(count));
  }
  std::vector<TrialPlan> some;
  std::ranges::transform(order, std::back_inserter(some), [&](std::size_t i) { return all[i]; });
  return some;
}

}  // namespace farrier::blind
