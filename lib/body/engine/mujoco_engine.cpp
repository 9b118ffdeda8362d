// The one source that knows MuJoCo (2.2.2, Debian's libmujoco-dev).

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "body/engine/bound_calls.hpp"
#include "body/engine/engine.hpp"
#include "body/engine/mjcf.hpp"

namespace farrier::body {
namespace engine {

struct Delete {
  void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
  void operator()(mjData* data) const noexcept { mj_deleteData(data); }
};
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ModelPointer = std::unique_ptr<mjModel, Delete>;
using DataPointer = std::unique_ptr<mjData, Delete>;

}  // namespace engine

namespace {

using engine::DataPointer;
using engine::ModelPointer;
using engine::RowMajor;

constexpr double kLargestStep_s = 0.01;
constexpr int kPositionsOfTheTrunk = 7;

using Matrix3Row = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// MuJoCo counts warnings, which step() reads. By itself it would write them to a file in the working directory.
void ignore_warning(const char*) {}

// MuJoCo calls this where it cannot go on, such as without memory; it must not return.
[[noreturn]] void end_on_error(const char* message) {
  std::fprintf(stderr, "MuJoCo: %s\n", message);
  std::abort();
}

// Set for the whole process, once.
const Result<Done>& prepare_mujoco() {
  static const Result<Done> prepared = [] {
    mju_user_warning = &ignore_warning;
    mju_user_error = &end_on_error;
    return bind_own_math(reinterpret_cast<const void*>(&mj_step));
  }();
  return prepared;
}

Result<Done> check_version() {
  if (mj_version() != mjVERSION_HEADER) {
    return Error{"libmujoco.so has version " + std::to_string(mj_version()) + ", but this program was built for " +
                 std::to_string(mjVERSION_HEADER) + ": build it again"};
  }
  return Done{};
}

Result<ModelPointer> load(const std::string& mjcf) {
  constexpr const char* kName = "body.xml";
  const auto files = std::make_unique<mjVFS>();  // megabytes: not for the stack
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(mjcf.size())) != 0) {
    return Error{"MuJoCo takes no model of " + std::to_string(mjcf.size()) + " bytes"};
  }
  std::memcpy(files->filedata[0], mjcf.data(), mjcf.size());
  char reason[1000] = "";
  ModelPointer model(mj_loadXML(kName, files.get(), reason, sizeof reason));
  mj_deleteFileVFS(files.get(), kName);
  if (model == nullptr) {
    return Error{std::string("MuJoCo refuses the body or the scene: ") + reason};
  }
  return model;
}

constexpr std::array kFaults{std::pair(mjWARN_INERTIA, EngineFault::kSingularInertia),
                             std::pair(mjWARN_CONTACTFULL, EngineFault::kTooManyContacts),
                             std::pair(mjWARN_CNSTRFULL, EngineFault::kTooManyConstraints),
                             std::pair(mjWARN_BADQPOS, EngineFault::kPositionNotFinite),
                             std::pair(mjWARN_BADQVEL, EngineFault::kVelocityNotFinite),
                             std::pair(mjWARN_BADQACC, EngineFault::kAccelerationNotFinite)};

EngineFault fault_of(int warning) noexcept {
  const auto found =
      std::ranges::find(kFaults, warning, [](const auto& fault) { return static_cast<int>(fault.first); });
  return found == kFaults.end() ? EngineFault::kOther : found->second;
}

}  // namespace

struct Engine::Simulation {
  ModelPointer model;
  DataPointer data;
  DataPointer scratch;  // for constants of the model, which are computed in its reference pose
  int legs = 0;
  int trunk = 0;  // its body
  std::array<int, kMaxLegs> foot_geom{};
  std::array<int, kMaxLegs> foot_site{};
  std::array<Eigen::Vector3d, kMaxLegs> contact_force_N;
  std::int64_t steps = 0;
  std::optional<EngineFailure> failure;
  Eigen::VectorXd position_before;  // of the present step
  Eigen::VectorXd velocity_before;
  RowMajor jacobian;  // workspaces of dynamics()
  RowMajor mass_matrix;

  int joints() const noexcept { return kJointsPerLeg * legs; }
  void write(const BodyState& state) noexcept;  // into data as it is
  void set_trunk(const RigidInertia& inertia) noexcept;
  void step() noexcept;
  void note_failure() noexcept;
  void sum_contact_forces() noexcept;
};

