#include "scene/player/stage_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/nearest_name.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "scene/field.h"
#include "scene/limits.h"
#include "scene/player/outline.h"
#include "scene/player/x11_colors.h"

namespace ccmorse::scene {
namespace {

constexpr std::size_t kMostPieces = 200000;  // boxes and meshes of a world
constexpr int kMostPoints = 256;             // of a block
constexpr std::size_t kOutlineCorners = 64;
constexpr double kFlatHeight = 1.0;       // m, of what Stage 2 gave only two sizes
constexpr double kFlatRobotHeight = 0.2;  // m, likewise
constexpr double kThinnest = 0.001;       // m: whatever is flat has this thickness
constexpr double kWall = 0.02;            // m, thickness of the walls that `boundary 1` adds
constexpr double kAroundRobots = 2.0;     // m of floor about robots where there is no model else
constexpr double kBesideRobots = 0.01;    // m, likewise where there are models
constexpr double kMeshTop = 0.185;        // m: higher parts of meshes stop no robot (scene/mesh.h)

// A pose in the plane with a height.
struct Frame {
  Pose2 pose;
  double z = 0.0;
};

Frame Compose(const Frame& parent, const Frame& child) {
  const Vec2 at = Transform(parent.pose, {child.pose.x, child.pose.y});
  return {{at.x, at.y, NormalizeAngle(parent.pose.yaw + child.pose.yaw)}, parent.z + child.z};
}

// An upright prism of a model, in the model's frame.
struct Prism {
  std::vector<Vec2> outline;  // clean: counter-clockwise, maybe not convex
  double bottom = 0.0;
  double top = 0.0;
};

// Something of the world, in Stage's coordinates.
struct Piece {
  Prism prism;
  Frame frame;
  Color color;
  bool solid = true;
  bool visible = true;
  std::string kind;
  FilePlace at;
};

// What a model looks like, however it was written.
struct Shape {
  std::vector<Prism> prisms;
  Vec3 size;
  bool flat = false;       // its size has no height: written for Stage 2
  bool explicit_ = false;  // the file says something of size or blocks
  Color color;
  bool solid = true;
  bool visible = true;
};

const std::set<std::string>& ModelTypes() {
  static const std::set<std::string> types = {
      "model",  "position", "ranger",  "laser",    "fiducial",     "blobfinder",
      "bumper", "camera",   "gripper", "actuator", "blinkenlight", "lightindicator"};
  return types;
}

// What says something of Stage's window, its speed or its log: a run is the same without.
bool IsOfNoMatter(const std::string& name) {
  static const std::set<std::string> names = {
      "resolution",      "threads",        "show_clock",      "show_clock_interval",
      "confirm_on_quit", "interval_real",  "map_resolution",  "trail_length",
      "trail_interval",  "watts",          "joules",          "alwayson",
      "friction",        "mass",           "blob_return",     "fiducial_return",
      "fiducial_key",    "gripper_return", "update_interval", "say",
      "disable"};
  return names.contains(name) || name.starts_with("gui_");
}

// A name that can stand in a scenario.
std::string Identifier(const std::string& name, const std::string& fallback) {
  std::string made;
  for (const char c : name) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    made.push_back(good ? c : '_');
  }
  if (made.size() > 60) made.resize(60);
  return made.empty() ? fallback : made;
}

class Importer {
 public:
  Importer(const PlayerFile& file, std::string path, const StageFiles& files)
      : file_(file), path_(std::move(path)), files_(files) {}

  StageWorld Import() {
    Scenario& scenario = world_.scenario;
    scenario.name = std::filesystem::path(path_).stem().string();
    PropertyReader global(file_.global, file_);
    scenario.world.name = Identifier(global.Text("name", scenario.name), "world");
    ReadTime(global);
    std::optional<Vec2> flat_size;  // of Stage 2's whole world
    if (const std::vector<double> size = global.Tuple("size", "lll", 2); !size.empty()) {
      flat_size = {size[0], size[1]};
    }
    NoteUnused(global, "the world");
    std::map<std::string, int> counts;
    for (const PlayerEntity& entity : file_.global.children) {
      Model(entity, {}, "", counts);
    }
    PlaceFloor(flat_size);
    AddPieces();
    FinishRobots();
    return std::move(world_);
  }

 private:
  void Note(const FilePlace& at, std::string text, bool matters = true) {
    // A macro's notes would come once for each of its instances.
    if (!noted_.insert(at.Text() + text).second) return;
    world_.notes.push_back({at, std::move(text), matters});
  }

  void NoteUnused(const PropertyReader& reader, const std::string& what) {
    for (const PlayerProperty* property : reader.Unused()) {
      const bool matters = !IsOfNoMatter(property->name);
      Note(property->value.at,
           matters ? fmt::format("{} of {} is not supported and has no effect",
                                 Quoted(property->name), what)
                   : fmt::format("{} of {} has no effect here", Quoted(property->name), what),
           matters);
    }
  }

  void ReadTime(PropertyReader& global) {
    TimeDef& time = world_.scenario.time;
    const double interval = global.Number("interval_sim", 100.0);
    if (!(interval >= 1.0 && interval <= 1000.0)) {
      global.At("interval_sim")
          .Fail(fmt::format("interval_sim is {} ms, must be 1..1000", interval));
    }
    time.frequency = 1000.0 / interval;
    time.read_frequency = std::min(time.read_frequency, time.frequency);
    const double speedup = global.Number("speedup", 1.0);
    if (speedup <= 0.0) {
      time.strategy = "max";
    } else if (speedup < 0.001 || speedup > 1000.0) {
      global.At("speedup").Fail(fmt::format("speedup is {}, must be 0.001..1000, or 0", speedup));
    } else {
      time.factor = speedup;
    }
    time.end = std::max(0.0, global.Number("quit_time", 0.0));
    if (time.end > 1e9) global.At("quit_time").Fail("quit_time must be 1e9 s at most");
    if (global.Bool("paused", false)) {
      Note(global.At("paused"), "'paused' is not supported: the run begins at once");
    }
  }

