#include "sim/rays/embree_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace ccmorse::sim {
namespace {

constexpr std::size_t kStream = 256;  // rays a call, as measured fastest (specs: dependencies 2c)

constexpr std::size_t kMany = 400;  // movers, from which on incoherent rays are faster

// By how much triangles are made larger, as part of the scene's extent. Floats carry 24 bits; a
// ray's origin and direction, an instance's transformation and Embree's intersection each cost some
// units in the last place of the largest coordinate. This is 128 of them, many times what adds up,
// as on a surface that a ray grazes the error grows by 1 / cosine of the incidence.
constexpr double kGrowth = 0x1p-17;
constexpr double kLeastGrowth = 2.5e-4;  // m: in small scenes more costs nothing
// How far Embree searches on behind what it has found, likewise: along the ray an error grows in
// the same way.
constexpr double kSearchOn = 0x1p-12;

// A ray meets an instance when their masks have a bit in common. Each mover has a mask of its own
// with 16 of the 32 bits set, and a ray that is not to meet it has the other 16: any other mask has
// one of those. There are 601,080,390.
constexpr std::uint32_t kAllBits = 0xFFFFFFFFU;
constexpr std::uint32_t kFirstMask = 0x0000FFFFU;

// The next larger number with as many bits set (Gosper).
constexpr std::uint32_t NextMask(std::uint32_t mask) {
  const std::uint32_t lowest = mask & (~mask + 1U);
  const std::uint32_t ripple = mask + lowest;
  return ripple | (((mask ^ ripple) >> 2U) / lowest);
}

// One set of triangles as Embree and the filter know it.
struct Geometry {
  struct Triangle {
    Vec3 normal;  // Cross(b - a, c - a)
    Vec3 a;
  };
  struct Sphere {
    Vec3 centre;
    double radius;
  };
  TriangleSet set;
  bool moves;                       // it is a model of movers
  std::vector<Triangle> triangles;  // ordered as the set's
  std::vector<Sphere> spheres;      // around them
  // Embree's hit with barycentric coordinates u, v, w on a triangle with normal N is within it
  // beyond doubt when min(u, v, w) |N direction| exceeds this.
  std::vector<float> doubt;
};

// A triangle that has no area has no inside to be hit.
bool HasArea(const Vec3& normal) { return Dot(normal, normal) > 0.0; }

// The corner `a` of the triangle a b c with every edge moved outwards by `by`.
Vec3 Grown(const Vec3& a, const Vec3& b, const Vec3& c, double area, double by) {
  const Vec3 from_b = a - b;
  const Vec3 from_c = a - c;
  const double length_b = Length(from_b);
  const double length_c = Length(from_c);
  // A needle's tip would go far away, and much would lie in its way. With less room than this,
  // rays would slip through beside the tips of triangles as long and thin as a wall's.
  const double reach = std::min(by * length_b * length_c / area, 64.0 * by);
  return a + (reach / length_b) * from_b + (reach / length_c) * from_c;
}

// What the filter knows of one ray.
struct Lane {
  double distance;  // to the nearest so far, m: exact, or Embree's
  const Geometry* geometry;
  std::uint32_t triangle;
  std::uint32_t mover;  // the instance's number
  bool exact;
};

// What the triangle is part of, when its set is moved by `mover`.
Surface SurfaceOf(const Geometry& geometry, std::uint32_t triangle, std::uint32_t mover) {
  Surface surface = geometry.set.surfaces[triangle];
  if (geometry.moves) surface.object = static_cast<int>(mover);
  return surface;
}

struct TraceContext {
  RTCIntersectContext embree;  // first: the filter gets a pointer to it
  const Placement* placements;
  const Ray* rays;
  Lane* lanes;
  double search_on;
};

// The ray as the geometry sees it that `mover` moves.
Ray LocalRay(const Ray& ray, const Geometry& geometry, const Placement* placements,
             std::uint32_t mover) {
  if (!geometry.moves) return ray;
  const Placement& at = placements[mover];
  return {RotateBack(at.rotation, ray.origin - at.position),
          RotateBack(at.rotation, ray.direction)};
}

double Distance(const Ray& local, const Geometry& geometry, std::uint32_t triangle) {
  const Geometry::Triangle& plane = geometry.triangles[triangle];
  return PlaneDistance(local.origin, local.direction, plane.normal, plane.a);
}

// Does the ray meet the triangle in double, and where?
bool Meets(const Ray& local, const Geometry& geometry, std::uint32_t triangle, double& distance) {
  const double facing = Dot(geometry.triangles[triangle].normal, local.direction);
  if (facing == 0.0 || (geometry.set.closed && facing > 0.0)) return false;
  const Vec3* const corners = &geometry.set.corners[std::size_t{3} * triangle];
  if (!LineMeets(local.origin, local.direction, corners[0], corners[1], corners[2])) return false;
  distance = Distance(local, geometry, triangle);
  return distance >= 0.0;
}

// A hit that only double can judge: is it nearer than what the ray has found so far? Then it takes
// its place, and `tfar` is where Embree is to search on to. Out of line, as it is rare.
[[gnu::noinline]] bool IsNearest(const TraceContext& context, const Ray& ray,
                                 const Geometry& geometry, std::uint32_t triangle,
                                 std::uint32_t mover, Lane& lane, float& tfar) {
  double distance = 0.0;
  if (!Meets(LocalRay(ray, geometry, context.placements, mover), geometry, triangle, distance)) {
    return false;
  }
  if (!lane.exact) {
    lane.distance = Distance(LocalRay(ray, *lane.geometry, context.placements, lane.mover),
                             *lane.geometry, lane.triangle);
    lane.exact = true;
  }
  // Where two surfaces lie in one place, the first by name is seen.
  if (distance > lane.distance ||
      (distance == lane.distance &&
       (lane.geometry == nullptr || !(SurfaceOf(geometry, triangle, mover) <
                                      SurfaceOf(*lane.geometry, lane.triangle, lane.mover))))) {
    return false;
  }
  lane = {distance, &geometry, triangle, mover, true};
  tfar = static_cast<float>(distance + 2.0 * context.search_on);
  return true;
}

// Embree offers hits of N rays; what is not the nearest so far is refused. For the compiler N is a
// constant.
template <unsigned count>
void KeepNearestOf(const RTCFilterFunctionNArguments* offer) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): it is the first member
  const auto& context = *reinterpret_cast<const TraceContext*>(offer->context);
  const auto& geometry = *static_cast<const Geometry*>(offer->geometryUserPtr);
  // Mostly it is one ray of eight: found without a branch for each.
  unsigned offered = 0;
  for (unsigned i = 0; i < count; ++i) offered |= (offer->valid[i] != 0 ? 1U : 0U) << i;
  for (; offered != 0; offered &= offered - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(offered));
    const std::uint32_t mover = RTCHitN_instID(offer->hit, count, i, 0);
    // The direction may have been rotated in float, and the normal belongs to the grown triangle;
    // both only matter where a decision is left to double anyway.
    const float facing = RTCHitN_Ng_x(offer->hit, count, i) * RTCRayN_dir_x(offer->ray, count, i) +
                         RTCHitN_Ng_y(offer->hit, count, i) * RTCRayN_dir_y(offer->ray, count, i) +
                         RTCHitN_Ng_z(offer->hit, count, i) * RTCRayN_dir_z(offer->ray, count, i);
    const std::uint32_t triangle = RTCHitN_primID(offer->hit, count, i);
    const float u = RTCHitN_u(offer->hit, count, i);
    const float v = RTCHitN_v(offer->hit, count, i);
    const float within = std::min(std::min(u, v), 1.0F - u - v);
    const unsigned id = RTCRayN_id(offer->ray, count, i);
    float& tfar = RTCRayN_tfar(offer->ray, count, i);  // where Embree sees the hit
    Lane& lane = context.lanes[id];
    const double distance_seen = tfar - context.search_on;  // from the ray's own origin
    if (within * std::fabs(facing) > geometry.doubt[triangle] &&
        distance_seen > context.search_on) {
      if (geometry.set.closed && facing > 0.0F) {
        offer->valid[i] = 0;
        continue;
      }
      if (distance_seen < lane.distance - context.search_on) {
        lane = {distance_seen, &geometry, triangle, mover, false};
        // A little beyond the hit, as what is in truth nearer may seem to be farther. Embree goes
        // by what it finds here.
        tfar = static_cast<float>(distance_seen + 2.0 * context.search_on);
        continue;
      }
    }
    if (!IsNearest(context, context.rays[id], geometry, triangle, mover, lane, tfar)) {
      offer->valid[i] = 0;
    }
  }
}

