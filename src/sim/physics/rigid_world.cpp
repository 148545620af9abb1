#include "sim/physics/rigid_world.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr double kDepth = 1000.0;  // m: how thick the ground is, so that nothing falls through it
constexpr double kBreadth = 1e7;   // m, of the ground, on either side of the origin
constexpr double kFarthestBody = 1e6;  // m from the origin: whatever gets there stops there
constexpr double kFastestBody = 1e4;   // m/s
constexpr double kFastestSpin = 80;    // rad/s: a rotation by more in a step would not be one
constexpr double kMargin = 0.005;      // m, around hulls and triangles: how Bullet rounds them

static_assert(sizeof(btScalar) == sizeof(double), "Bullet must be built for double precision");

btVector3 Vector(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 Vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

btMatrix3x3 Matrix(const Rotation& r) {
  return {r.x.x, r.y.x, r.z.x, r.x.y, r.y.y, r.z.y, r.x.z, r.y.z, r.z.z};
}

Rotation Turned(const btMatrix3x3& m) {
  return {Vector(m.getColumn(0)), Vector(m.getColumn(1)), Vector(m.getColumn(2))};
}

btTransform ToBullet(const RigidState& state) {
  return btTransform(Matrix(state.rotation), Vector(state.position));
}

// Where a body is after `seconds` at its speeds, by sines that are the same on every machine.
btTransform Integrated(const btRigidBody& body, double seconds) {
  const btTransform& from = body.getWorldTransform();
  const btVector3& spin = body.getAngularVelocity();
  const double rate = std::sqrt(spin.dot(spin));
  const double half = 0.5 * rate * seconds;
  // sin(half) / rate, which has a limit where the rate has none.
  const auto [s, c] = SinCos(half);
  const double share = half < 1e-4 ? 0.5 * seconds * (1.0 - half * half / 6.0) : s / rate;
  const btQuaternion turn(spin.x() * share, spin.y() * share, spin.z() * share, c);
  btQuaternion rotation = turn * from.getRotation();
  rotation.normalize();
  return btTransform(rotation, from.getOrigin() + body.getLinearVelocity() * seconds);
}

// What remains after `seconds` of a speed that loses `lost` of itself in a second.
double Kept(double lost, double seconds) {
  if (lost <= 0.0) return 1.0;
  return lost >= 1.0 ? 0.0 : Exp(Log(1.0 - lost) * seconds);
}

// Bullet's world with the two of its steps of our own in which it asks the C library for sines and
// powers, and with forces that act for one step.
class SteppedWorld : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  void Step(double seconds) {
    applyGravity();
    internalSingleStepSimulation(seconds);
    clearForces();
  }

 protected:
  void predictUnconstraintMotion(btScalar seconds) override {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      btRigidBody& body = *m_nonStaticRigidBodies[i];
      if (body.isStaticOrKinematicObject()) continue;
      body.setLinearVelocity(body.getLinearVelocity() * Kept(body.getLinearDamping(), seconds));
      body.setAngularVelocity(body.getAngularVelocity() * Kept(body.getAngularDamping(), seconds));
      body.setInterpolationWorldTransform(Integrated(body, seconds));
    }
  }

  void integrateTransforms(btScalar seconds) override {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      btRigidBody& body = *m_nonStaticRigidBodies[i];
      if (body.isStaticOrKinematicObject()) continue;
      Bound(body);
      const btTransform next = Integrated(body, seconds);
      if (next.getOrigin().length2() < kFarthestBody * kFarthestBody) {
        body.proceedToTransform(next);
      } else {
        body.setLinearVelocity({0.0, 0.0, 0.0});
        body.setAngularVelocity({0.0, 0.0, 0.0});
      }
    }
  }

 private:
  // However hard it is pushed, a body's numbers stay such that Bullet can go on.
  static void Bound(btRigidBody& body) {
    const auto bounded = [](const btVector3& v, double most) {
      const double length = std::sqrt(v.dot(v));
      if (!std::isfinite(length)) return btVector3(0.0, 0.0, 0.0);
      return length > most ? v * (most / length) : v;
    };
    body.setLinearVelocity(bounded(body.getLinearVelocity(), kFastestBody));
    body.setAngularVelocity(bounded(body.getAngularVelocity(), kFastestSpin));
  }
};