  // [x y heading] or [x y z heading].
  static Frame ReadPose(PropertyReader& reader, std::string_view name) {
    const PlayerValue* const value = reader.Find(name);
    if (value == nullptr) return {};
    const bool flat = value->items.size() == 3;
    const std::vector<double> numbers = reader.Tuple(name, flat ? "lla" : "llla", 3);
    for (const double number : numbers) {
      if (std::fabs(number) > kFarthest) {
        value->at.Fail(fmt::format("{} has {} in it, must be within {}; is the unit right?", name,
                                   number, kFarthest));
      }
    }
    if (flat) return {{numbers[0], numbers[1], NormalizeAngle(numbers[2])}, 0.0};
    return {{numbers[0], numbers[1], NormalizeAngle(numbers[3])}, numbers[2]};
  }

  Color ReadColor(PropertyReader& reader) {
    constexpr Color kRed{255, 0, 0};
    Color color = kRed;
    if (reader.Has("color")) {
      const std::string name = reader.Text("color", "");
      if (const std::optional<Color> known = X11Color(name)) {
        color = *known;
      } else {
        const std::vector<std::string> names = X11ColorNames();
        Note(reader.At("color"), fmt::format("{} is no colour of X11{}; red is taken", Quoted(name),
                                             DidYouMean(name, names)));
      }
    }
    const std::vector<double> rgba = reader.Tuple("color_rgba", "ffff", 3);
    if (!rgba.empty()) {
      const auto channel = [](double share) {
        return static_cast<std::uint8_t>(std::floor(std::clamp(share, 0.0, 1.0) * 255.0 + 0.5));
      };
      color = {channel(rgba[0]), channel(rgba[1]), channel(rgba[2])};
    }
    return color;
  }

  // Blocks as written, in any unit: corners, and heights.
  Prism ReadBlock(const PlayerEntity& entity) {
    PropertyReader reader(entity, file_);
    const int points = reader.Integer("points", 0);
    if (points < 3 || points > kMostPoints) {
      reader.At("points").Fail(
          fmt::format("points is {}, a block must have 3..{}", points, kMostPoints));
    }
    Prism prism;
    for (int i = 0; i < points; ++i) {
      const std::string name = fmt::format("point[{}]", i);
      const std::vector<double> corner = reader.Tuple(name, "ff", 2);
      if (corner.empty()) {
        entity.at.Fail(fmt::format("this block of {} points lacks {}", points, name));
      }
      prism.outline.push_back({corner[0], corner[1]});
    }
    prism.top = 1.0;
    if (const std::vector<double> z = reader.Tuple("z", "ff", 2); !z.empty()) {
      prism.bottom = z[0];
      prism.top = z[1];
      if (!(z[0] < z[1]) || z[0] < 0.0) {
        reader.At("z").Fail(fmt::format("z is [{} {}], must be [low high] from 0 up", z[0], z[1]));
      }
    }
    if (reader.Has("color") || reader.Has("color_rgba")) {
      Note(entity.at, "a block's own colour is not supported: it has its model's", false);
    }
    ReadColor(reader);
    NoteUnused(reader, "a block");
    return prism;
  }

  // The whole group of blocks is scaled to the model's size, its middle on the model's.
  void AddBlocks(const PlayerEntity& entity, Shape& shape) {
    std::vector<Prism> raw;
    std::vector<FilePlace> places;
    for (const PlayerEntity& child : entity.children) {
      if (child.type != "block") continue;
      raw.push_back(ReadBlock(child));
      places.push_back(child.at);
    }
    if (raw.empty()) return;
    Vec2 low = raw[0].outline[0];
    Vec2 high = low;
    double top = 0.0;
    for (const Prism& prism : raw) {
      top = std::max(top, prism.top);
      for (const Vec2 corner : prism.outline) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
      }
    }
    const Vec2 extent = high - low;
    if (!(extent.x > 1e-9 && extent.y > 1e-9 && top > 1e-9)) {
      places[0].Fail("the blocks have no area; give their points different x and y");
    }
    const Vec2 middle = 0.5 * (low + high);
    const Vec3 scale{shape.size.x / extent.x, shape.size.y / extent.y, shape.size.z / top};
    for (std::size_t i = 0; i < raw.size(); ++i) {
      std::vector<Vec2> outline;
      for (const Vec2 corner : raw[i].outline) {
        const Vec2 off = corner - middle;
        outline.push_back({off.x * scale.x, off.y * scale.y});
      }
      outline = CleanPolygon(std::move(outline));
      if (outline.empty()) {
        Note(places[i], "this block has no area and is left out");
        continue;
      }
      shape.prisms.push_back({std::move(outline), raw[i].bottom * scale.z, raw[i].top * scale.z});
    }
  }

  void AddRectangle(double left, double bottom, double right, double top, Shape& shape) {
    shape.prisms.push_back(
        {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, 0.0, shape.size.z});
  }

  // The picture's middle is the model's, its edges are the model's size.
  void AddBitmap(PropertyReader& reader, Shape& shape) {
    const std::string name = reader.Text("bitmap", "");
    const std::string path =
        (std::filesystem::path(path_).parent_path() / name).lexically_normal().string();
    Image image;
    try {
      image = files_.bitmap(path);
    } catch (const Error& error) {
      reader.At("bitmap").Fail(fmt::format(
          "{}; names of bitmaps start from the folder of the world's file", error.what()));
    }
    const double cell_x = shape.size.x / image.width;
    const double cell_y = shape.size.y / image.height;
    const std::vector<PixelRect> rectangles = DarkRectangles(image);
    if (rectangles.empty()) {
      Note(reader.At("bitmap"),
           fmt::format("{} has no dark pixel, so it makes nothing", Quoted(name)));
    }
    for (const PixelRect& r : rectangles) {
      AddRectangle(
          r.x * cell_x - 0.5 * shape.size.x, 0.5 * shape.size.y - (r.y + r.height) * cell_y,
          (r.x + r.width) * cell_x - 0.5 * shape.size.x, 0.5 * shape.size.y - r.y * cell_y, shape);
    }
  }

