#include "render/camera.h"

#include <cmath>

#include "base/error.h"
#include "base/trig.h"
#include "render/vector_math.h"

namespace ccmorse::render {
Camera Camera::LookAt(const Vec3& from, const Vec3& at) {
  const Vec3 way = at - from;
  if (!(Dot(way, way) > 0.0)) throw Error("a camera cannot look at the place where it stands");
  const Vec3 back = Unit(from - at);
  const bool upright = back.x * back.x + back.y * back.y > 1e-12;
  const Vec3 right = Unit(Cross(upright ? Vec3{0, 0, 1} : Vec3{0, 1, 0}, back));
  Camera camera;
  camera.position = from;
  camera.rotation = {right, Cross(back, right), back};
  return camera;
}

Vec3 Camera::Direction(double right, double up) const {
  const auto [s, c] = SinCos(Radians(fov_deg / 2.0));
  return Unit(Rotate(rotation, {right * s / c, up * s / c, -1.0}));
}

}  // namespace ccmorse::render