// The share of the way to where it enters a box, or more than 1; `normal`: of the side.
double MeetBox(const btRigidBody& body, const btVector3& half, const btVector3& from,
               const btVector3& to, btVector3& normal) {
  const btTransform back = body.getWorldTransform().inverse();
  const btVector3 start = back(from);
  const btVector3 way = back(to) - start;
  double enters = -1.0;
  double leaves = 2.0;
  int side = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0.0) {
      if (std::fabs(start[axis]) > half[axis]) return 2.0;
      continue;
    }
    const double near = ((way[axis] > 0.0 ? -half[axis] : half[axis]) - start[axis]) / way[axis];
    const double far = ((way[axis] > 0.0 ? half[axis] : -half[axis]) - start[axis]) / way[axis];
    if (near > enters) {
      enters = near;
      side = axis;
    }
    leaves = std::fmin(leaves, far);
  }
  if (enters < 0.0 || enters > leaves) return 2.0;
  normal = body.getWorldTransform().getBasis().getColumn(side) * (way[side] > 0.0 ? -1.0 : 1.0);
  return enters;
}

// The nearest that is not one body, nor a box that stands: of these Bullet's rays are some
// centimetres wrong, and ours are not.
class Nearest : public btCollisionWorld::ClosestRayResultCallback {
 public:
  Nearest(const btVector3& from, const btVector3& to, const btCollisionObject* self)
      : ClosestRayResultCallback(from, to), self_(self) {}
  bool needsCollision(btBroadphaseProxy* proxy) const override {
    if (proxy->m_clientObject == self_) return false;
    const auto* const object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
    const bool standing_box = object->isStaticObject() &&
                              object->getCollisionShape()->getShapeType() == BOX_SHAPE_PROXYTYPE;
    return !standing_box && ClosestRayResultCallback::needsCollision(proxy);
  }

 private:
  const btCollisionObject* self_;
};

}  // namespace

struct RigidWorld::State {
  // A thing of the world with what Bullet needs of it to stay where it is in memory.
  struct Thing {
    std::vector<std::unique_ptr<btCollisionShape>> shapes;  // the last is its own
    std::unique_ptr<btTriangleMesh> triangles;
    std::unique_ptr<btRigidBody> body;
    Surface name;
    std::optional<btVector3> half;  // m, of a box that stands
  };

  explicit State(double gravity)
      : dispatcher(&configuration), world(&dispatcher, &broadphase, &solver, &configuration) {
    world.setGravity({0.0, 0.0, -gravity});
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
  }

  ~State() {
    for (const auto& joint : joints) world.removeConstraint(joint.get());
    for (const auto& thing : bodies) world.removeRigidBody(thing->body.get());
    for (const auto& thing : fixed) world.removeRigidBody(thing->body.get());
  }

  // Into `thing`; nullptr for a shape that touches nothing.
  static btCollisionShape* Make(const RigidShape& shape, Thing& thing) {
    std::unique_ptr<btCollisionShape> made;
    switch (shape.kind) {
      case RigidShape::Kind::kNone:
        made = std::make_unique<btEmptyShape>();
        break;
      case RigidShape::Kind::kBox:
        made = std::make_unique<btBoxShape>(Vector(shape.half));
        break;
      case RigidShape::Kind::kCylinder:
        made =
            std::make_unique<btCylinderShape>(btVector3(shape.half.x, shape.half.y, shape.half.x));
        // Round all over its width, so that a wheel touches the ground beneath its middle, and not
        // now here and now there between its edges, which would steer it.
        made->setMargin(std::fmin(shape.half.y, 0.9 * shape.half.x));
        break;
      case RigidShape::Kind::kBall:
        made = std::make_unique<btSphereShape>(shape.half.x);
        break;
      case RigidShape::Kind::kHull: {
        // Bullet rounds a hull by its margin, so its points lie that much further in.
        Vec3 middle;
        for (const Vec3& point : shape.points) {
          middle = middle + (1.0 / static_cast<double>(shape.points.size())) * point;
        }
        auto hull = std::make_unique<btConvexHullShape>();
        const auto inwards = [](double from, double to) {
          return std::fabs(from - to) <= kMargin ? to : from + (to > from ? kMargin : -kMargin);
        };
        for (const Vec3& p : shape.points) {
          hull->addPoint({inwards(p.x, middle.x), inwards(p.y, middle.y), inwards(p.z, middle.z)},
                         false);
        }
        hull->recalcLocalAabb();
        hull->setMargin(kMargin);
        made = std::move(hull);
        break;
      }
    }
    thing.shapes.push_back(std::move(made));
    if (Dot(shape.centre, shape.centre) > 0.0) {
      auto moved = std::make_unique<btCompoundShape>(false, 1);
      moved->addChildShape(btTransform(btMatrix3x3::getIdentity(), Vector(shape.centre)),
                           thing.shapes.back().get());
      thing.shapes.push_back(std::move(moved));
    }
    return thing.shapes.back().get();
  }