  Shape ReadShape(PropertyReader& reader, const std::string& type) {
    const PlayerEntity& entity = reader.entity();
    Shape shape;
    shape.color = ReadColor(reader);
    shape.size = {0.1, 0.1, 0.1};
    const char* const size_name = reader.Has("size3") && !reader.Has("size") ? "size3" : "size";
    if (const std::vector<double> size = reader.Tuple(size_name, "lll", 2); !size.empty()) {
      shape.flat = size.size() == 2;
      const double height = type == "position" ? kFlatRobotHeight : kFlatHeight;
      shape.size = {size[0], size[1], shape.flat ? height : size[2]};
      shape.explicit_ = true;
      for (double* const side : {&shape.size.x, &shape.size.y, &shape.size.z}) {
        if (*side < 0.0 || *side > kFarthest) {
          reader.At(size_name).Fail(
              fmt::format("{} has {} m in it, must be 0 to {}", size_name, *side, kFarthest));
        }
        if (*side >= kThinnest) continue;
        Note(reader.At(size_name),
             fmt::format("{} has {} m in it; {} m is taken", size_name, *side, kThinnest));
        *side = kThinnest;
      }
    }
    shape.solid = reader.Bool("obstacle_return", true);
    shape.visible = reader.Number("ranger_return", 1.0) >= 0.0;
    if (reader.Has("laser_return") && reader.Number("laser_return", 1.0) <= 0.0) {
      shape.visible = false;
    }
    const bool has_blocks =
        std::any_of(entity.children.begin(), entity.children.end(),
                    [](const PlayerEntity& child) { return child.type == "block"; });
    const bool none = reader.Bool("noblocks", false);
    if (none) {
      shape.explicit_ = true;
    } else if (reader.Has("bitmap")) {
      AddBitmap(reader, shape);
      shape.explicit_ = true;
    }
    if (!none && has_blocks) {
      AddBlocks(entity, shape);
      shape.explicit_ = true;
    } else if (!none && !reader.Has("bitmap")) {
      AddRectangle(-0.5 * shape.size.x, -0.5 * shape.size.y, 0.5 * shape.size.x, 0.5 * shape.size.y,
                   shape);
    }
    if (reader.Bool("boundary", false)) AddBoundary(shape);
    const Frame origin = ReadPose(reader, "origin");
    for (Prism& prism : shape.prisms) {
      for (Vec2& corner : prism.outline) corner = Transform(origin.pose, corner);
      prism.bottom += origin.z;
      prism.top += origin.z;
    }
    return shape;
  }

  void AddBoundary(Shape& shape) {
    const double x = 0.5 * shape.size.x;
    const double y = 0.5 * shape.size.y;
    const double wall = std::min({kWall, x, y});
    AddRectangle(-x, -y, x, -y + wall, shape);
    AddRectangle(-x, y - wall, x, y, shape);
    AddRectangle(-x, -y, -x + wall, y, shape);
    AddRectangle(x - wall, -y, x, y, shape);
  }

  static std::string FullName(PropertyReader& reader, const std::string& parent,
                              std::map<std::string, int>& counts) {
    const std::string& type = reader.entity().type;
    const int number = counts[type]++;
    const std::string own = reader.Text("name", fmt::format("{}:{}", type, number));
    return parent.empty() ? own : parent + "." + own;
  }

  void CheckType(const PlayerEntity& entity) {
    if (ModelTypes().contains(entity.type)) return;
    std::vector<std::string> known(ModelTypes().begin(), ModelTypes().end());
    known.insert(known.end(), {"window", "block", "sensor"});
    entity.at.Fail(
        fmt::format("{} is neither a type of model nor a macro defined before{}; types are {}",
                    Quoted(entity.type), DidYouMean(entity.type, known), Listed(known)));
  }

  // A model that belongs to no robot, with its children; or a robot.
  void Model(const PlayerEntity& entity, const Frame& parent, const std::string& parent_name,
             std::map<std::string, int>& counts) {
    if (entity.type == "window" || entity.type == "gui") {
      Note(entity.at,
           fmt::format("{} is about Stage's own window and has no effect", Quoted(entity.written)),
           false);
      return;
    }
    if (entity.type == "block" && !parent_name.empty()) return;
    if (entity.type == "sensor" && !parent_name.empty()) return;
    CheckType(entity);
    if (entity.type == "position") {
      Robot(entity, parent, parent_name, counts);
      return;
    }
    PropertyReader reader(entity, file_);
    const std::string name = FullName(reader, parent_name, counts);
    if (entity.type != "model") {
      Note(entity.at, fmt::format("{} {} is on no robot, where CCMorse has none; only its body is "
                                  "there",
                                  entity.type, Quoted(name)));
    }
    const Frame frame = Compose(parent, ReadPose(reader, "pose"));
    const Shape shape = ReadShape(reader, entity.type);
    const bool has_body = entity.type == "model" || shape.explicit_;
    if (has_body) {
      for (const Prism& prism : shape.prisms) {
        AddPiece({prism, frame, shape.color, shape.solid, shape.visible,
                  Identifier(reader.Text("name", entity.written), "model"), entity.at});
      }
    }
    const double stack = reader.Bool("stack_children", true) ? shape.size.z : 0.0;
    NoteController(reader, name);
    if (entity.type == "model") NoteUnused(reader, "model " + Quoted(name));
    std::map<std::string, int> child_counts;
    for (const PlayerEntity& child : entity.children) {
      Model(child, Compose(frame, {{}, stack}), name, child_counts);
    }
  }

