#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/pose.h"
#include "base/rotation.h"
#include "sim/rays/solid.h"

namespace ccmorse::sim {

/// Where a rigid body is and how it moves, in the world's frame.
struct RigidState {
  Vec3 position;      ///< m, of its centre of mass, which is its origin
  Rotation rotation;  ///< of its frame
  Vec3 velocity;      ///< m/s, of its origin
  Vec3 spin;          ///< rad/s, about its origin
};

/// What of a body touches others.
struct RigidShape {
  enum class Kind {
    kNone,      ///< nothing
    kBox,       ///< half extents `half` about `centre`
    kCylinder,  ///< about the y axis through `centre`: radius half.x, half its width half.y
    kBall,      ///< of radius half.x about `centre`
    kHull       ///< the convex hull of `points`
  };
  Kind kind = Kind::kNone;
  Vec3 half;                 ///< m, each > 0 that counts
  Vec3 centre;               ///< m, in the body's frame
  std::vector<Vec3> points;  ///< m, in the body's frame, 4 or more
};

/// What a body is made of.
struct RigidMaterial {
  double friction = 0.5;         ///< >= 0; that of a contact is the product of both
  double linear_damping = 0.0;   ///< share of its velocity that it loses in a second, 0..1
  double angular_damping = 0.0;  ///< share of its spin, likewise
};

/// Rigid bodies among things that stand, moved by Bullet 3.24 in double precision (design:
/// Physics); no type of Bullet leaves the .cpp. The same calls in the same order give the same bits
/// on every x86-64: there is one thread, no sleeping, no order by address, and what Bullet would
/// take from the C library (sine, cosine and powers, which differ from CPU to CPU) is computed by
/// base/trig. Not thread safe.
class RigidWorld {
 public:
  using Body = int;   ///< of one world, from 0; never used again
  using Joint = int;  ///< likewise

  /// `gravity`: m/s^2 downwards.
  explicit RigidWorld(double gravity);
  ~RigidWorld();
  RigidWorld(const RigidWorld&) = delete;
  RigidWorld& operator=(const RigidWorld&) = delete;

  // What stands. `name` is what touches() calls it.

  /// Level ground without end, at z = 0.
  void AddGround(double friction);
  /// A box on the ground: `half` extents (m) about `centre` (m), turned by yaw (rad).
  void AddFixedBox(const Vec3& half, const Vec3& centre, double yaw, double friction,
                   const Surface& name);
  /// Triangles, three corners (m) each; both sides count.
  void AddFixedTriangles(std::span<const Vec3> corners, double friction, const Surface& name);
  /// Takes away all that stands.
  void ClearFixed();

  // What moves.

  /// A body of `mass` (kg, > 0) with these principal moments of inertia (kg m^2, > 0).
  Body AddBody(double mass, const Vec3& inertia, const RigidShape& shape,
               const RigidMaterial& material, const RigidState& state, const Surface& name);
  /// A body that moves as it is told by SetState() and by nothing else.
  Body AddMover(const RigidShape& shape, double friction, const RigidState& state,
                const Surface& name);

  RigidState state(Body body) const;
  /// Puts it there, with that motion.
  void SetState(Body body, const RigidState& state);
  void SetMotion(Body body, const Vec3& velocity, const Vec3& spin);

  /// A force (N) through its origin and a torque (Nm), in the world's frame, during the next Step()
  /// only. Adds up.
  void Push(Body body, const Vec3& force, const Vec3& torque);
  /// A force at a point (m), all in the world's frame, likewise.
  void PushAt(Body body, const Vec3& force, const Vec3& point);

  /// A wheel's axle: along the y axis of `body`, through `at` (m, in its frame) and the middle of
  /// `wheel`. The two pass through each other.
  Joint AddAxle(Body body, Body wheel, const Vec3& at);
  /// A ball held at its middle, likewise.
  void AddCaster(Body body, Body ball, const Vec3& at);
  /// Turns the wheel at `speed` (rad/s, positive forwards) with `impulse` (Nms) at most in a step;
  /// 0: it rolls freely.
  void SetMotor(Joint axle, double speed, double impulse);

  struct Hit {
    bool any = false;
    double share = 1.0;  ///< of the way
    Vec3 normal;         ///< of what it hit, unit
  };
  /// What the straight way from one point to the other (m) meets first, `self` left out.
  Hit Cast(const Vec3& from, const Vec3& to, Body self) const;

  /// One step of `seconds`.
  void Step(double seconds);

  /// Appends what the body touched at the end of the last step, sorted, each once, without the
  /// ground.
  void Touches(Body body, std::vector<Surface>& found) const;

 private:
  struct State;  // all that is Bullet's
  std::unique_ptr<State> state_;
};

}  // namespace ccmorse::sim
