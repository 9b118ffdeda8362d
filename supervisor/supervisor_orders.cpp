// Lets a supervisor follow another and continue from its state.

#include <algorithm>

#include "supervisor/supervisor.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::supervisor {
namespace {

std::size_t place_of(const signals::JointControllerGains& gains) noexcept {
  return gains.joint * kPhases.size() + static_cast<std::size_t>(gains.phase);
}

}  // namespace

void Supervisor::Outputs::clear() noexcept {
  gains.clear();
  modes.clear();
  decisions.clear();
  design_statuses.clear();
}

void Supervisor::remember(const Outputs& issued) noexcept {
  for (const signals::JointControllerGains& gains : issued.gains) {
    known_gains_[place_of(gains)] = gains;
  }
  if (!issued.modes.empty()) {
    known_mode_ = issued.modes.back();
  }
}

void Supervisor::mirror(const signals::JointControllerGains& gains) noexcept {
  if (!known(gains.phase) || place_of(gains) >= known_gains_.size()) {
    return;
  }
  known_gains_[place_of(gains)] = gains;
  if (gains.joint >= joints_.size()) {
    return;  // not adaptive: no redesign continues from them
  }
  JointSlots& joint = joints_[gains.joint];
  joint.generations[gains.phase] = gains.generation;
  joint.newest_generation = std::max(joint.newest_generation, gains.generation);
  joint.slots[gains.phase].adopt(wire_gains::unpack_gains(gains));
  if (joint.physics) {
    (*joint.physics)[gains.phase].adopt(plant::physics_of(gains.physics), wire_gains::unpack_gains(gains).model);
  } else {
    joint.dwell_ticks = dwell_ticks(joint.slots[0].gains(), joint.slots[1].gains());
  }
  joint.last_issue = gains.effective_tick - lead_ticks_;
}

void Supervisor::mirror(const signals::SystemMode& mode) noexcept {
  if (mode.session == session_ && mode.epoch >= known_mode_.epoch) {
    known_mode_ = mode;
    epoch_ = mode.epoch;
  }
}

void Supervisor::take_over(std::uint32_t authority, std::uint32_t mode_epoch, Tick tick) noexcept {
  authority_ = authority;
  epoch_ = std::max(mode_epoch, known_mode_.epoch);
  while (next_batch_ < batches_.size() && (next_batch_ == 0 || batches_[next_batch_].tick <= tick)) {
    ++next_batch_;
  }
  for (std::size_t i = 0; i < joints_.size() * kPhases.size(); ++i) {
    if (known_gains_[i].generation == 0) {
      JointSlots& joint = joints_[i / kPhases.size()];
      joint.slots[i % kPhases.size()].doubt();
      if (joint.physics) {
        (*joint.physics)[i % kPhases.size()].doubt();
      }
    }
  }
}

void Supervisor::stand_down() noexcept {
  std::ranges::fill(known_gains_, signals::JointControllerGains{});
  known_mode_ = {};
  pending_.clear();
  issued_.clear();
}

const Supervisor::Outputs& Supervisor::orders() noexcept {
  orders_.clear();
  for (signals::JointControllerGains gains : known_gains_) {
    if (gains.generation != 0) {
      gains.authority = authority_;
      orders_.gains.push_back(gains);
    }
  }
  if (known_mode_.epoch != 0) {
    orders_.modes.push_back(known_mode_);
    orders_.modes.back().authority = authority_;
  }
  return orders_;
}

}  // namespace farrier::supervisor