void KeepNearest(const RTCFilterFunctionNArguments* offer) {
  switch (offer->N) {
    case 1:
      return KeepNearestOf<1>(offer);
    case 4:
      return KeepNearestOf<4>(offer);
    case 8:
      return KeepNearestOf<8>(offer);
    default:
      return KeepNearestOf<16>(offer);  // the largest there is
  }
}

// The same for IsBlocked(): anything before the far end will do.
void KeepAny(const RTCFilterFunctionNArguments* offer) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): it is the first member
  const auto& context = *reinterpret_cast<const TraceContext*>(offer->context);
  const auto& geometry = *static_cast<const Geometry*>(offer->geometryUserPtr);
  for (unsigned i = 0; i < offer->N; ++i) {
    if (offer->valid[i] == 0) continue;
    const std::uint32_t mover = RTCHitN_instID(offer->hit, offer->N, i, 0);
    const std::uint32_t triangle = RTCHitN_primID(offer->hit, offer->N, i);
    double distance = 0.0;
    const Lane& lane = context.lanes[0];
    if (!Meets(LocalRay(context.rays[0], geometry, context.placements, mover), geometry, triangle,
               distance) ||
        distance >= lane.distance) {
      offer->valid[i] = 0;
    }
  }
}

struct ConeQuery {
  const Cone* cone;
  const std::vector<const Geometry*>* models;  // by mover
  const std::vector<const Geometry*>* fixed;   // by id
  const Placement* placements;
  std::uint32_t self;
  double growth;
  RayHit nearest;
};