  void NoteController(PropertyReader& reader, const std::string& name) {
    if (!reader.Has("ctrl")) return;
    Note(reader.At("ctrl"),
         fmt::format("the controller {} of {} is not run; connect a program instead",
                     Quoted(reader.Text("ctrl", "")), Quoted(name)));
  }

  // A scenario has nothing so far away.
  static void CheckPlace(const Vec3& place, const FilePlace& at) {
    for (const double number : {place.x, place.y, place.z}) {
      if (std::fabs(number) > kFarthest) {
        at.Fail(
            fmt::format("a part of this model lies {} m away, must be within {} m; is a pose or "
                        "a size wrong?",
                        number, kFarthest));
      }
    }
  }

  void AddPiece(Piece piece) {
    if (pieces_.size() >= kMostPieces) {
      piece.at.Fail(fmt::format("the world has more than {} parts", kMostPieces));
    }
    CheckPlace({piece.frame.pose.x, piece.frame.pose.y, piece.frame.z + piece.prism.top}, piece.at);
    if (piece.frame.z + piece.prism.top <= 0.0) {
      Note(piece.at, "a part of this model lies below the floor and is left out");
      return;
    }
    pieces_.push_back(std::move(piece));
  }

  // Everything about one robot while its model is walked.
  struct Build {
    RobotDef def;
    StageRobot robot;
    std::vector<Vec2> touching;  // corners of all solid parts, in the robot's frame
    bool flat = false;
    bool visible = true;
    double height = 0.0;  // m, of the body
  };

  void Robot(const PlayerEntity& entity, const Frame& parent, const std::string& parent_name,
             std::map<std::string, int>& counts) {
    PropertyReader reader(entity, file_);
    const std::string name = FullName(reader, parent_name, counts);
    Build build;
    build.def.type = "Custom";
    build.def.front = "none";
    build.def.laser.position = {};
    build.def.body.emplace();
    build.def.name = RobotName(name, reader.At("name"));
    build.robot.name = build.def.name;
    const Frame frame = Compose(parent, ReadPose(reader, "pose"));
    build.def.pose = frame.pose;
    const Shape shape = ReadShape(reader, entity.type);
    build.flat = shape.flat;
    build.visible = shape.visible;
    build.height = shape.size.z;
    build.def.color = shape.color;
    if (!shape.solid) {
      Note(reader.At("obstacle_return"),
           fmt::format("obstacle_return 0 of robot {} is not supported: it runs into things",
                       Quoted(name)));
    }
    BodyDef& body = *build.def.body;
    body.mass = reader.Number("mass", body.mass);
    if (!(body.mass > 0.0 && body.mass <= 1e6)) {
      reader.At("mass").Fail(fmt::format("mass is {} kg, must be more than 0", body.mass));
    }
    ReadDrive(reader, name, build);
    ReadLocalization(reader, name, frame.pose, build);
    AddToHull(shape, {{}, frame.z}, true, build);
    if (build.touching.empty()) {
      Note(entity.at, fmt::format("robot {} has no body; one of its size is taken for what touches",
                                  Quoted(name)));
      for (const Vec2 corner : BoxCorners({}, shape.size.x, shape.size.y)) {
        build.touching.push_back(corner);
      }
    }
    const double stack = reader.Bool("stack_children", true) ? shape.size.z : 0.0;
    reader.Number("update_interval", 0.0);
    NoteController(reader, name);
    NoteUnused(reader, "robot " + Quoted(name));
    std::map<std::string, int> child_counts;
    for (const PlayerEntity& child : entity.children) {
      Carried(child, {{}, frame.z + stack}, name, child_counts, build);
    }
    body.footprint = HullOf(build.touching, kFootprintCorners);
    if (body.footprint.empty()) entity.at.Fail("the robot's body has no area");
    for (const Vec2 corner : body.footprint) CheckPlace({corner.x, corner.y, 0.0}, entity.at);
    for (const HullPart& part : body.hull) {
      for (const Vec2 corner : part.outline) CheckPlace({corner.x, corner.y, part.top}, entity.at);
    }
    CheckPlace({frame.pose.x, frame.pose.y, 0.0}, entity.at);
    const Pose2& counted = build.def.odometry.start;
    CheckPlace({counted.x, counted.y, 0.0}, entity.at);
    if (!build.visible) body.hull.clear();
    world_.scenario.robots.push_back(std::move(build.def));
    world_.robots.push_back(std::move(build.robot));
    robots_at_.push_back(entity.at);
  }

  std::string RobotName(const std::string& name, const FilePlace& at) {
    if (!robot_names_.insert(name).second) {
      at.Fail(fmt::format("two robots are called {}; give this one another name", Quoted(name)));
    }
    std::string made = Identifier(name, "robot");
    const std::string plain = made;
    const auto taken = [this](const std::string& wanted) {
      return std::any_of(world_.robots.begin(), world_.robots.end(),
                         [&wanted](const StageRobot& robot) { return robot.name == wanted; });
    };
    for (int number = 2; taken(made); ++number) {
      made = fmt::format("{}_{}", plain.substr(0, 56), number);
    }
    return made;
  }

