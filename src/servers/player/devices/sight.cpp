#include "servers/player/devices/sight.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr double kEye = 0.1;  // m above the robot's origin
constexpr int kImageWidth = 80;
constexpr int kImageHeight = 60;
constexpr double kImageView = kPi / 3.0;  // rad
constexpr double kImageRange = 12.0;      // m
constexpr double kBeamStep = 0.25;        // degrees between a fiducial finder's beams
constexpr double kMostRange = 20.0;       // m, of a fiducial finder
constexpr std::int32_t kFirstRobotId = 1001;

scene::LaserDef FanOf(int beams, double view, double range) {
  scene::LaserDef def;
  def.position = {0.0, 0.0, kEye};
  def.samples = beams;
  def.scan_window_deg = Degrees(view);
  def.resolution_deg = Degrees(view) / (beams - 1);
  def.range = range;
  return def;
}

}  // namespace

Sight::Sight(DeviceContext context, const sim::Robot& robot, int beams, double view, double range)
    : context_(context), robot_(robot), fan_(FanOf(beams, view, range)), hits_(fan_.count()) {
  context_.simulation.world().PrepareCut(height());
}

double Sight::height() const { return robot_.model().origin_height + kEye; }

const std::vector<sim::RayHit>& Sight::Look() {
  context_.simulation.world().rays().ScanHits(fan_, robot_.pose(), robot_.model().origin_height,
                                              robot_.index(), hits_);
  return hits_;
}

const scene::Box* Sight::FindBox(int id) const {
  const auto& boxes = context_.simulation.world().scene().boxes;
  const auto found = std::find_if(boxes.begin(), boxes.end(),
                                  [id](const scene::Box& box) { return box.id == id; });
  return found == boxes.end() ? nullptr : &*found;
}

Color Sight::ColorOf(const sim::Surface& surface) const {
  switch (surface.kind) {
    case sim::HitKind::kRobot:
      return context_.simulation.robots()[static_cast<std::size_t>(surface.object)]->def().color;
    case sim::HitKind::kBox:
      if (const scene::Box* const box = FindBox(surface.object)) return box->color;
      return {};
    case sim::HitKind::kMesh:
      for (const scene::Mesh& mesh : context_.simulation.world().scene().meshes) {
        if (mesh.id == surface.object) return mesh.color;
      }
      return {};
    default:
      return {};
  }
}

double Sight::TopOf(const sim::Surface& surface) const {
  if (surface.kind == sim::HitKind::kRobot) {
    const auto& model =
        context_.simulation.robots()[static_cast<std::size_t>(surface.object)]->model();
    return model.ground_clearance + model.height;
  }
  const scene::Box* const box =
      surface.kind == sim::HitKind::kBox ? FindBox(surface.object) : nullptr;
  return box != nullptr ? box->height : 2.0 * height();
}

std::optional<Pose2> Sight::PoseOf(const sim::Surface& surface) const {
  if (surface.kind == sim::HitKind::kRobot) {
    return context_.simulation.robots()[static_cast<std::size_t>(surface.object)]->pose();
  }
  const scene::Box* const box =
      surface.kind == sim::HitKind::kBox ? FindBox(surface.object) : nullptr;
  if (box == nullptr) return {};
  return box->pose;
}

Blobfinder::Blobfinder(DeviceContext context, const sim::Robot& robot, std::uint16_t index,
                       double frequency)
    : Device(wire::kBlobfinder, index, "ccmorse",
             {{MessageType::kData, wire::kBlobfinderDataBlobs}}),
      context_(context),
      robot_(robot),
      rate_(frequency) {}