void Engine::Simulation::write(const BodyState& state) noexcept {
  Eigen::Map<Eigen::VectorXd> q(data->qpos, model->nq);
  q.head<3>() = state.position_m;
  q.segment<4>(3) << state.attitude.w(), state.attitude.x(), state.attitude.y(), state.attitude.z();
  q.tail(joints()) = state.angles_rad;
  Eigen::Map<Eigen::VectorXd>(data->qvel, model->nv) = state.velocity();
}

void Engine::Simulation::set_trunk(const RigidInertia& inertia) noexcept {
  const PrincipalInertia principal = principal_inertia(inertia.tensor_kg_m2);
  const Eigen::Quaterniond& q = principal.attitude;
  Eigen::Map<Eigen::Vector3d>(model->body_inertia + 3 * trunk) = principal.moments_kg_m2;
  Eigen::Map<Eigen::Vector4d>(model->body_iquat + 4 * trunk) << q.w(), q.x(), q.y(), q.z();
  Eigen::Map<Eigen::Vector3d>(model->body_ipos + 3 * trunk) = inertia.com_m;
  model->body_mass[trunk] = inertia.mass_kg;
  model->body_sameframe[trunk] = 0;
  mj_setConst(model.get(), scratch.get());
}

void Engine::Simulation::note_failure() noexcept {
  for (int warning = 0; warning < mjNWARNING && !failure; ++warning) {
    if (data->warning[warning].number > 0) {
      failure = EngineFailure{fault_of(warning), steps};
    }
  }
}

// A step with a warning may have reset the state.
void Engine::Simulation::step() noexcept {
  Eigen::Map<Eigen::VectorXd> position(data->qpos, model->nq);
  Eigen::Map<Eigen::VectorXd> velocity(data->qvel, model->nv);
  position_before = position;
  velocity_before = velocity;
  mj_step(model.get(), data.get());
  note_failure();
  if (failure) {
    position = position_before;
    velocity = velocity_before;
    return;
  }
  sum_contact_forces();
  ++steps;
}

// The force in a contact's frame acts on its second geom, an opposite one on the first.
void Engine::Simulation::sum_contact_forces() noexcept {
  std::fill(contact_force_N.begin(), contact_force_N.end(), Eigen::Vector3d::Zero());
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    for (int leg = 0; leg < legs; ++leg) {
      const bool second = contact.geom2 == foot_geom[leg];
      if (!second && contact.geom1 != foot_geom[leg]) {
        continue;
      }
      double in_frame[6];
      mj_contactForce(model.get(), data.get(), i, in_frame);
      const Eigen::Map<const Matrix3Row> frame(contact.frame);
      const Eigen::Vector3d force_N = frame.transpose() * Eigen::Map<const Eigen::Vector3d>(in_frame);
      contact_force_N[leg] += second ? force_N : -force_N;
    }
  }
}

Engine::Engine(std::unique_ptr<Simulation> simulation) noexcept : simulation_(std::move(simulation)) {}
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;
Engine::~Engine() = default;

Result<Engine> Engine::create(const BodyModel& model, const Scene& scene, const EngineSettings& settings) {
  FARRIER_TRY(validate(model));
  FARRIER_TRY(validate(scene));
  if (!(settings.step_s > 0.0 && settings.step_s <= kLargestStep_s)) {
    return Error{"the engine's step is out of range: give a time above 0, up to 0.01 s"};
  }
  FARRIER_TRY(check_version());
  FARRIER_TRY(prepare_mujoco());
  auto simulation = std::make_unique<Simulation>();
  Simulation& s = *simulation;
  s.model = FARRIER_TRY(load(mjcf_text(model, scene, settings.step_s)));
  s.data.reset(mj_makeData(s.model.get()));
  s.scratch.reset(mj_makeData(s.model.get()));
  s.legs = static_cast<int>(model.legs.size());
  s.trunk = mj_name2id(s.model.get(), mjOBJ_BODY, "trunk");
  for (std::size_t leg = 0; leg < model.legs.size(); ++leg) {
    const std::string foot = std::to_string(leg) + "/foot";
    s.foot_geom[leg] = mj_name2id(s.model.get(), mjOBJ_GEOM, foot.c_str());
    s.foot_site[leg] = mj_name2id(s.model.get(), mjOBJ_SITE, foot.c_str());
  }
  s.position_before.resize(s.model->nq);
  s.velocity_before.resize(s.model->nv);
  s.jacobian.resize(3, s.model->nv);
  s.mass_matrix.resize(s.model->nv, s.model->nv);
  Engine engine(std::move(simulation));
  engine.set_state(BodyState::zero(model.joints()));
  return engine;
}