bool LookAtTriangle(RTCPointQueryFunctionArguments* arguments) {
  auto& query = *static_cast<ConeQuery*>(arguments->userPtr);
  const std::uint32_t mover = arguments->context->instID[0];
  if (mover == query.self) return false;
  const Geometry& geometry =
      mover < query.models->size() ? *(*query.models)[mover] : *(*query.fixed)[arguments->geomID];
  const std::uint32_t triangle = arguments->primID;
  const Ray local =
      LocalRay({query.cone->apex, query.cone->axis}, geometry, query.placements, mover);
  const Cone cone{local.origin, local.direction, query.cone->cosine, query.cone->sine};
  const Geometry::Triangle& plane = geometry.triangles[triangle];
  if (geometry.set.closed && Dot(plane.normal, plane.a - cone.apex) >= 0.0) return false;
  // Beyond what is found, or outside the cone?
  const Geometry::Sphere& sphere = geometry.spheres[triangle];
  const Vec3 to_centre = sphere.centre - cone.apex;
  const double far = Dot(to_centre, to_centre);
  const double reach = query.nearest.distance + sphere.radius;
  if (far > reach * reach) return false;
  const double along = Dot(to_centre, cone.axis);
  const double aside = std::sqrt(std::max(0.0, far - along * along));
  if (aside * cone.cosine - along * cone.sine > sphere.radius) return false;
  const Vec3* const corners = &geometry.set.corners[std::size_t{3} * triangle];
  const double distance = ConeDistance(cone, corners[0], corners[1], corners[2], plane.normal);
  if (!(distance <= query.nearest.distance)) return false;
  const Surface surface = SurfaceOf(geometry, triangle, mover);
  if (distance == query.nearest.distance &&
      (query.nearest.surface.kind == HitKind::kNothing || !(surface < query.nearest.surface))) {
    return false;
  }
  query.nearest = {distance, surface};
  arguments->query->radius = static_cast<float>(distance + query.growth);
  return true;
}

[[noreturn]] void Refuse(const std::string& what, RTCError error) {
  throw Error("Embree " + what + " (error " + std::to_string(static_cast<int>(error)) + ")");
}

