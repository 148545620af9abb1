#include <algorithm>
#include <cmath>
#include <vector>

#include "client/player/morse_model.h"
#include "libCCMorse/MorsePen.h"
#include "libCCMorse/MorseRobot.h"

namespace CCMorse::playerlink {

namespace {

// Drawing of Player's graphics2d on the simulation's canvas: m in the world.
class Graphics2d final : public MorseModel {
 public:
  explicit Graphics2d(MorseDevice& pen) : MorseModel(pen), pen_(dynamic_cast<MorsePen&>(pen)) {}

  bool Deliver(DataSink& /*sink*/, bool /*valid*/) override { return false; }

  void Command(std::uint8_t subtype, const wire::Body& body) override {
    wire::Graphics2dCmdPoints points;
    wire::Graphics2dCmdPolyline polyline;
    wire::Graphics2dCmdMultiline multiline;
    wire::Graphics2dCmdPolygon polygon;
    if (pen_.GetWidth() == 0) pen_.RefreshSize();
    if (subtype == PLAYER_GRAPHICS2D_CMD_CLEAR) {
      pen_.ResizeCanvas(pen_.GetWidth(), pen_.GetHeight());
    } else if (subtype == PLAYER_GRAPHICS2D_CMD_POINTS && body.To(points)) {
      for (const wire::Point2d& point : points.points) {
        if (Finite(point)) pen_.DrawPixel(Cell(point), Paint(points.color));
      }
    } else if (subtype == PLAYER_GRAPHICS2D_CMD_POLYLINE && body.To(polyline)) {
      for (std::size_t i = 1; i < polyline.points.size(); ++i) {
        Line(polyline.points[i - 1], polyline.points[i], polyline.color);
      }
    } else if (subtype == PLAYER_GRAPHICS2D_CMD_MULTILINE && body.To(multiline)) {
      for (std::size_t i = 1; i < multiline.points.size(); i += 2) {
        Line(multiline.points[i - 1], multiline.points[i], multiline.color);
      }
    } else if (subtype == PLAYER_GRAPHICS2D_CMD_POLYGON && body.To(polygon)) {
      if (polygon.filled != 0) Fill(polygon.points, polygon.fill_color);
      for (std::size_t i = 0; i < polygon.points.size(); ++i) {
        Line(polygon.points[i], polygon.points[(i + 1) % polygon.points.size()], polygon.color);
      }
    }
  }

  Answer Request(std::uint8_t /*subtype*/, const wire::Body& /*body*/,
                 const TakeReply& /*take*/) override {
    return Refused();
  }

 private:
  static constexpr double kFarthest = 1e6;  // cells

  static bool Finite(const wire::Point2d& point) {
    return std::isfinite(point.px) && std::isfinite(point.py);
  }

  // Programs leave alpha at 0 and want to see what they draw.
  static Paint_t Paint(const wire::Color& color) {
    const int alpha = color.alpha == 0 ? 255 : color.alpha;
    return {int{color.red}, int{color.green}, int{color.blue}, alpha};
  }

  int Cell(double coordinate) const {
    return static_cast<int>(
        std::clamp(std::floor(coordinate / pen_.GetCellSize()), -kFarthest, kFarthest));
  }
  ImagePoint_t Cell(const wire::Point2d& point) const { return {Cell(point.px), Cell(point.py)}; }

  void Line(const wire::Point2d& from, const wire::Point2d& to, const wire::Color& color) {
    if (Finite(from) && Finite(to)) pen_.DrawLine(Cell(from), Cell(to), Paint(color));
  }

