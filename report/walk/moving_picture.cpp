#include "report/walk/moving_picture.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "body/dynamics/rigid_body.hpp"
#include "body/model/trunk_shape.hpp"
#include "report/figures/text_format.hpp"
#include "report/page/html_tables.hpp"
#include "report/page/svg_animation.hpp"
#include "report/walk/moving_strips.hpp"

namespace farrier::report {
namespace moving_picture_parts {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFrames_Hz = 20.0;
constexpr double kWidth_px = 860.0, kHeight_px = 400.0, kStage_px = 540.0;
constexpr double kPerMetre_px = 265.0;
constexpr double kSquare_m = 0.5;   // of the ground
constexpr double kAround_m = 2.0;   // ground beyond the robot's way
constexpr double kWeight_m = 0.55;  // length of the arrow of the robot's weight
constexpr double kLeg_px = 11.0, kHead_px = 7.0;
const Vector3d kToEye = Vector3d(0.5, -1.75, 0.6).normalized();

constexpr const char* kStyle =
    "<style>text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#333}.faint{fill:#5c6770}.title{font-size:16px;"
    "font-weight:600;fill:#1c2226}.leg{fill:none;stroke-linejoin:round;stroke-linecap:round;"
    "marker-mid:url(#joint)}</style><defs><marker id=\"joint\" markerWidth=\"2\" markerHeight=\"2\" refX=\"1\" "
    "refY=\"1\">"
    "<circle cx=\"1\" cy=\"1\" r=\"0.8\" fill=\"#3d464d\"/></marker></defs>\n";

/// A camera without perspective that looks at a point of the ground. Moving along is a translation of its picture.
struct Camera {
  Vector3d right = Vector3d::UnitZ().cross(kToEye).normalized();
  Vector3d up = kToEye.cross(right);

  Vector2d project(const Vector3d& point_m) const {
    return kPerMetre_px * Vector2d(right.dot(point_m), -up.dot(point_m));
  }
};

/// The robot at one frame, in the world.
struct Moment {
  Vector3d trunk_m;
  Eigen::Quaterniond attitude;
  std::vector<std::array<Vector3d, 4>> legs;  ///< hinges and foot
  std::vector<Vector3d> forces_N;
  std::vector<bool> stands;
};

std::vector<Moment> moments_of(const WalkRun& run, body::RigidBody& body) {
  const double from_s = run.shown_from_s(kMovingPicture_s);
  std::vector<Moment> moments;
  std::vector<trace::TraceRow> joints(run.robot.joints.size());
  auto state = body::BodyState::zero(body.joints());
  const auto shown = run.shown_joints(kMovingPicture_s);
  auto next = shown.begin();
  for (const signals::BodyTruth& truth : run.truth) {
    const double wanted_s = from_s + static_cast<double>(moments.size()) / kFrames_Hz;
    if (run.time_s(truth.tick) + 0.5 * run.plan.period_s < wanted_s || wanted_s > from_s + kMovingPicture_s + 1e-9) {
      continue;
    }
    for (; next != shown.end() && next->tick <= truth.tick; ++next) {
      joints[next->joint] = *next;
    }
    for (const robot::Joint& joint : run.robot.joints) {
      state.angles_rad[joint.number] = joint.linkage.angle(joints[joint.number].position_m_or_rad);
    }
    Moment moment;
    moment.trunk_m = state.position_m = Vector3d(truth.position_m.data());
    moment.attitude = state.attitude = {truth.attitude[0], truth.attitude[1], truth.attitude[2], truth.attitude[3]};
    body.set_state(state);
    for (int leg = 0; leg < body.legs(); ++leg) {
      moment.legs.push_back({body.hinge_position_m(leg, 0), body.hinge_position_m(leg, 1),
                             body.hinge_position_m(leg, 2), body.foot_position_m(leg)});
      moment.forces_N.emplace_back(truth.foot_force_N.data() + 3 * leg);
      moment.stands.push_back(false);
    }
    for (const trace::TraceRow& joint : joints) {
      moment.stands[static_cast<std::size_t>(run.robot.joints[joint.joint].leg)] = joint.actual_phase == Phase::kStance;
    }
    moments.push_back(std::move(moment));
  }
  return moments;
}

class Stage {
 public:
  Stage(const WalkRun& run, std::vector<Moment> moments) : run_(run), moments_(std::move(moments)) {}