  void ReadDrive(PropertyReader& reader, const std::string& name, Build& build) {
    BodyDef& body = *build.def.body;
    body.drive = reader.Text("drive", "diff");
    if (body.drive != "diff" && body.drive != "omni" && body.drive != "car") {
      reader.At("drive").Fail(
          fmt::format("drive is {}, must be diff, omni or car", Quoted(body.drive)));
    }
    body.wheelbase = reader.Length("wheelbase", 1.0);
    if (!(body.wheelbase > 0.0 && body.wheelbase <= kFarthest)) {
      reader.At("wheelbase").Fail("wheelbase must be more than 0");
    }
    std::vector<double> bounds = reader.Tuple("velocity_bounds", "llllllaa", 8);
    if (bounds.empty()) {
      bounds = {-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -Radians(90.0), Radians(90.0)};
    }
    const FilePlace at = reader.At("velocity_bounds");
    const auto limit = [&](std::size_t i, const char* what) {
      // A robot is as fast one way as the other here.
      if (bounds[i] != -bounds[i + 1]) {
        Note(at, fmt::format("robot {} is as fast one way as the other here: {} is {} at most",
                             Quoted(name), what,
                             std::max(std::fabs(bounds[i]), std::fabs(bounds[i + 1]))));
      }
      const double most = std::max(std::fabs(bounds[i]), std::fabs(bounds[i + 1]));
      if (most > 100.0)
        at.Fail(fmt::format("{} of {} is more than 100; is the unit right?", what, most));
      return most;
    };
    body.max_speed = std::max(1e-6, limit(0, "the speed forward"));
    body.max_side_speed = body.drive == "omni" ? limit(2, "the speed sideways") : 0.0;
    body.max_turn_rate = std::max(1e-6, limit(6, "the turn rate"));
    if (reader.Has("velocity")) {
      const std::vector<double> velocity = reader.Tuple("velocity", "llla", 3);
      if (std::any_of(velocity.begin(), velocity.end(), [](double v) { return v != 0.0; })) {
        Note(reader.At("velocity"),
             fmt::format("'velocity' is not supported: robot {} stands still at the start",
                         Quoted(name)));
      }
    }
    if (reader.Has("acceleration_bounds")) {
      Note(reader.At("acceleration_bounds"),
           fmt::format("'acceleration_bounds' is not supported: robot {} has a commanded speed at "
                       "once",
                       Quoted(name)));
    }
  }

  void ReadLocalization(PropertyReader& reader, const std::string& name, const Pose2& start,
                        Build& build) {
    const std::string kind = reader.Text("localization", "gps");
    if (kind != "gps" && kind != "odom") {
      reader.At("localization")
          .Fail(fmt::format("localization is {}, must be gps or odom", Quoted(kind)));
    }
    const bool odom = kind == "odom";
    const std::string device = odom ? "odometry" : "pose";
    build.def.proxies = {{"position2d", {{0, device}}}};
    build.robot.models.push_back({name, "position", {device}});
    const Frame origin = ReadPose(reader, "localization_origin");
    std::vector<double> error = reader.Tuple("odom_error", "ffffff", 3);
    if (!odom) return;
    if (reader.Has("localization_origin")) {
      const Vec2 at = InverseTransform(origin.pose, {start.x, start.y});
      build.def.odometry.start = {at.x, at.y, NormalizeAngle(start.yaw - origin.pose.yaw)};
    }
    if (error.empty()) error = {0.03, 0.03, 0.0, 0.05};
    build.def.odometry.error = {error[0], error[1], error.back()};
    for (const double gain : {error[0], error[1], error.back()}) {
      if (gain < 0.0 || gain > 1.0) {
        reader.At("odom_error").Fail(fmt::format("odom_error has {} in it, must be 0..1", gain));
      }
    }
  }

  // Parts of a body in a frame on the robot.
  static void AddToHull(const Shape& shape, const Frame& frame, bool solid, Build& build) {
    for (const Prism& prism : shape.prisms) {
      const double bottom = std::max(0.0, frame.z + prism.bottom);
      const double top = frame.z + prism.top;
      if (!(top > bottom)) continue;
      for (const std::vector<Vec2>& piece : ConvexPieces(prism.outline)) {
        std::vector<Vec2> placed;
        for (const Vec2 corner : piece) placed.push_back(Transform(frame.pose, corner));
        if (solid) build.touching.insert(build.touching.end(), placed.begin(), placed.end());
        std::vector<Vec2> outline = HullOf(placed, kOutlineCorners);
        if (outline.empty() || !shape.visible) continue;
        build.def.body->hull.push_back({std::move(outline), bottom, top});
      }
    }
  }

  // A model on a robot, `parent` being the frame it is put on, in the robot's.
  void Carried(const PlayerEntity& entity, const Frame& parent, const std::string& parent_name,
               std::map<std::string, int>& counts, Build& build) {
    if (entity.type == "block") return;
    if (entity.type == "sensor") {
      entity.at.Fail("a sensor must be within a ranger");
    }
    CheckType(entity);
    PropertyReader reader(entity, file_);
    const std::string name = FullName(reader, parent_name, counts);
    const Frame frame = Compose(parent, ReadPose(reader, "pose"));
    const Shape shape = ReadShape(reader, entity.type);
    const bool is_ranger = entity.type == "ranger" || entity.type == "laser";
    StageModel model{name, entity.type, {}};
    // Sensors have a body only where the file gives them one.
    const bool has_body = entity.type == "model" || entity.type == "position" || shape.explicit_;
    if (has_body) AddToHull(shape, frame, shape.solid && !is_ranger, build);
    if (is_ranger) {
      Frame from = frame;
      if (build.flat) {
        // Stage 2 knew no heights: everything saw everything.
        from.z = 0.5 * build.height;
      } else if (has_body) {
        from.z += 0.5 * shape.size.z;
      }
      ReadRanger(entity, reader, from, name, build, model);
    } else if (entity.type == "position") {
      Note(entity.at, fmt::format("{} is a position model on another one, which is not supported: "
                                  "it is a part of the robot's body",
                                  Quoted(name)));
    } else if (entity.type != "model") {
      Note(entity.at, fmt::format("{} {} is not supported: robots of CCMorse carry none",
                                  entity.type, Quoted(name)));
    }
    build.robot.models.push_back(std::move(model));
    NoteController(reader, name);
    if (is_ranger || entity.type == "model") {
      NoteUnused(reader, fmt::format("{} {}", entity.type, Quoted(name)));
    }
    const double stack = reader.Bool("stack_children", true) ? shape.size.z : 0.0;
    std::map<std::string, int> child_counts;
    for (const PlayerEntity& child : entity.children) {
      if (child.type == "sensor" && entity.type == "ranger") continue;
      Carried(child, Compose(frame, {{}, stack}), name, child_counts, build);
    }
  }