  btRigidBody& Enter(std::unique_ptr<Thing> thing, btRigidBody::btRigidBodyConstructionInfo info,
                     const btTransform& at, bool stands) {
    info.m_startWorldTransform = at;
    thing->body = std::make_unique<btRigidBody>(info);
    btRigidBody& body = *thing->body;
    body.setUserPointer(thing.get());
    body.setActivationState(DISABLE_DEACTIVATION);
    (stands ? fixed : bodies).push_back(std::move(thing));
    return body;
  }

  void Stand(std::unique_ptr<Thing> thing, const btTransform& at, double friction) {
    btRigidBody::btRigidBodyConstructionInfo info(0.0, nullptr, thing->shapes.back().get());
    info.m_friction = friction;
    btRigidBody& body = Enter(std::move(thing), info, at, true);
    body.setActivationState(ISLAND_SLEEPING);  // as what stands has no need to be awake
    world.addRigidBody(&body);
  }

  btRigidBody& At(Body body) const { return *bodies[static_cast<std::size_t>(body)]->body; }

  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  SteppedWorld world;
  std::vector<std::unique_ptr<Thing>> fixed;
  std::vector<std::unique_ptr<Thing>> bodies;
  std::vector<std::unique_ptr<btTypedConstraint>> joints;
};

RigidWorld::RigidWorld(double gravity) : state_(std::make_unique<State>(gravity)) {}
RigidWorld::~RigidWorld() = default;

void RigidWorld::AddGround(double friction) {
  // A thick box: what has got a little into it finds its way up, however fast it came, and a box on
  // a box has its four corners as contacts at once, where Bullet's plane has one a step.
  auto thing = std::make_unique<State::Thing>();
  thing->shapes.push_back(
      std::make_unique<btBoxShape>(btVector3(kBreadth, kBreadth, 0.5 * kDepth)));
  thing->half = btVector3(kBreadth, kBreadth, 0.5 * kDepth);
  thing->name = {HitKind::kFloor, 0, 0};
  state_->Stand(std::move(thing),
                btTransform(btMatrix3x3::getIdentity(), btVector3(0.0, 0.0, -0.5 * kDepth)),
                friction);
}

void RigidWorld::AddFixedBox(const Vec3& half, const Vec3& centre, double yaw, double friction,
                             const Surface& name) {
  auto thing = std::make_unique<State::Thing>();
  thing->shapes.push_back(std::make_unique<btBoxShape>(Vector(half)));
  thing->half = Vector(half);
  thing->name = name;
  state_->Stand(std::move(thing), btTransform(Matrix(FromEuler(0.0, 0.0, yaw)), Vector(centre)),
                friction);
}

void RigidWorld::AddFixedTriangles(std::span<const Vec3> corners, double friction,
                                   const Surface& name) {
  auto thing = std::make_unique<State::Thing>();
  thing->triangles = std::make_unique<btTriangleMesh>();
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    thing->triangles->addTriangle(Vector(corners[i]), Vector(corners[i + 1]),
                                  Vector(corners[i + 2]));
  }
  auto shape = std::make_unique<btBvhTriangleMeshShape>(thing->triangles.get(), true);
  shape->setMargin(0.0);
  thing->shapes.push_back(std::move(shape));
  thing->name = name;
  state_->Stand(std::move(thing), btTransform::getIdentity(), friction);
}

void RigidWorld::ClearFixed() {
  for (const auto& thing : state_->fixed) state_->world.removeRigidBody(thing->body.get());
  state_->fixed.clear();
}

RigidWorld::Body RigidWorld::AddBody(double mass, const Vec3& inertia, const RigidShape& shape,
                                     const RigidMaterial& material, const RigidState& state,
                                     const Surface& name) {
  auto thing = std::make_unique<State::Thing>();
  thing->name = name;
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, State::Make(shape, *thing),
                                                Vector(inertia));
  info.m_friction = material.friction;
  info.m_linearDamping = material.linear_damping;
  info.m_angularDamping = material.angular_damping;
  btRigidBody& body = state_->Enter(std::move(thing), info, ToBullet(state), false);
  if (shape.kind == RigidShape::Kind::kNone) {
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  }
  state_->world.addRigidBody(&body);
  const auto number = static_cast<Body>(state_->bodies.size()) - 1;
  SetState(number, state);
  return number;
}

RigidWorld::Body RigidWorld::AddMover(const RigidShape& shape, double friction,
                                      const RigidState& state, const Surface& name) {
  auto thing = std::make_unique<State::Thing>();
  thing->name = name;
  btRigidBody::btRigidBodyConstructionInfo info(0.0, nullptr, State::Make(shape, *thing));
  info.m_friction = friction;
  btRigidBody& body = state_->Enter(std::move(thing), info, ToBullet(state), false);
  body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  state_->world.addRigidBody(&body);
  return static_cast<Body>(state_->bodies.size()) - 1;
}