std::string DeviceSettings(const std::string& isa) {
  // One thread: a build does not depend on how many there are, and starts none.
  std::string settings = "threads=1,set_affinity=0";
  if (!isa.empty()) return settings + ",isa=" + isa;
    // The results are the same on all; plain avx is slower than sse4.2, and avx512 no faster.
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return settings + ",isa=avx2";
  if (__builtin_cpu_supports("sse4.2")) return settings + ",isa=sse4.2";
#endif
  return settings;
}

}  // namespace

struct EmbreeScene::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<RTCScene> models;                   // and, last, what stands
  std::vector<RTCGeometry> instances;             // the scene's: by mover, then what stands
  std::vector<Placement> placements;              // of the instances
  std::vector<std::uint32_t> masks;               // of the movers
  std::vector<std::unique_ptr<Geometry>> owned;   // all geometries
  std::vector<const Geometry*> mover_geometries;  // by mover
  std::vector<const Geometry*> fixed_geometries;  // by id in what stands
  double extent = 1.0;                            // m

  // How much larger triangles are made, m.
  double growth() const { return std::max(kGrowth * extent, kLeastGrowth); }

  void Clear() {
    if (scene != nullptr) rtcReleaseScene(scene);
    scene = nullptr;
    for (const RTCScene model : models) rtcReleaseScene(model);
    models.clear();
    instances.clear();
    owned.clear();
    mover_geometries.clear();
    fixed_geometries.clear();
    placements.clear();
    masks.clear();
  }

  // Attaches a set to `into` under `id` and returns what the filter will know of it.
  const Geometry* Attach(const TriangleSet& set, bool moves, RTCScene into, unsigned id);

  // Attaches what `content` holds to the scene, under the next number.
  void AddInstance(RTCScene content, std::uint32_t mask) {
    const RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryMask(instance, mask);
    rtcSetGeometryInstancedScene(instance, content);
    rtcAttachGeometryByID(scene, instance, static_cast<unsigned>(instances.size()));
    rtcReleaseGeometry(instance);  // the scene keeps it
    instances.push_back(instance);
  }

  void Check(const char* what) const {
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE) Refuse(what, error);
  }
};

const Geometry* EmbreeScene::State::Attach(const TriangleSet& set, bool moves, RTCScene into,
                                           unsigned id) {
  owned.push_back(std::make_unique<Geometry>());
  Geometry& geometry = *owned.back();
  geometry.set.closed = set.closed;
  geometry.moves = moves;
  std::vector<float> grown;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Vec3& a = set.corners[3 * i];
    const Vec3& b = set.corners[3 * i + 1];
    const Vec3& c = set.corners[3 * i + 2];
    const Vec3 normal = Cross(b - a, c - a);
    if (!HasArea(normal)) continue;
    const double area = Length(normal);  // twice the triangle's
    geometry.set.Add(a, b, c, set.surfaces[i]);
    geometry.triangles.push_back({normal, a});
    const Vec3 centre = (1.0 / 3.0) * (a + b + c);
    geometry.spheres.push_back(
        {centre, std::max({Length(a - centre), Length(b - centre), Length(c - centre)})});
    const Vec3 grown_a = Grown(a, b, c, area, growth());
    const Vec3 grown_b = Grown(b, c, a, area, growth());
    const Vec3 grown_c = Grown(c, a, b, area, growth());
    for (const Vec3& corner : {grown_a, grown_b, grown_c}) {
      grown.insert(grown.end(), {static_cast<float>(corner.x), static_cast<float>(corner.y),
                                 static_cast<float>(corner.z)});
    }
    // By how much it was grown and some more from the grown edge, as part of the height; and
    // nothing that grazes is certain.
    const double longest =
        std::max({Length(grown_b - grown_a), Length(grown_c - grown_b), Length(grown_a - grown_c)});
    const double grown_area = Length(Cross(grown_b - grown_a, grown_c - grown_a));
    geometry.doubt.push_back(
        static_cast<float>(std::max(1.25 * growth() * longest, 0.01 * grown_area)));
  }
  const std::size_t count = geometry.set.size();
  const RTCGeometry made = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  if (count > 0) {
    void* const corners = rtcSetNewGeometryBuffer(made, RTC_BUFFER_TYPE_VERTEX, 0,
                                                  RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count);
    auto* const indexes = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        made, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
    if (corners == nullptr || indexes == nullptr) Check("has no memory for a mesh");
    std::memcpy(corners, grown.data(), grown.size() * sizeof(float));
    for (std::size_t i = 0; i < 3 * count; ++i) indexes[i] = static_cast<std::uint32_t>(i);
  }
  rtcSetGeometryMask(made, kAllBits);
  rtcSetGeometryUserData(made, &geometry);
  rtcSetGeometryIntersectFilterFunction(made, KeepNearest);
  rtcSetGeometryOccludedFilterFunction(made, KeepAny);
  rtcCommitGeometry(made);
  rtcAttachGeometryByID(into, made, id);
  rtcReleaseGeometry(made);
  return &geometry;
}