  // One sensor of a ranger, of any of Stage's dialects.
  struct SensorDef {
    Frame frame;  // on the robot
    double min_range = 0.0;
    double range = 5.0;
    double fov = 0.1;  // rad
    int samples = 1;
    double noise = 0.0;  // m
    FilePlace at;
  };

  void ReadRanger(const PlayerEntity& entity, PropertyReader& reader, const Frame& frame,
                  const std::string& name, Build& build, StageModel& model) {
    const double interval = reader.Number("update_interval", 100.0);
    if (!(interval >= 1.0 && interval <= 1e6)) {
      reader.At("update_interval")
          .Fail(fmt::format("update_interval is {} ms, must be 1..1000000", interval));
    }
    const double frequency = 1000.0 / interval;
    std::vector<SensorDef> sensors;
    if (entity.type == "laser") {
      sensors.push_back(LegacyLaser(reader, frame));
    } else if (reader.Has("scount")) {
      sensors = LegacyRing(reader, frame);
    }
    for (const PlayerEntity& child : entity.children) {
      if (entity.type == "ranger" && child.type == "sensor") {
        sensors.push_back(ReadSensor(child, frame));
      }
    }
    if (sensors.empty()) {
      Note(entity.at, fmt::format("ranger {} has no sensors and measures nothing", Quoted(name)));
      return;
    }
    std::vector<SensorDef> ring;
    std::vector<SensorDef> scanners;
    for (SensorDef& sensor : sensors) {
      (sensor.samples > 1 ? scanners : ring).push_back(std::move(sensor));
    }
    if (scanners.size() + (ring.empty() ? 0U : 1U) > 1) {
      Note(entity.at,
           fmt::format("ranger {} has {} scanners{}, which become a device each", Quoted(name),
                       scanners.size(), ring.empty() ? "" : " and a ring"));
    }
    for (const SensorDef& scanner : scanners) {
      model.components.push_back(AddLaser(scanner, frequency, name, build));
    }
    if (!ring.empty()) model.components.push_back(AddRing(ring, frequency, name, build));
  }

  static void CheckRange(double least, double most, const FilePlace& at) {
    if (least >= 0.0 && most > least && most <= kFarthest) return;
    at.Fail(
        fmt::format("a range from {} to {} m; must begin at 0 or more and end farther away, at "
                    "most {} m",
                    least, most, kFarthest));
  }

  SensorDef ReadSensor(const PlayerEntity& entity, const Frame& frame) {
    PropertyReader reader(entity, file_);
    SensorDef sensor;
    sensor.at = entity.at;
    sensor.frame = Compose(frame, ReadPose(reader, "pose"));
    if (const std::vector<double> range = reader.Tuple("range", "ll", 2); !range.empty()) {
      sensor.min_range = range[0];
      sensor.range = range[1];
    }
    CheckRange(sensor.min_range, sensor.range, reader.At("range"));
    sensor.fov = reader.Angle("fov", sensor.fov);
    sensor.samples = reader.Integer("samples", sensor.samples);
    CheckFan(sensor, reader);
    if (const std::vector<double> noise = reader.Tuple("noise", "lfa", 1); !noise.empty()) {
      sensor.noise = noise[0];
      if (sensor.noise < 0.0 || sensor.noise > kFarthest) {
        reader.At("noise").Fail("noise must not be negative");
      }
      if (std::any_of(noise.begin() + 1, noise.end(), [](double n) { return n != 0.0; })) {
        Note(reader.At("noise"),
             "only the constant part of 'noise' is supported, its first number");
      }
    }
    ReadColor(reader);
    reader.Tuple("size", "lll", 2);
    NoteUnused(reader, "a sensor");
    return sensor;
  }

  static void CheckFan(const SensorDef& sensor, PropertyReader& reader) {
    if (sensor.samples < 1 || sensor.samples > 10000) {
      reader.At("samples").Fail(fmt::format("samples is {}, must be 1..10000", sensor.samples));
    }
    if (sensor.fov < 0.0 || Degrees(sensor.fov) > 360.0 + 1e-9 ||
        (sensor.samples > 1 && sensor.fov < 1e-6)) {
      reader.At("fov").Fail(fmt::format("fov is {} degrees, must be more than 0 and at most 360",
                                        Degrees(sensor.fov)));
    }
  }

  // Stage 2 and 3: laser ( range_max 8 fov 180 samples 180 ).
  SensorDef LegacyLaser(PropertyReader& reader, const Frame& frame) {
    SensorDef sensor;
    sensor.at = reader.entity().at;
    sensor.frame = frame;
    sensor.min_range = reader.Length("range_min", 0.0);
    sensor.range = reader.Length("range_max", 8.0);
    CheckRange(sensor.min_range, sensor.range, reader.At("range_max"));
    sensor.fov = reader.Angle("fov", Radians(180.0));
    sensor.samples = reader.Integer("samples", 180);
    CheckFan(sensor, reader);
    return sensor;
  }

  // Stage 2 and 3: ranger ( scount n sview [min max fov] ssize [x y] spose[i] [x y heading] ), and
  // sview[i] for one sensor alone.
  std::vector<SensorDef> LegacyRing(PropertyReader& reader, const Frame& frame) {
    const int count = reader.Integer("scount", 0);
    if (count < 1 || count > 1000) {
      reader.At("scount").Fail(fmt::format("scount is {}, must be 1..1000", count));
    }
    reader.Tuple("ssize", "lll", 2);
    std::vector<SensorDef> sensors;
    for (int i = 0; i < count; ++i) {
      SensorDef sensor;
      const std::string pose = fmt::format("spose[{}]", i);
      if (!reader.Has(pose)) {
        Note(reader.entity().at,
             fmt::format("a ranger of {} sensors lacks {}; it looks ahead from the middle", count,
                         pose));
      }
      sensor.at = reader.At(pose);
      sensor.frame = Compose(frame, ReadPose(reader, pose));
      const std::string own = fmt::format("sview[{}]", i);
      const std::string view = reader.Has(own) ? own : "sview";
      reader.Tuple(fmt::format("ssize[{}]", i), "lll", 2);
      if (const std::vector<double> numbers = reader.Tuple(view, "lla", 3); !numbers.empty()) {
        sensor.min_range = numbers[0];
        sensor.range = numbers[1];
        sensor.fov = numbers[2];
      }
      CheckRange(sensor.min_range, sensor.range, reader.At(view));
      CheckFan(sensor, reader);
      sensors.push_back(std::move(sensor));
    }
    return sensors;
  }