  std::string text() const {
    std::string svg = "<svg x=\"0\" y=\"0\" width=\"" + svg_number(kStage_px) + "\" height=\"" +
                      svg_number(kHeight_px) + "\"><g transform=\"translate(" + svg_number(0.46 * kStage_px) +
                      ",322)\">\n" + ground() + shadow();
    std::vector<std::size_t> order(run_.robot.plan.legs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const Moment& first = moments_.front();
    const auto depth = [&](std::size_t leg) { return kToEye.dot(first.legs[leg][0] - first.trunk_m); };
    std::ranges::sort(order, {}, depth);
    for (const std::size_t leg : order) {
      svg += depth(leg) <= 0.0 ? leg_of(leg, "#9aa4ab") : "";
    }
    svg += trunk();
    for (const std::size_t leg : order) {
      svg += depth(leg) > 0.0 ? leg_of(leg, "#5c6770") : "";
    }
    return svg + "</g></svg>\n";
  }

 private:
  /// A list per frame; `of(moment)` gives it.
  template <class Of>
  std::vector<std::string> per_frame(Of&& of) const {
    std::vector<std::string> values;
    for (const Moment& moment : moments_) {
      values.push_back(of(moment));
    }
    return values;
  }

  /// In pixels from the middle of the stage, which follows the trunk over the ground.
  Vector2d place(const Vector3d& point_m, const Moment& moment) const {
    return camera_.project(point_m - on_ground(moment.trunk_m));
  }

  /// Below a point, on the plane of the ground through the origin.
  Vector3d on_ground(const Vector3d& point_m) const {
    const Vector3d& normal = run_.plan.normal;
    return {point_m.x(), point_m.y(), -(normal.x() * point_m.x() + normal.y() * point_m.y()) / normal.z()};
  }

  template <std::size_t kSize>
  std::string polygon(const std::string& attributes, const char* tag, auto&& points_of) const {
    const auto values = per_frame([&](const Moment& moment) {
      std::array<Vector2d, kSize> points;
      const std::array<Vector3d, kSize> corners = points_of(moment);
      std::ranges::transform(corners, points.begin(), [&](const Vector3d& corner) { return place(corner, moment); });
      return svg_points(points);
    });
    return std::string("<") + tag + " points=\"" + values.front() + "\" " + attributes + ">" +
           svg_animate("points", values, kMovingPicture_s) + "</" + tag + ">\n";
  }

  std::string ground() const {
    Eigen::AlignedBox2d way;
    for (const Moment& moment : moments_) {
      way.extend(moment.trunk_m.head<2>());
    }
    const Vector2d low = ((way.min().array() - kAround_m) / kSquare_m).floor() * kSquare_m;
    const Vector2d high = ((way.max().array() + kAround_m) / kSquare_m).ceil() * kSquare_m;
    std::string lines;
    const auto line = [&](const Vector2d& from, const Vector2d& to) {
      const Vector2d a = camera_.project(on_ground({from.x(), from.y(), 0.0}));
      const Vector2d b = camera_.project(on_ground({to.x(), to.y(), 0.0}));
      lines += "M" + svg_number(a.x()) + "," + svg_number(a.y()) + "L" + svg_number(b.x()) + "," + svg_number(b.y());
    };
    for (double x = low.x(); x <= high.x() + 1e-9; x += kSquare_m) {
      line({x, low.y()}, {x, high.y()});
    }
    for (double y = low.y(); y <= high.y() + 1e-9; y += kSquare_m) {
      line({low.x(), y}, {high.x(), y});
    }
    const auto values = per_frame([&](const Moment& moment) {
      const Vector2d shift = -camera_.project(on_ground(moment.trunk_m));
      return svg_number(shift.x()) + "," + svg_number(shift.y());
    });
    return "<g><path d=\"" + lines + "\" fill=\"none\" stroke=\"#d8dde1\" stroke-width=\"1\"/>" +
           svg_animate_translation(values, kMovingPicture_s) + "</g>\n";
  }

  std::array<Vector3d, 8> corners(const Moment& moment) const {
    std::array<Vector3d, 8> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vector3d sign((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
      all[i] = moment.trunk_m + moment.attitude * (box_.centre_m + sign.cwiseProduct(box_.half_extents_m));
    }
    return all;
  }

  std::string shadow() const {
    return polygon<4>("fill=\"#1c2226\" fill-opacity=\"0.1\"", "polygon", [&](const Moment& moment) {
      const auto all = corners(moment);
      return std::array{on_ground(all[0]), on_ground(all[1]), on_ground(all[3]), on_ground(all[2])};
    });
  }

  /// The three sides of the box that the eye sees.
  std::string trunk() const {
    struct Side {
      Vector3d outwards;
      std::array<std::size_t, 4> corners;
      const char* colour;
    };
    const std::array<Side, 6> sides{{{Vector3d::UnitX(), {1, 3, 7, 5}, "#b6c3cc"},
                                     {-Vector3d::UnitX(), {0, 2, 6, 4}, "#b6c3cc"},
                                     {Vector3d::UnitY(), {2, 3, 7, 6}, "#cdd7dd"},
                                     {-Vector3d::UnitY(), {0, 1, 5, 4}, "#cdd7dd"},
                                     {Vector3d::UnitZ(), {4, 5, 7, 6}, "#e6ecf0"},
                                     {-Vector3d::UnitZ(), {0, 1, 3, 2}, "#a0adb6"}}};
    std::string svg;
    for (const Side& side : sides) {
      if (kToEye.dot(moments_.front().attitude * side.outwards) > 0.0) {
        svg += polygon<4>(
            std::string("fill=\"") + side.colour + "\" stroke=\"#1c2226\" stroke-linejoin=\"round\"", "polygon",
            [&](const Moment& moment) {
              const auto all = corners(moment);
              return std::array{all[side.corners[0]], all[side.corners[1]], all[side.corners[2]], all[side.corners[3]]};
            });
      }
    }
    return svg;
  }

  std::string leg_of(std::size_t leg, const char* colour) const {
    std::string svg =
        polygon<4>(std::string("class=\"leg\" stroke=\"") + colour + "\" stroke-width=\"" + svg_number(kLeg_px) + "\"",
                   "polyline", [leg](const Moment& moment) { return moment.legs[leg]; });
    const auto foot = [&](std::size_t axis) {
      return per_frame([&, axis](const Moment& moment) {
        return svg_number(place(moment.legs[leg][3], moment)[static_cast<Eigen::Index>(axis)]);
      });
    };
    const auto xs = foot(0), ys = foot(1);
    const auto fills = per_frame([leg](const Moment& moment) { return moment.stands[leg] ? "#0072b2" : "#ffffff"; });
    const double radius_m = run_.robot.body->legs[leg].foot_radius_m;
    svg += "<circle cx=\"" + xs.front() + "\" cy=\"" + ys.front() + "\" r=\"" + svg_number(kPerMetre_px * radius_m) +
           "\" fill=\"" + fills.front() + "\" stroke=\"#0072b2\" stroke-width=\"2\">" +
           svg_animate("cx", xs, kMovingPicture_s) + svg_animate("cy", ys, kMovingPicture_s) +
           svg_animate("fill", fills, kMovingPicture_s, true) + "</circle>\n";
    return svg + arrow(leg);
  }

  /// The force of the ground on a foot, from where it acts. It shrinks to a point with the force.
  std::string arrow(std::size_t leg) const {
    const double radius_m = run_.robot.body->legs[leg].foot_radius_m;
    const double weight_N = body::total_mass_kg(*run_.robot.body) * run_.robot.body->gravity_m_s2;
    const auto values = per_frame([&](const Moment& moment) {
      const Vector2d from = place(moment.legs[leg][3] - radius_m * run_.plan.normal, moment);
      const Vector2d along = camera_.project(kWeight_m / weight_N * moment.forces_N[leg]);
      const double length_px = along.norm();
      const double head_px = std::min(kHead_px, 0.5 * length_px);
      const Vector2d ahead = length_px > 0.0 ? Vector2d(along / length_px) : Vector2d(0.0, 0.0);
      const Vector2d aside(-ahead.y(), ahead.x());
      const Vector2d neck = from + along - 2.0 * head_px * ahead;
      return svg_points(std::array<Vector2d, 7>{from + 0.3 * head_px * aside, neck + 0.3 * head_px * aside,
                                                neck + head_px * aside, from + along, neck - head_px * aside,
                                                neck - 0.3 * head_px * aside, from - 0.3 * head_px * aside});
    });
    return "<polygon points=\"" + values.front() + "\" fill=\"#009e73\">" +
           svg_animate("points", values, kMovingPicture_s) + "</polygon>\n";
  }

  const WalkRun& run_;
  std::vector<Moment> moments_;
  Camera camera_;
  body::TrunkBox box_ = run_.robot.body->box.value_or(body::shown_trunk(*run_.robot.body));
};

}  // namespace
}  // namespace moving_picture_parts

std::string moving_picture(const WalkRun& run) {
  using namespace moving_picture_parts;
  auto body = body::RigidBody::create(run.robot.body.value_or(body::BodyModel{}));
  if (!run.robot.body || run.changes.rows.empty() || !body) {
    return "";
  }
  auto moments = moments_of(run, body.value());
  if (moments.size() != static_cast<std::size_t>(kMovingPicture_s * kFrames_Hz) + 1) {
    return "";
  }
  const double from_s = run.shown_from_s(kMovingPicture_s);
  const double width_px = run.supply.empty() ? kStage_px : kWidth_px;
  const std::string size = svg_number(width_px) + " " + svg_number(kHeight_px);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" width=\"" +
                    svg_number(width_px) + "\" height=\"" + svg_number(kHeight_px) + "\">\n" + kStyle +
                    "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  svg += Stage(run, std::move(moments)).text();
  svg += "<text class=\"title\" x=\"16\" y=\"26\">" + escape_html(run.robot.name) + " at " +
         short_number(run.plan.forward_m_s) + " m/s</text>\n<text class=\"faint\" x=\"16\" y=\"46\">" +
         svg_number(from_s) + " s to " + svg_number(from_s + kMovingPicture_s) +
         " s of a run. Arrows: forces of the ground. A square is 0.5 m.</text>\n";
  if (!run.supply.empty()) {
    svg += moving_strips(run, {.from_s = from_s,
                               .loop_s = kMovingPicture_s,
                               .left_px = kStage_px + 46.0,
                               .right_px = kWidth_px - 16.0,
                               .top_px = 12.0,
                               .bottom_px = kHeight_px - 8.0});
  }
  return svg + "</svg>\n";
}

}  // namespace farrier::report
