#include "diagnosis/model/electric_response.hpp"

#include <cmath>

#include "diagnosis/model/delayed_command.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kSettle_s = 1.0;

class Simulation {
 public:
  Simulation(const WholeElectricJoint& joint, double period_s)
      : n_(joint.drive),
        load_(joint.load),
        terms_(joint.terms),
        friction_(joint.drive.gear_friction),
        hold_(joint.hold),
        middle_(joint.middle),
        period_s_(period_s),
        h_(period_s / kWholeSubsteps),
        gear_slope_(gear_slope(n_, h_)),
        x_(joint.middle) {
    if (n_.lag_s > 0.0) {
      const double share = h_ / n_.lag_s;
      keep_ = std::exp(-share);
      mean_keep_ = (1.0 - keep_) / share;
    }
  }

  /// Readings now. Call once per period.
  plant::JointReadings read() {
    plant::ForceMoment<double> sensor{sensed_torque()};
    terms_.on_force(sensor);
    return {x_, terms_.on_velocity(v_), sensor.force};
  }

  /// Advances by a period under `current_A` beside the hold, which has the readings.
  void advance(double current_A, const plant::JointReadings& read) {
    const double held_Nm = -hold_.stiffness * (read.position - middle_) - hold_.damping * read.velocity;
    commands_A_.push_back(current_A + held_Nm / n_.reading_Nm_A);
    integral_.push_back(integral_.back() + period_s_ * commands_A_.back());
    const DelayedCommand<double> command({commands_A_, integral_, period_s_}, terms_);
    for (std::size_t j = 0; j < kWholeSubsteps; ++j) {
      substep(admitted(n_, command.mean(commands_A_.size() - 1, j, kWholeSubsteps), v_));
    }
  }

 private:
  double sensed_torque() const {
    return n_.rigid             ? n_.reading_Nm_A * current_A_
           : touches(n_, bent_) ? spring_torque(n_, bent_) + n_.relaxation * (rotor_ - v_)
                                : 0.0;
  }

  /// Mean of the lagged command over a substep.
  double lagged(double command_A) {
    const double off = lagged_A_ - command_A;
    lagged_A_ = command_A + keep_ * off;
    return command_A + mean_keep_ * off;
  }

  void substep(double command_A) {
    const double mean_A = lagged(command_A);
    plant::LoadMoment<double> load{
        x_ + 0.5 * h_ * v_, v_, load_.mass, load_.damping, load_.stiffness, load_.slack_position, 0.0, 0.0, 0.0};
    terms_.on_load(load);
    if (n_.hangs) {
      load.external_force -= n_.moment * std::sin(load.position - n_.hanging_rad);
    }
    n_.rigid && !n_.elastic ? move_as_one(load, mean_A) : move_apart(load, mean_A);
    if (n_.rigid) {
      current_A_ = lagged_A_;
    }
  }

  void move_as_one(plant::LoadMoment<double>& load, double mean_A) {
    const GearStep<double> dry = dry_step(n_, v_);
    load.mass += n_.rotor;
    load.damping += n_.damping + dry.slope;
    load.hold += dry.base;
    const double torque = n_.constant * mean_A + n_.cogging_torque(load.position);
    const double mean = mean_speed(load, x_, v_, torque, h_);
    terms_.after_load(mean);
    x_ += h_ * mean;
    v_ += 2.0 * (mean - v_);
    rotor_ = v_;
  }

  void move_apart(const plant::LoadMoment<double>& load, double mean_A) {
    // Mean current i = alpha - beta w of a winding: (2 L / h) (i - i_0) = R (u - i) - N K w.
    const double inertia = n_.rigid ? 0.0 : 2.0 / h_ * n_.inductance;
    const double per_volt = n_.rigid ? 0.0 : 1.0 / (inertia + n_.resistance);
    const double alpha = n_.rigid ? mean_A : per_volt * (inertia * current_A_ + n_.resistance * mean_A);
    const double beta = per_volt * n_.constant;
    const GearStep<double> dry = dry_step(n_, rotor_);
    const double mass = 2.0 / h_ * n_.rotor;
    RotorStep<double> rotor{mass * rotor_ + n_.constant * alpha + n_.cogging_torque(load.position + bent_) - dry.base,
                            mass + n_.constant * beta + n_.damping + dry.slope};
    if (friction_) {
      plant::LoadMoment<double> contact{};
      contact.velocity = rotor_;
      friction_->on_load(contact);
      rotor.push -= contact.hold;
      rotor.resists += contact.slope;
    }
    const GearStep<double> gear = gear_step(n_, bent_, rotor_ - v_, h_, gear_slope_);
    const auto [rotor_mean, mean] = mean_speeds(load, rotor, gear, x_, v_, h_);
    terms_.after_load(mean);
    if (friction_) {
      friction_->after_load(rotor_mean);
    }
    current_A_ = 2.0 * (alpha - beta * rotor_mean) - current_A_;
    x_ += h_ * mean;
    v_ += 2.0 * (mean - v_);
    rotor_ += 2.0 * (rotor_mean - rotor_);
    bent_ += h_ * (rotor_mean - mean);
  }

  const DriveNumbers<double>& n_;
  const LoadNumbers<double>& load_;
  plant::TermSet<double> terms_;
  std::optional<plant::LoadFriction<double>> friction_;
  Hold hold_;
  double middle_, period_s_, h_, gear_slope_;
  double keep_ = 0.0, mean_keep_ = 0.0;  ///< of the lag: after a substep, and on its mean
  std::vector<double> commands_A_, integral_{0.0};
  double x_, v_ = 0.0, rotor_ = 0.0, bent_ = 0.0, current_A_ = 0.0, lagged_A_ = 0.0;
};

}  // namespace

std::vector<plant::JointReadings> electric_response(const WholeElectricJoint& joint, std::span<const double> current_A,
                                                    double period_s) {
  Simulation simulation(joint, period_s);
  for (int left = static_cast<int>(std::lround(kSettle_s / period_s)); left > 0; --left) {
    simulation.advance(0.0, simulation.read());
  }
  std::vector<plant::JointReadings> readings;
  readings.reserve(current_A.size());
  for (const double command_A : current_A) {
    readings.push_back(simulation.read());
    simulation.advance(command_A, readings.back());
  }
  return readings;
}

}  // namespace farrier::diagnosis