void Engine::set_state(const BodyState& state) noexcept {
  mj_resetData(simulation_->model.get(), simulation_->data.get());
  simulation_->write(state);
  simulation_->steps = 0;
  simulation_->failure.reset();
  std::fill(simulation_->contact_force_N.begin(), simulation_->contact_force_N.end(), Eigen::Vector3d::Zero());
}

void Engine::set_trunk(const RigidInertia& trunk) noexcept { simulation_->set_trunk(trunk); }

void Engine::step(const JointVector& torques_Nm, const TrunkWrench& wrench) noexcept {
  Simulation& s = *simulation_;
  if (s.failure) {
    return;
  }
  Eigen::Map<Eigen::VectorXd>(s.data->qfrc_applied, s.model->nv).tail(s.joints()) = torques_Nm;
  Eigen::Map<Eigen::Vector3d>(s.data->xfrc_applied + 6 * s.trunk) = wrench.force_N;
  Eigen::Map<Eigen::Vector3d>(s.data->xfrc_applied + 6 * s.trunk + 3) = wrench.torque_Nm;
  s.step();
}

void Engine::bare_steps(const JointVector& torques_Nm, int steps) noexcept {
  Simulation& s = *simulation_;
  Eigen::Map<Eigen::VectorXd>(s.data->qfrc_applied, s.model->nv).tail(s.joints()) = torques_Nm;
  for (int step = 0; step < steps; ++step) {
    mj_step(s.model.get(), s.data.get());
  }
}

BodyState Engine::state() const noexcept {
  const Simulation& s = *simulation_;
  BodyState state;
  const double* q = s.data->qpos;
  state.position_m = Eigen::Map<const Eigen::Vector3d>(q);
  state.attitude = Eigen::Quaterniond(q[3], q[4], q[5], q[6]);
  state.angles_rad = Eigen::Map<const Eigen::VectorXd>(q + kPositionsOfTheTrunk, s.joints());
  state.linear_velocity_m_s = Eigen::Map<const Eigen::Vector3d>(s.data->qvel);
  state.angular_velocity_rad_s = Eigen::Map<const Eigen::Vector3d>(s.data->qvel + 3);
  state.velocities_rad_s = Eigen::Map<const Eigen::VectorXd>(s.data->qvel + kTrunkVelocities, s.joints());
  return state;
}

Eigen::Vector3d Engine::contact_force_N(int leg) const noexcept { return simulation_->contact_force_N[leg]; }
std::int64_t Engine::steps() const noexcept { return simulation_->steps; }
const std::optional<EngineFailure>& Engine::failure() const noexcept { return simulation_->failure; }

EngineDynamics Engine::dynamics(const BodyState& state) noexcept {
  Simulation& s = *simulation_;
  const mjModel* m = s.model.get();
  mjData* d = s.data.get();
  s.write(state);
  mju_zero(d->xfrc_applied, 6 * m->nbody);
  mju_zero(d->qacc, m->nv);
  d->ncon = 0;
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_crb(m, d);
  mj_comVel(m, d);
  mj_rne(m, d, 0, d->qfrc_bias);
  EngineDynamics dynamics;
  mj_fullM(m, s.mass_matrix.data(), d->qM);
  dynamics.mass_matrix = s.mass_matrix;
  dynamics.bias_forces = Eigen::Map<const Eigen::VectorXd>(d->qfrc_bias, m->nv);
  for (int leg = 0; leg < s.legs; ++leg) {
    dynamics.foot_position_m[leg] = Eigen::Map<const Eigen::Vector3d>(d->site_xpos + 3 * s.foot_site[leg]);
    mj_jacSite(m, d, s.jacobian.data(), nullptr, s.foot_site[leg]);
    dynamics.foot_jacobian[leg] = s.jacobian;
  }
  // Acceleration of the feet while v' = 0. MuJoCo gives that of a body which falls freely as zero.
  mj_rnePostConstraint(m, d);
  for (int leg = 0; leg < s.legs; ++leg) {
    double acceleration[6];
    mj_objectAcceleration(m, d, mjOBJ_SITE, s.foot_site[leg], acceleration, 0);
    dynamics.foot_bias_acceleration_m_s2[leg] =
        Eigen::Map<const Eigen::Vector3d>(acceleration + 3) + Eigen::Map<const Eigen::Vector3d>(m->opt.gravity);
  }
  return dynamics;
}

}  // namespace farrier::body
