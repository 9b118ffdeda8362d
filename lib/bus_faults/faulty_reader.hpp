#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "bus/bus.hpp"
#include "bus/key.hpp"
#include "bus/said_once.hpp"
#include "bus_faults/arrow_fault.hpp"
#include "bus_faults/due_times.hpp"
#include "core/noise.hpp"
#include "signals/tick_of.hpp"

namespace farrier::bus_faults {

/// A reader whose samples meet faults on their way. Each fault sees what those before it in the list have let through.
template <class Signal>
class FaultyReader final : public bus::RawReader {
 public:
  /// `due`, `newest` and `begun` outlive this. `newest`: the newest tick that the process has received, used as the
  /// tick of orders. `begun` receives each fault when it first acts.
  FaultyReader(std::unique_ptr<bus::RawReader> inner, const std::vector<ArrowFault>& faults, std::uint64_t seed,
               const std::string& name, const Clock& clock, DueTimes& due,
               std::atomic<Tick>& newest, bus::SaidOnce& begun)
      : inner_(std::move(inner)), clock_(clock), due_(due), newest_(newest) {
    for (const ArrowFault& fault : faults) {
      faults_.emplace_back(fault, NoiseStream(seed, name, to_string(fault)), begun);
    }
  }

  std::size_t take(void* signals, std::size_t capacity) noexcept override {
    const SteadyTime now = clock_.now();
    std::array<Signal, 8> batch;
    for (std::size_t count = batch.size(); count == batch.size();) {
      count = inner_->take(batch.data(), batch.size());
      for (std::size_t i = 0; i < count; ++i) {
        pass(batch[i], now);
      }
    }
    auto* out = static_cast<Signal*>(signals);
    std::size_t handed = 0;
    while (handed < capacity && !on_the_way_.empty() && on_the_way_.begin()->first <= now) {
      out[handed++] = on_the_way_.begin()->second;
      on_the_way_.erase(on_the_way_.begin());
    }
    return handed;
  }

  bus::ReaderStatus status() const noexcept override { return inner_->status(); }

 private:
  struct Acting {
    Acting(const ArrowFault& of, const NoiseStream& stream, bus::SaidOnce& begun_faults)
        : fault(of), draws(stream), begun(begun_faults) {}

    bool concerns(const Signal& signal, Tick tick) const noexcept {
      return tick >= fault.from && tick < fault.until && (!fault.key || *fault.key == bus::key_of(signal));
    }
    bool happens() { return draws.uniform(drawn++) < fault.probability && acts(); }
    bool acts() {
      if (!acted) {
        acted = true;
        begun.add(to_string(fault));
      }
      return true;
    }

    ArrowFault fault;
    NoiseStream draws;
    bus::SaidOnce& begun;
    bool acted = false;
    Tick drawn = 0;
    std::map<std::uint32_t, int> burst_left;      ///< by key
    std::map<std::uint32_t, Signal> held, frozen; ///< by key
  };

  void pass(Signal signal, SteadyTime now) {
    if (signals::tick_of(signal) == kNoTick) {
      on_the_way_.emplace(now, signal);
      return;
    }
    if constexpr (!signals::kIsOrder<Signal>) {
      newest_ = std::max(newest_.load(), signals::tick_of(signal));
    }
    const Tick tick = signals::kIsOrder<Signal> ? newest_.load() : signals::tick_of(signal);
    SteadyTime due = now;
    int copies = 1;
    for (Acting& acting : faults_) {
      if (acting.concerns(signal, tick) && !survives(acting, signal, due, copies)) {
        return;
      }
    }
    for (; copies > 0; --copies) {
      send(signal, due, now);
    }
    // Samples that were kept back to come later than their successor.
    for (Acting& acting : faults_) {
      if (const auto held = acting.held.extract(bus::key_of(signal))) {
        send(held.mapped(), due, now);
      }
    }
  }

  void send(const Signal& signal, SteadyTime due, SteadyTime now) {
    on_the_way_.emplace(due, signal);
    if (due > now) {
      due_.add(due);
    }
  }

  /// Applies the fault to a sample. Returns false if the sample does not go on now.
  static bool survives(Acting& acting, Signal& signal, SteadyTime& due, int& copies) {
    const ArrowFault& fault = acting.fault;
    const std::uint32_t key = bus::key_of(signal);
    switch (fault.kind) {
      case Kind::kLoss:
        return !acting.happens();
      case Kind::kBurst: {
        int& left = acting.burst_left[key];
        left = left > 0 ? left : acting.happens() ? fault.length : 0;
        return left-- <= 0;
      }
      case Kind::kDuplicate:
        copies += acting.happens() ? 1 : 0;
        return true;
      case Kind::kReorder:
        if (acting.happens() && !acting.held.contains(key)) {
          acting.held.emplace(key, signal);
          return false;
        }
        return true;
      case Kind::kDelay: {
        acting.acts();
        const double share = acting.draws.uniform(acting.drawn++);
        due += fault.least + std::chrono::duration_cast<Nanoseconds>(share * (fault.most - fault.least));
        return true;
      }
      case Kind::kCut:
        acting.acts();
        return false;
      case Kind::kFrozen: {
        acting.acts();
        const Signal& first = acting.frozen.try_emplace(key, signal).first->second;
        for_each_number(signal, [&](std::string_view name, double& number) { number = number_of(first, name); });
        return true;
      }
      case Kind::kNoise:
      case Kind::kOffset:
      case Kind::kNotANumber:
        for_each_number(signal, [&](std::string_view name, double& number) {
          if (name == fault.field) {
            acting.acts();
            number = fault.kind == Kind::kOffset  ? number + fault.amount
                     : fault.kind == Kind::kNoise ? number + fault.amount * acting.draws.normal(acting.drawn++)
                                                  : std::numeric_limits<double>::quiet_NaN();
          }
        });
        return true;
    }
    return true;
  }

  template <class Use>
  static void for_each_number(Signal& signal, Use&& use) {
    signals::visit_fields(signal, [&](const char* name, auto& field) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, double>) {
        use(name, field);
      }
    });
  }
  static double number_of(const Signal& signal, std::string_view wanted) {
    double found = 0.0;
    signals::visit_fields(signal, [&](const char* name, const auto& field) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, double>) {
        found = name == wanted ? field : found;
      }
    });
    return found;
  }

  std::unique_ptr<bus::RawReader> inner_;
  Clock clock_;
  DueTimes& due_;
  std::atomic<Tick>& newest_;
  std::vector<Acting> faults_;
  std::multimap<SteadyTime, Signal> on_the_way_;  ///< by when it comes
};

}  // namespace farrier::bus_faults
