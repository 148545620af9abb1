#include "sim/physics/dynamics.h"

#include <algorithm>
#include <cmath>

#include "base/euler.h"
#include "scene/mesh.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

constexpr double kSubstepsASecond = 120.0;  // at least: MORSE's two of 60 Hz (specs: morse.md H.2)
constexpr double kMotor = 20.0;             // Nm of a wheel's motor a kg of its robot and wheels

// A prism over the footprint. One with four corners along the axes is a box, which Bullet does
// best.
RigidShape ShapeOf(const std::vector<Vec2>& outline, double bottom, double top) {
  RigidShape shape;
  Vec2 low = outline.front();
  Vec2 high = low;
  for (const Vec2 corner : outline) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  const bool box =
      outline.size() == 4 && std::all_of(outline.begin(), outline.end(), [&](const Vec2& corner) {
        return (corner.x == low.x || corner.x == high.x) &&
               (corner.y == low.y || corner.y == high.y);
      });
  if (box) {
    shape.kind = RigidShape::Kind::kBox;
    shape.half = {0.5 * (high.x - low.x), 0.5 * (high.y - low.y), 0.5 * (top - bottom)};
    shape.centre = {0.5 * (high.x + low.x), 0.5 * (high.y + low.y), 0.5 * (top + bottom)};
    return shape;
  }
  shape.kind = RigidShape::Kind::kHull;
  for (const double z : {bottom, top}) {
    for (const Vec2 corner : outline) shape.points.push_back({corner.x, corner.y, z});
  }
  return shape;
}

}  // namespace

struct Dynamics::Mover {
  struct Wheel {
    RigidWorld::Body body = 0;
    std::optional<RigidWorld::Joint> axle;  // of one with a motor
  };

  Robot* robot = nullptr;
  RigidWorld::Body body = 0;
  std::vector<Wheel> wheels;
  std::optional<Vehicle> vehicle;
  double motor = 0.0;  // Nm of one wheel
};

Dynamics::Dynamics(const World& world, const std::vector<std::unique_ptr<Robot>>& robots,
                   const scene::PhysicsDef& physics, double frequency)
    : world_(world),
      robots_(robots),
      physics_(physics),
      substeps_(std::max(physics.substeps,
                         static_cast<int>(std::ceil(kSubstepsASecond / frequency - 1e-9)))) {
  Build();
}

Dynamics::~Dynamics() = default;

void Dynamics::Reset() { Build(); }

void Dynamics::Build() {
  movers_.clear();
  bodies_ = std::make_unique<RigidWorld>(physics_.gravity);
  Stand();
  for (const auto& robot : robots_) {
    const Surface name{HitKind::kRobot, robot->index(), 0};
    if (robot->free()) continue;
    Mover mover;
    mover.robot = robot.get();
    if (!robot->dynamic()) {
      if (robot->model().hull.empty()) continue;
      const double top = robot->model().hull.back().top - robot->model().origin_height;
      const double bottom = robot->model().hull.front().bottom - robot->model().origin_height;
      const RigidState at{robot->position(), robot->rotation(), {}, {}};
      mover.body = bodies_->AddMover(ShapeOf(robot->model().footprint, bottom, top),
                                     physics_.friction, at, name);
      movers_.push_back(std::move(mover));
      continue;
    }
    const scene::DynamicsDef& def = *robot->def().body->dynamics;
    const double mass = robot->model().mass;
    mover.body = bodies_->AddBody(
        mass, robot->inertia(), ShapeOf(robot->model().footprint, def.bottom, def.top),
        {def.friction, def.linear_damping, def.angular_damping}, robot->body(), name);
    double all = mass;
    int driven = 0;
    for (const scene::WheelDef& def_wheel : def.wheels) {
      Mover::Wheel wheel;
      RigidShape shape;
      const double r = def_wheel.radius;
      double across = 0.4 * def_wheel.mass * r * r;
      double about = across;
      if (def_wheel.drive == "ball") {
        shape = {RigidShape::Kind::kBall, {r, 0.0, 0.0}, {}, {}};
      } else {
        shape = {RigidShape::Kind::kCylinder, {r, 0.5 * def_wheel.width, 0.0}, {}, {}};
        about = 0.5 * def_wheel.mass * r * r;
        across = def_wheel.mass * (3.0 * r * r + def_wheel.width * def_wheel.width) / 12.0;
      }
      RigidState at = robot->body();
      at.position = at.position + Rotate(at.rotation, def_wheel.position);
      wheel.body = bodies_->AddBody(
          def_wheel.mass, {across, about, across}, shape,
          {def_wheel.friction, def_wheel.linear_damping, def_wheel.angular_damping}, at, name);
      if (def_wheel.drive == "ball") {
        bodies_->AddCaster(mover.body, wheel.body, def_wheel.position);
      } else {
        const RigidWorld::Joint axle = bodies_->AddAxle(mover.body, wheel.body, def_wheel.position);
        if (def_wheel.drive != "free") wheel.axle = axle;
      }
      all += def_wheel.mass;
      driven += wheel.axle ? 1 : 0;
      mover.wheels.push_back(wheel);
    }
    if (driven > 0) mover.motor = kMotor * all / driven;
    if (def.vehicle) {
      mover.vehicle.emplace(*bodies_, mover.body, mass, robot->inertia(), *def.vehicle);
    }
    movers_.push_back(std::move(mover));
  }
}