  std::string ComponentName(const std::string& model, const Build& build) {
    const std::size_t dot = model.rfind('.');
    const std::string plain =
        Identifier(dot == std::string::npos ? model : model.substr(dot + 1), "ranger");
    static const std::set<std::string> reserved = {
        "pose", "odometry", "hokuyo", "ir", "sonar", "properties", "motion", "waypoint", "pen"};
    const auto taken = [&](const std::string& name) {
      return reserved.contains(name) ||
             std::any_of(build.def.rangers.begin(), build.def.rangers.end(),
                         [&name](const RangerDef& ranger) { return ranger.name == name; });
    };
    std::string name = plain;
    for (int number = 2; taken(name); ++number) name = fmt::format("{}_{}", plain, number);
    return name;
  }

  std::string AddLaser(const SensorDef& sensor, double frequency, const std::string& model,
                       Build& build) {
    CheckPlace({sensor.frame.pose.x, sensor.frame.pose.y, sensor.frame.z}, sensor.at);
    LaserDef laser;
    laser.position = {sensor.frame.pose.x, sensor.frame.pose.y, sensor.frame.z};
    laser.yaw = sensor.frame.pose.yaw;
    laser.frequency = std::min(frequency, 1000.0);
    laser.range = sensor.range;
    laser.range_std = sensor.noise;
    laser.samples = sensor.samples;
    laser.scan_window_deg = std::min(360.0, Degrees(sensor.fov));
    // The first and the last beam lie on the edges of the window.
    laser.resolution_deg = laser.scan_window_deg / (laser.samples - 1);
    if (sensor.min_range > 0.0) {
      Note(sensor.at, "the least range of a scanner is not supported: it measures from 0 on");
    }
    if (build.def.front != "laser") {
      build.def.front = "laser";
      build.def.laser = laser;
      build.def.proxies["laser"] = {{0, "hokuyo"}};
      return "hokuyo";
    }
    RangerDef ranger;
    ranger.name = ComponentName(model, build);
    ranger.laser = laser;
    build.def.rangers.push_back(ranger);
    return ranger.name;
  }

  std::string AddRing(const std::vector<SensorDef>& sensors, double frequency,
                      const std::string& model, Build& build) {
    RingDef ring;
    ring.frequency = std::min(frequency, 1000.0);
    ring.min_range = sensors[0].min_range;
    ring.range = sensors[0].range;
    // Stage looks along one ray; here a sensor has its whole cone. Beyond 170 degrees there is
    // none.
    ring.cone_deg = std::clamp(Degrees(sensors[0].fov), 0.5, 170.0);
    if (sensors.size() > 1000) sensors[0].at.Fail("a ring of more than 1000 sensors");
    for (const SensorDef& sensor : sensors) {
      CheckPlace({sensor.frame.pose.x, sensor.frame.pose.y, sensor.frame.z}, sensor.at);
      ring.mounts.push_back(
          {{sensor.frame.pose.x, sensor.frame.pose.y, sensor.frame.z}, sensor.frame.pose.yaw});
      if (sensor.min_range != ring.min_range || sensor.range != ring.range ||
          sensor.fov != sensors[0].fov) {
        Note(sensor.at, "sensors of one ring have the range and fov of the first here");
      }
      if (sensor.noise != 0.0) Note(sensor.at, "noise of a ring is not supported");
    }
    if (!build.def.sonar) {
      build.def.sonar = ring;
      return "sonar";
    }
    RangerDef ranger;
    ranger.name = ComponentName(model, build);
    ranger.ring = ring;
    build.def.rangers.push_back(ranger);
    return ranger.name;
  }