  // Row by row: the cells whose middles lie within, by the even-odd rule.
  void Fill(const std::vector<wire::Point2d>& points, const wire::Color& color) {
    if (!std::all_of(points.begin(), points.end(), Finite)) return;
    const double cell = pen_.GetCellSize();
    std::vector<double> crossings;
    for (int row = 0; row < pen_.GetHeight(); ++row) {
      const double y = (row + 0.5) * cell;
      crossings.clear();
      for (std::size_t i = 0; i < points.size(); ++i) {
        const wire::Point2d& a = points[i];
        const wire::Point2d& b = points[(i + 1) % points.size()];
        if ((a.py <= y) == (b.py <= y)) continue;
        crossings.push_back(a.px + (y - a.py) / (b.py - a.py) * (b.px - a.px));
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t i = 1; i < crossings.size(); i += 2) {
        const int first = Cell(crossings[i - 1] + cell / 2);
        const int last = Cell(crossings[i] - cell / 2);
        if (first <= last) pen_.DrawLine({first, row}, {last, row}, Paint(color));
      }
    }
  }

  MorsePen& pen_;
};

// The simulation's services behind Player's messages.
class Simulation final : public MorseModel {
 public:
  explicit Simulation(MorseDevice& any) : MorseModel(any), client_(any.GetClient()) {}

  bool Deliver(DataSink& /*sink*/, bool /*valid*/) override { return false; }

  void Command(std::uint8_t subtype, const wire::Body& /*body*/) override {
    if (subtype == PLAYER_SIMULATION_CMD_RESET) client_.Command("simulation", "reset_objects");
  }

  Answer Request(std::uint8_t subtype, const wire::Body& body, const TakeReply& take) override {
    wire::SimulationPose2dReq flat;
    wire::SimulationPose3dReq pose;
    try {
      if (subtype == PLAYER_SIMULATION_REQ_GET_POSE2D && body.To(flat)) {
        const wire::Pose3d found = Find(flat.name);
        flat.pose = {found.px, found.py, found.pyaw};
        take(wire::Body::Of(flat));
        return {};
      }
      if (subtype == PLAYER_SIMULATION_REQ_GET_POSE3D && body.To(pose)) {
        pose.pose = Find(pose.name);
        pose.simtime = client_.GetTime();
        take(wire::Body::Of(pose));
        return {};
      }
      if (subtype == PLAYER_SIMULATION_REQ_SET_POSE2D && body.To(flat)) {
        Place(flat.name, {flat.pose.px, flat.pose.py, 0.0, 0.0, 0.0, flat.pose.pa});
        return {};
      }
      if (subtype == PLAYER_SIMULATION_REQ_SET_POSE3D && body.To(pose)) {
        Place(pose.name, pose.pose);
        return {};
      }
    } catch (const MorseError& error) {
      return Refused(error.GetErrorStr());
    }
    return Refused();
  }

 private:
  wire::Pose3d Find(const std::string& name) const {
    const MorseValue object = client_.Request("simulation", "get_scene_objects").Member(name);
    const std::vector<double> position = object.GetDoubles("1");
    const std::vector<double> q = object.GetDoubles("2");  // x, y, z, w
    if (position.size() != 3 || q.size() != 4) {
      throw MorseError("there is no object \"" + name + "\"", "SimulationProxy");
    }
    wire::Pose3d pose;
    pose.px = position[0];
    pose.py = position[1];
    pose.pz = position[2];
    pose.proll = std::atan2(2 * (q[3] * q[0] + q[1] * q[2]), 1 - 2 * (q[0] * q[0] + q[1] * q[1]));
    pose.ppitch = std::asin(std::clamp(2 * (q[3] * q[1] - q[2] * q[0]), -1.0, 1.0));
    pose.pyaw = std::atan2(2 * (q[3] * q[2] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2]));
    return pose;
  }

  void Place(const std::string& name, const wire::Pose3d& pose) const {
    MorseArgs args(name);
    args.Add(MorseArgs(pose.px, pose.py, pose.pz));
    args.Add(MorseArgs(pose.proll, pose.ppitch, pose.pyaw));
    client_.Request("simulation", "set_object_position", args);
  }

  MorseClient& client_;
};

}  // namespace

std::shared_ptr<MorseModel> MakeGraphics2d(MorseDevice& pen) {
  return std::make_shared<Graphics2d>(pen);
}

std::shared_ptr<MorseModel> MakeSimulation(MorseDevice& any) {
  return std::make_shared<Simulation>(any);
}

}  // namespace CCMorse::playerlink