void Blobfinder::Step() {
  if (!rate_.TakeDue(context_.simulation)) return;
  if (!sight_) sight_.emplace(context_, robot_, kImageWidth, kImageView, kImageRange);
  const std::vector<sim::RayHit>& hits = sight_->Look();
  // Points of the image per unit of the tangent.
  const auto [half_sine, half_cosine] = SinCos(kImageView / 2.0);
  const double focus = kImageWidth / 2.0 * half_cosine / half_sine;
  const auto row = [&](double height, double distance) {
    const double below = (sight_->height() - height) / std::max(distance, 0.01) * focus;
    return static_cast<std::uint32_t>(
        std::clamp(kImageHeight / 2.0 + below, 0.0, kImageHeight - 1.0));
  };
  wire::BlobfinderData data;
  data.width = kImageWidth;
  data.height = kImageHeight;
  // Columns go from the left, beams from the right.
  for (std::size_t column = 0; column < hits.size();) {
    const auto hit_at = [&](std::size_t i) -> const sim::RayHit& {
      return hits[hits.size() - 1 - i];
    };
    const sim::Surface& first = hit_at(column).surface;
    if (first.kind == sim::HitKind::kNothing || first.kind == sim::HitKind::kFloor) {
      ++column;
      continue;
    }
    const Color color = sight_->ColorOf(first);
    wire::BlobfinderBlob blob;
    blob.color = std::uint32_t{color.r} << 16U | std::uint32_t{color.g} << 8U | color.b;
    blob.id = blob.color;
    blob.left = static_cast<std::uint32_t>(column);
    blob.range = hit_at(column).distance;
    double top = 0.0;
    for (; column < hits.size(); ++column) {
      const sim::Surface& surface = hit_at(column).surface;
      if (surface.kind == sim::HitKind::kNothing || surface.kind == sim::HitKind::kFloor ||
          sight_->ColorOf(surface) != color) {
        break;
      }
      blob.range = std::min(blob.range, hit_at(column).distance);
      top = std::max(top, sight_->TopOf(surface));
      blob.right = static_cast<std::uint32_t>(column);
    }
    blob.top = row(top, blob.range);
    blob.bottom = row(0.0, blob.range);
    blob.x = (blob.left + blob.right) / 2;
    blob.y = (blob.top + blob.bottom) / 2;
    blob.area = (blob.right - blob.left + 1) * (blob.bottom - blob.top + 1);
    data.blobs.push_back(blob);
  }
  Publish(wire::kBlobfinderDataBlobs, context_.simulation.time(), wire::Body::Of(data));
}

Fiducial::Fiducial(DeviceContext context, const sim::Robot& robot, std::uint16_t index,
                   double frequency)
    : Device(wire::kFiducial, index, "ccmorse",
             {{MessageType::kData, wire::kFiducialDataScan},
              {MessageType::kRequest, wire::kFiducialReqGetGeom},
              {MessageType::kRequest, wire::kFiducialReqGetFov},
              {MessageType::kRequest, wire::kFiducialReqSetFov},
              {MessageType::kRequest, wire::kFiducialReqGetId}}),
      context_(context),
      robot_(robot),
      rate_(frequency) {
  view_.max_range = 8.0;  // Stage's (C.3)
  view_.view_angle = kPi;
}

void Fiducial::Step() {
  if (!rate_.TakeDue(context_.simulation)) return;
  if (!sight_) {
    const int beams = std::max(2, static_cast<int>(Degrees(view_.view_angle) / kBeamStep));
    sight_.emplace(context_, robot_, beams, view_.view_angle, view_.max_range);
  }
  // By kind and number, each once, wherever on it beams meet.
  std::set<std::pair<sim::HitKind, int>> seen;
  wire::FiducialData data;
  for (const sim::RayHit& hit : sight_->Look()) {
    sim::Surface surface = hit.surface;
    surface.surface = 0;
    if (hit.distance < view_.min_range) continue;
    const std::optional<Pose2> pose = sight_->PoseOf(surface);
    if (!pose || !seen.emplace(surface.kind, surface.object).second) continue;
    const Vec2 at = InverseTransform(robot_.pose(), {pose->x, pose->y});
    wire::FiducialItem item;
    item.id =
        surface.kind == sim::HitKind::kRobot ? kFirstRobotId + surface.object : surface.object;
    item.pose = {at.x, at.y, 0.0, 0.0, 0.0, NormalizeAngle(pose->yaw - robot_.pose().yaw)};
    data.fiducials.push_back(item);
  }
  Publish(wire::kFiducialDataScan, context_.simulation.time(), wire::Body::Of(data));
}

bool Fiducial::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  switch (subtype) {
    case wire::kFiducialReqGetGeom: {
      wire::FiducialGeom geometry;
      geometry.pose.pz = kEye;
      geometry.size = {0.01, 0.01, 0.01};
      geometry.fiducial_size = {robot_.model().width, robot_.model().length};
      reply.Set(geometry);
      return body.empty();
    }
    case wire::kFiducialReqGetFov:
      reply.Set(view_);
      return body.empty();
    case wire::kFiducialReqSetFov: {
      wire::FiducialFov wanted;
      // Also false for what is no number.
      const bool fine = body.To(wanted) && wanted.min_range >= 0.0 &&
                        wanted.max_range > wanted.min_range && wanted.max_range <= kMostRange &&
                        wanted.view_angle > 0.01 && wanted.view_angle <= 2.0 * kPi + 1e-6;
      if (!fine) return false;
      wanted.view_angle = std::min(wanted.view_angle, 2.0 * kPi);
      view_ = wanted;
      sight_.reset();
      reply.Set(view_);
      return true;
    }
    default:
      reply.Set(wire::FiducialId{static_cast<std::uint32_t>(kFirstRobotId + robot_.index())});
      return body.empty();
  }
}

}  // namespace ccmorse::servers::player