  // The floor is what all models and robots together cover; its bottom-left corner is the origin.
  void PlaceFloor(const std::optional<Vec2>& flat_size) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    Vec2 low{kInfinite, kInfinite};
    Vec2 high{-kInfinite, -kInfinite};
    const auto cover = [&](Vec2 point, double around) {
      low = {std::min(low.x, point.x - around), std::min(low.y, point.y - around)};
      high = {std::max(high.x, point.x + around), std::max(high.y, point.y + around)};
    };
    if (flat_size) {
      cover({0.5 * flat_size->x, 0.5 * flat_size->y}, 0.0);
      cover({-0.5 * flat_size->x, -0.5 * flat_size->y}, 0.0);
    }
    for (const Piece& piece : pieces_) {
      for (const Vec2 corner : piece.prism.outline) cover(Transform(piece.frame.pose, corner), 0.0);
    }
    const double around = pieces_.empty() && !flat_size ? kAroundRobots : kBesideRobots;
    for (const RobotDef& robot : world_.scenario.robots) {
      for (const Vec2 corner : robot.body->footprint) {
        cover(Transform(robot.pose, corner), around);
      }
    }
    if (low.x > high.x) {
      cover({0.0, 0.0}, kAroundRobots);
    }
    World& world = world_.scenario.world;
    world.size_x = high.x - low.x;
    world.size_y = high.y - low.y;
    world.origin = {-low.x, -low.y};
    if (!(world.size_x > 0.0 && world.size_y > 0.0 && world.size_x <= kFarthest &&
          world.size_y <= kFarthest && std::fabs(low.x) <= kFarthest &&
          std::fabs(low.y) <= kFarthest)) {
      file_.global.at.Fail(fmt::format(
          "the world is {} x {} m large, must be at most {} m; is a pose or a size wrong?",
          world.size_x, world.size_y, kFarthest));
    }
    Scenario& scenario = world_.scenario;
    const double cell = std::max(0.02, std::max(world.size_x, world.size_y) / 512.0);
    scenario.canvas.width = std::clamp(static_cast<int>(std::ceil(world.size_x / cell)), 1, 4096);
    scenario.canvas.height = std::clamp(static_cast<int>(std::ceil(world.size_y / cell)), 1, 4096);
    scenario.camera.position = {0.5 * world.size_x, 0.5 * world.size_y,
                                std::min(kFarthest, 1.5 * std::max(world.size_x, world.size_y))};
    scenario.camera.rotation = {};
    for (RobotDef& robot : scenario.robots) {
      robot.pose.x += world.origin.x;
      robot.pose.y += world.origin.y;
    }
  }

  // The box that a prism of four right angles is.
  static std::optional<Box> AsBox(const std::vector<Vec2>& outline) {
    if (outline.size() != 4) return std::nullopt;
    const Vec2 along = outline[1] - outline[0];
    const Vec2 across = outline[3] - outline[0];
    const Vec2 off = outline[2] - outline[1] - across;
    const double length = std::sqrt(Dot(along, along));
    const double width = std::sqrt(Dot(across, across));
    const double tolerance = 1e-9 * (length + width);
    if (std::sqrt(Dot(off, off)) > tolerance ||
        std::fabs(Dot(along, across)) > tolerance * std::max(length, width)) {
      return std::nullopt;
    }
    const Vec2 middle = 0.5 * (outline[0] + outline[2]);
    Box box;
    box.pose = {middle.x, middle.y,
                along.y == 0.0 && along.x > 0.0 ? 0.0 : Atan2(along.y, along.x)};
    box.size_x = length;
    box.size_y = width;
    return box;
  }

  void AddPieces() {
    World& world = world_.scenario.world;
    int id = 0;
    for (const Piece& piece : pieces_) {
      std::vector<Vec2> outline;
      for (const Vec2 corner : piece.prism.outline) {
        outline.push_back(Transform(piece.frame.pose, corner) + world.origin);
      }
      const double bottom = std::max(0.0, piece.frame.z + piece.prism.bottom);
      const double top = piece.frame.z + piece.prism.top;
      std::optional<Box> box = AsBox(outline);
      if (box && bottom < 1e-9) {
        box->id = ++id;
        box->kind = piece.kind;
        box->height = top;
        box->color = piece.color;
        box->solid = piece.solid;
        box->visible = piece.visible;
        world.boxes.push_back(*box);
        continue;
      }
      Mesh mesh = PrismMesh(outline, bottom, top);
      if (mesh.triangles.empty()) {
        Note(piece.at, "a part of this model crosses itself; its convex hull is taken");
        mesh = PrismMesh(HullOf(outline, outline.size() + 4), bottom, top);
      }
      if (mesh.triangles.empty()) continue;
      mesh.id = ++id;
      mesh.name = piece.kind;
      mesh.color = piece.color;
      mesh.solid = piece.solid;
      mesh.visible = piece.visible;
      world.meshes.push_back(std::move(mesh));
      if (piece.solid && bottom > kMeshTop) high_pieces_.emplace_back(bottom, piece.at);
    }
  }

  // An upright prism on an outline, as triangles.
  static Mesh PrismMesh(const std::vector<Vec2>& outline, double bottom, double top) {
    Mesh mesh;
    const std::vector<std::array<int, 3>> caps = Triangulate(outline);
    if (outline.size() < 3 || caps.empty()) return mesh;
    const int n = static_cast<int>(outline.size());
    const auto corner = [&mesh](int i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
    // A scenario takes no triangle without an area, and rounding can make one.
    const auto add = [&](int a, int b, int c) {
      const Vec3 normal = Cross(corner(b) - corner(a), corner(c) - corner(a));
      if (Dot(normal, normal) > 0.0) mesh.triangles.push_back({a, b, c});
    };
    for (const double z : {bottom, top}) {
      for (const Vec2 point : outline) mesh.vertices.push_back({point.x, point.y, z});
    }
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      add(i, next, n + next);
      add(i, n + next, n + i);
    }
    for (const auto& [a, b, c] : caps) {
      add(n + a, n + b, n + c);
      if (bottom > 0.0) add(c, b, a);
    }
    return mesh;
  }

  void FinishRobots() {
    const std::vector<std::string> problems = PlaceProblems(world_.scenario);
    for (std::size_t i = 0; i < world_.scenario.robots.size(); ++i) {
      const RobotDef& robot = world_.scenario.robots[i];
      double top = 0.0;
      for (const HullPart& part : robot.body->hull) top = std::max(top, part.top);
      for (const auto& [bottom, at] : high_pieces_) {
        if (bottom < top) {
          Note(at, fmt::format("what begins {} m above the floor stops no robot here, though {} is "
                               "higher",
                               bottom, Quoted(robot.name)));
        }
      }
      if (!problems[i].empty()) robots_at_[i].Fail(problems[i]);
    }
  }

  const PlayerFile& file_;
  std::string path_;
  const StageFiles& files_;
  StageWorld world_;
  std::vector<Piece> pieces_;
  std::vector<FilePlace> robots_at_;
  std::vector<std::pair<double, FilePlace>> high_pieces_;
  std::set<std::string> robot_names_;
  std::set<std::string> noted_;
};

}  // namespace

StageWorld ParseStageWorld(const std::string& text, const std::string& file,
                           const StageFiles& files) {
  const PlayerFile parsed = ParsePlayerFile(text, file, PlayerDialect::kWorld, files.read);
  return Importer(parsed, file, files).Import();
}

}  // namespace ccmorse::scene