void Dynamics::Stand() {
  bodies_->ClearFixed();
  const scene::World& scene = world_.scene();
  if (scene.has_floor) bodies_->AddGround(physics_.friction);
  for (const scene::Box& box : scene.boxes) {
    if (!box.raised || !box.solid) continue;
    bodies_->AddFixedBox({0.5 * box.size_x, 0.5 * box.size_y, 0.5 * box.height},
                         {box.pose.x, box.pose.y, 0.5 * box.height}, box.pose.yaw,
                         physics_.friction, {HitKind::kBox, box.id, 0});
  }
  for (const scene::Mesh& mesh : scene.meshes) {
    if (!mesh.solid) continue;
    const std::vector<Vec3> vertices = scene::PlacedVertices(mesh);
    std::vector<Vec3> corners;
    for (const auto& triangle : mesh.triangles) {
      for (const int corner : triangle) {
        corners.push_back(vertices[static_cast<std::size_t>(corner)]);
      }
    }
    if (!corners.empty()) {
      bodies_->AddFixedTriangles(corners, physics_.friction, {HitKind::kMesh, mesh.id, 0});
    }
  }
  revision_ = world_.revision();
}

// Puts the body and its wheels where the robot has been put.
void Dynamics::PutBack(Mover& mover) {
  const RigidState& state = mover.robot->body();
  bodies_->SetState(mover.body, state);
  if (!mover.robot->dynamic()) return;
  const scene::DynamicsDef& def = *mover.robot->def().body->dynamics;
  for (std::size_t i = 0; i < mover.wheels.size(); ++i) {
    RigidState at = state;
    at.position = at.position + Rotate(at.rotation, def.wheels[i].position);
    bodies_->SetState(mover.wheels[i].body, at);
  }
}

// What actuators want, once a tick.
void Dynamics::Order(Mover& mover, double seconds) {
  Robot& robot = *mover.robot;
  if (robot.orders().replaced) PutBack(mover);
  if (robot.driver() == nullptr) return;
  if (const std::optional<WheelSpeeds>& speeds = robot.orders().wheels) {
    const scene::DynamicsDef& def = *robot.def().body->dynamics;
    for (std::size_t i = 0; i < mover.wheels.size(); ++i) {
      if (!mover.wheels[i].axle) continue;
      const double speed = def.wheels[i].drive == "left" ? speeds->left : speeds->right;
      bodies_->SetMotor(*mover.wheels[i].axle, speed / def.wheels[i].radius, mover.motor * seconds);
    }
    return;
  }
  // A speed in its own frame, from which forces then take it away (MORSE's apply_speed); a robot on
  // the ground keeps its fall and its tilting.
  const RigidState now = bodies_->state(mover.body);
  const Twist& asked = robot.command();
  Vec3 velocity = Rotate(now.rotation, {asked.v, asked.side, 0.0});
  Vec3 spin = Rotate(now.rotation, {0.0, 0.0, asked.w});
  if (robot.def().body->dynamics->ground) {
    velocity.z = now.velocity.z;
    spin.x = now.spin.x;
    spin.y = now.spin.y;
  }
  bodies_->SetMotion(mover.body, velocity, spin);
  for (const Mover::Wheel& wheel : mover.wheels) {
    if (wheel.axle) bodies_->SetMotor(*wheel.axle, 0.0, 0.0);
  }
}

void Dynamics::Report(Mover& mover, const Instant& now) {
  Robot& robot = *mover.robot;
  for (const Mover::Wheel& wheel : mover.wheels) {
    const RigidState state = bodies_->state(wheel.body);
    for (const Vec3& v : {state.position, state.velocity, state.spin}) {
      robot.hash().Add(v.x);
      robot.hash().Add(v.y);
      robot.hash().Add(v.z);
    }
  }
  std::vector<Surface> touches;
  bodies_->Touches(mover.body, touches);
  // Its own wheels pass through it.
  robot.Follow(bodies_->state(mover.body), std::move(touches), now);
}

void Dynamics::Step(const Instant& now) {
  if (revision_ != world_.revision()) Stand();
  const double seconds = now.step / substeps_;
  for (Mover& mover : movers_) {
    if (mover.robot->dynamic()) {
      Order(mover, seconds);
    } else {
      bodies_->SetState(mover.body, {mover.robot->position(), mover.robot->rotation(),
                                     mover.robot->velocity(), mover.robot->spin()});
    }
  }
  for (int substep = 0; substep < substeps_; ++substep) {
    for (Mover& mover : movers_) {
      const Robot& robot = *mover.robot;
      if (!robot.dynamic()) continue;
      Vec3 force = robot.orders().force;
      // As MORSE has it: the bare acceleration, not times the mass.
      if (!robot.def().body->dynamics->gravity) force.z += physics_.gravity;
      bodies_->Push(mover.body, force, robot.orders().torque);
      if (mover.vehicle) mover.vehicle->Push(robot.orders().vehicle, seconds);
    }
    bodies_->Step(seconds);
  }
  for (Mover& mover : movers_) {
    if (mover.robot->dynamic()) Report(mover, now);
  }
  for (const auto& robot : robots_) {
    if (robot->free()) robot->Follow(robot->body(), {}, now);
  }
}

}  // namespace ccmorse::sim