EmbreeScene::EmbreeScene(const std::string& isa) : state_(std::make_unique<State>()) {
  state_->device = rtcNewDevice(DeviceSettings(isa).c_str());
  if (state_->device == nullptr) Refuse("cannot be started", rtcGetDeviceError(nullptr));
  state_->scene = rtcNewScene(state_->device);
  rtcCommitScene(state_->scene);
}

EmbreeScene::~EmbreeScene() {
  state_->Clear();
  rtcReleaseDevice(state_->device);
}

void EmbreeScene::Build(const std::vector<TriangleSet>& fixed,
                        const std::vector<TriangleSet>& models, std::span<const int> model_of,
                        double extent) {
  State& state = *state_;
  state.Clear();
  for (const auto* sets : {&fixed, &models}) {
    for (const TriangleSet& set : *sets) {
      for (const Vec3& corner : set.corners) {
        extent = std::max({extent, std::fabs(corner.x), std::fabs(corner.y), std::fabs(corner.z)});
      }
    }
  }
  state.extent = std::max(extent, 1.0);
  state.scene = rtcNewScene(state.device);
  std::vector<const Geometry*> geometry_of_model;
  for (const TriangleSet& model : models) {
    state.models.push_back(rtcNewScene(state.device));
    geometry_of_model.push_back(state.Attach(model, true, state.models.back(), 0));
    rtcSetSceneBuildQuality(state.models.back(), RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(state.models.back());
  }
  for (const int model : model_of) {
    state.masks.push_back(state.masks.empty() ? kFirstMask : NextMask(state.masks.back()));
    state.AddInstance(state.models[static_cast<std::size_t>(model)], state.masks.back());
    state.mover_geometries.push_back(geometry_of_model[static_cast<std::size_t>(model)]);
  }
  // What stands is an instance, too: Embree builds anew all that is directly in a scene in which
  // anything moves.
  const RTCScene standing = rtcNewScene(state.device);
  state.models.push_back(standing);
  for (const TriangleSet& set : fixed) {
    const auto id = static_cast<unsigned>(state.fixed_geometries.size());
    state.fixed_geometries.push_back(state.Attach(set, false, standing, id));
  }
  rtcSetSceneBuildQuality(standing, RTC_BUILD_QUALITY_HIGH);
  rtcCommitScene(standing);
  state.AddInstance(standing, kAllBits);
  state.placements.resize(state.instances.size());
  for (std::size_t i = 0; i < state.instances.size(); ++i) Place(static_cast<int>(i), {});
  state.Check("cannot build the scene");
}

double EmbreeScene::extent() const { return state_->extent; }

void EmbreeScene::Place(int mover, const Placement& placement) {
  const auto index = static_cast<std::size_t>(mover);
  state_->placements[index] = placement;
  const Rotation& r = placement.rotation;
  std::array<float, 12> matrix{};  // column by column
  std::size_t next = 0;
  for (const Vec3& column : {r.x, r.y, r.z, placement.position}) {
    for (const double number : {column.x, column.y, column.z}) {
      matrix[next++] = static_cast<float>(number);
    }
  }
  const RTCGeometry instance = state_->instances[index];
  rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix.data());
  rtcCommitGeometry(instance);
}

void EmbreeScene::Commit() {
  rtcCommitScene(state_->scene);
  state_->Check("cannot build the scene");
}