RigidState RigidWorld::state(Body number) const {
  const btRigidBody& body = state_->At(number);
  const btTransform& at = body.getWorldTransform();
  return {Vector(at.getOrigin()), Turned(at.getBasis()), Vector(body.getLinearVelocity()),
          Vector(body.getAngularVelocity())};
}

void RigidWorld::SetState(Body number, const RigidState& state) {
  btRigidBody& body = state_->At(number);
  const btTransform at = ToBullet(state);
  body.setWorldTransform(at);
  body.setInterpolationWorldTransform(at);
  body.updateInertiaTensor();
  SetMotion(number, state.velocity, state.spin);
}

void RigidWorld::SetMotion(Body number, const Vec3& velocity, const Vec3& spin) {
  btRigidBody& body = state_->At(number);
  body.setLinearVelocity(Vector(velocity));
  body.setAngularVelocity(Vector(spin));
  body.setInterpolationLinearVelocity(Vector(velocity));
  body.setInterpolationAngularVelocity(Vector(spin));
}

void RigidWorld::Push(Body body, const Vec3& force, const Vec3& torque) {
  state_->At(body).applyCentralForce(Vector(force));
  state_->At(body).applyTorque(Vector(torque));
}

void RigidWorld::PushAt(Body number, const Vec3& force, const Vec3& point) {
  btRigidBody& body = state_->At(number);
  body.applyForce(Vector(force), Vector(point) - body.getWorldTransform().getOrigin());
}

RigidWorld::Joint RigidWorld::AddAxle(Body body, Body wheel, const Vec3& at) {
  const btVector3 axle(0.0, 1.0, 0.0);
  auto joint = std::make_unique<btHingeConstraint>(state_->At(body), state_->At(wheel), Vector(at),
                                                   btVector3(0.0, 0.0, 0.0), axle, axle);
  state_->world.addConstraint(joint.get(), true);
  state_->joints.push_back(std::move(joint));
  return static_cast<Joint>(state_->joints.size()) - 1;
}

void RigidWorld::AddCaster(Body body, Body ball, const Vec3& at) {
  auto joint = std::make_unique<btPoint2PointConstraint>(state_->At(body), state_->At(ball),
                                                         Vector(at), btVector3(0.0, 0.0, 0.0));
  state_->world.addConstraint(joint.get(), true);
  state_->joints.push_back(std::move(joint));
}

void RigidWorld::SetMotor(Joint axle, double speed, double impulse) {
  // Bullet's hinge has the speed of its first body as seen from the second.
  auto& hinge = static_cast<btHingeConstraint&>(*state_->joints[static_cast<std::size_t>(axle)]);
  hinge.enableAngularMotor(impulse > 0.0, -speed, impulse);
}

RigidWorld::Hit RigidWorld::Cast(const Vec3& from, const Vec3& to, Body self) const {
  Hit hit;
  Nearest nearest(Vector(from), Vector(to), &state_->At(self));
  state_->world.rayTest(Vector(from), Vector(to), nearest);
  if (nearest.hasHit()) {
    hit = {true, nearest.m_closestHitFraction, Vector(nearest.m_hitNormalWorld)};
  }
  for (const auto& thing : state_->fixed) {
    if (!thing->half) continue;
    btVector3 normal;
    const double share = MeetBox(*thing->body, *thing->half, Vector(from), Vector(to), normal);
    if (share > 1.0 || (hit.any && share >= hit.share)) continue;
    hit = {true, share, Vector(normal)};
  }
  return hit;
}

void RigidWorld::Step(double seconds) { state_->world.Step(seconds); }

void RigidWorld::Touches(Body number, std::vector<Surface>& found) const {
  const btCollisionObject* const body = &state_->At(number);
  const auto before = static_cast<std::ptrdiff_t>(found.size());
  for (int i = 0; i < state_->dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *state_->dispatcher.getManifoldByIndexInternal(i);
    const btCollisionObject* other = nullptr;
    if (manifold.getBody0() == body) other = manifold.getBody1();
    if (manifold.getBody1() == body) other = manifold.getBody0();
    if (other == nullptr) continue;
    bool touches = false;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      touches = touches || manifold.getContactPoint(k).getDistance() <= 1e-3;
    }
    const Surface& name = static_cast<const State::Thing*>(other->getUserPointer())->name;
    if (touches && name.kind != HitKind::kFloor && name.kind != HitKind::kNothing) {
      found.push_back(name);
    }
  }
  std::sort(found.begin() + before, found.end());
  found.erase(std::unique(found.begin() + before, found.end()), found.end());
}

}  // namespace ccmorse::sim