void EmbreeScene::Trace(std::span<const Ray> rays, double range, int self,
                        std::span<RayHit> hits) const {
  thread_local std::vector<RTCRayHit> stream(kStream);
  thread_local std::vector<Lane> lanes(kStream);
  const double search_on = kSearchOn * state_->extent;
  const std::uint32_t seen = self < 0 ? kAllBits : ~state_->masks[static_cast<std::size_t>(self)];
  TraceContext context{};
  rtcInitIntersectContext(&context.embree);
  // Embree's word for which of its two ways is taken: the first keeps the rays of a packet
  // together, the other lets each go alone where a packet falls apart, as it does among many small
  // things.
  context.embree.flags = state_->instances.size() < kMany ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                          : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  context.placements = state_->placements.data();
  context.lanes = lanes.data();
  context.search_on = search_on;
  for (std::size_t done = 0; done < rays.size(); done += kStream) {
    const std::span<const Ray> part = rays.subspan(done, std::min(kStream, rays.size() - done));
    context.rays = part.data();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const auto& [origin, direction] = part[i];
      // From a little behind: what is near the origin may seem to lie behind it.
      const Vec3 start = origin - search_on * direction;
      RTCRayHit& ray = stream[i];
      ray.ray = {static_cast<float>(start.x),
                 static_cast<float>(start.y),
                 static_cast<float>(start.z),
                 0.0F,
                 static_cast<float>(direction.x),
                 static_cast<float>(direction.y),
                 static_cast<float>(direction.z),
                 0.0F,
                 static_cast<float>(range + 2.0 * search_on),
                 seen,
                 static_cast<unsigned>(i),
                 0};
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      lanes[i] = {range, nullptr, 0, RTC_INVALID_GEOMETRY_ID, true};
    }
    rtcIntersect1M(state_->scene, &context.embree, stream.data(),
                   static_cast<unsigned>(part.size()), sizeof(RTCRayHit));
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Lane& lane = lanes[i];
      RayHit& hit = hits[done + i];
      if (lane.geometry == nullptr) {
        hit = {range, {}};
        continue;
      }
      hit.surface = SurfaceOf(*lane.geometry, lane.triangle, lane.mover);
      hit.distance =
          lane.exact ? lane.distance
                     : Distance(LocalRay(part[i], *lane.geometry, context.placements, lane.mover),
                                *lane.geometry, lane.triangle);
      // Found by Embree's reckoning within the range, and a rounding error beyond it.
      if (hit.distance >= range) hit = {range, {}};
    }
  }
}

bool EmbreeScene::IsBlocked(const Vec3& from, const Vec3& to) const {
  const Vec3 way = to - from;
  const double length = Length(way);
  if (!(length > 0.0)) return false;
  const Ray ray{from, (1.0 / length) * way};
  Lane lane{length, nullptr, 0, RTC_INVALID_GEOMETRY_ID, true};
  TraceContext context{};
  rtcInitIntersectContext(&context.embree);
  context.placements = state_->placements.data();
  context.rays = &ray;
  context.lanes = &lane;
  const double search_on = kSearchOn * state_->extent;
  const Vec3 start = from - search_on * ray.direction;  // as in Trace()
  RTCRay embree_ray{static_cast<float>(start.x),
                    static_cast<float>(start.y),
                    static_cast<float>(start.z),
                    0.0F,
                    static_cast<float>(ray.direction.x),
                    static_cast<float>(ray.direction.y),
                    static_cast<float>(ray.direction.z),
                    0.0F,
                    static_cast<float>(length + 2.0 * search_on),
                    kAllBits,
                    0,
                    0};
  rtcOccluded1(state_->scene, &context.embree, &embree_ray);
  return embree_ray.tfar < 0.0F;  // Embree's way to say so
}

RayHit EmbreeScene::Nearest(const Cone& cone, double range, int self) const {
  ConeQuery query{&cone,
                  &state_->mover_geometries,
                  &state_->fixed_geometries,
                  state_->placements.data(),
                  self < 0 ? RTC_INVALID_GEOMETRY_ID : static_cast<std::uint32_t>(self),
                  state_->growth(),
                  {range, {}}};
  RTCPointQuery point{static_cast<float>(cone.apex.x), static_cast<float>(cone.apex.y),
                      static_cast<float>(cone.apex.z), 0.0F,
                      static_cast<float>(range + query.growth)};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(state_->scene, &point, &context, LookAtTriangle, &query);
  return query.nearest;
}

}  // namespace ccmorse::sim
