#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/json.h"
#include "base/pose.h"
#include "scene/magnetic_field.h"
#include "scene/player/player_setup.h"

namespace ccmorse::scene {

/// One box of the world: upright, on the floor (thesis 4.1.1; specs: syrotek.md B).
struct Box {
  int id = 0;  ///< unique in the world, from 1
  /// In SyRoTek's arena "border", "dock_separator", "static", "dynamic_slab" or "dynamic_pillar".
  std::string kind;
  Pose2 pose;            ///< centre, m, and yaw, rad
  double size_x = 0.0;   ///< m, along the box's own x, > 0
  double size_y = 0.0;   ///< m, along the box's own y, > 0
  double height = 0.0;   ///< m, > 0; from the floor up
  Color color;           ///< what a viewer shows
  bool dynamic = false;  ///< can be raised and lowered
  bool raised = true;    ///< stands in the world; always true for what is not dynamic
  bool solid = true;     ///< robots run into it
  bool visible = true;   ///< sensors see it
};

/// A body of triangles, standing or hanging anywhere (design: Rays). Seen from both sides; robots
/// run into what of it lies at their height (mesh.h).
struct Mesh {
  int id = 0;                                 ///< unique among the world's boxes and meshes, from 1
  std::string name;                           ///< for people; "" where none is given
  std::vector<Vec3> vertices;                 ///< m, in the mesh's own frame
  std::vector<std::array<int, 3>> triangles;  ///< indexes of vertices; each has an area
  Vec3 position;                              ///< m, of the mesh's origin in the world
  Vec3 rotation;                              ///< roll, pitch, yaw, rad: Rz(yaw) Ry(pitch) Rx(roll)
  Color color{160, 160, 160};                 ///< what a viewer shows
  std::vector<Color> palette;  ///< further colours, for triangles that have their own
  std::vector<int> color_of;   ///< index of palette by triangle; empty: all `color`
  bool solid = true;           ///< robots run into it
  bool visible = true;         ///< sensors see it
  bool drawn = true;           ///< a viewer shows it
};

/// A lamp of the world (thesis 4.1.1, W07); only views use it.
struct Light {
  std::string kind;      ///< "sun" or "spot"
  Vec3 position;         ///< m; for the sun, the direction it shines from
  double energy = 1.0;   ///< relative, >= 0
  bool shadows = false;  ///< casts shadows
};

/// The world: a rectangular floor with boxes on it. The origin is the floor's bottom-left corner,
/// unless `low` says where else that corner is: MORSE's worlds lie around (0, 0).
struct World {
  std::string name;     ///< "syrotek"
  double size_x = 0.0;  ///< m, > 0
  double size_y = 0.0;  ///< m, > 0
  Vec2 low;             ///< m, of the floor's bottom-left corner
  /// The floor is drawn, and beams end at it. Without, meshes are the ground, and the floor is only
  /// where robots may stand.
  bool has_floor = true;
  /// Where the origin of coordinates lies that Player's clients know, m: what Stage calls (0, 0) is
  /// the middle of most of its worlds, here it is `origin` (specs: player.md C.3).
  Vec2 origin;
  Color floor{255, 255, 255};
  /// Robots that stand on the ground follow the height of the meshes beneath them (sim/ground.h).
  bool terrain = false;

  Vec2 high() const { return {low.x + size_x, low.y + size_y}; }  ///< m, of the other corner
  Vec2 middle() const { return {low.x + size_x / 2.0, low.y + size_y / 2.0}; }  ///< m, of the floor

  std::vector<Box> boxes;    ///< in order of id
  std::vector<Mesh> meshes;  ///< in order of id
  std::vector<Pose2> docks;  ///< parking places, m and rad: in the bay, facing out of it
  std::vector<Light> lights;
};

/// A laser scanner with MORSE's parameters (specs: morse.md H.4; thesis 4.1.2).
/// Where a file gives window or resolution but no samples, MORSE's rule counts the beams: from
/// -window/2 in steps of the resolution while not beyond +window/2. The thesis's 270 deg / 0.39589
/// would be 683 by that rule, but the thesis and its program say 682, so the default says it, too.
/// Samples without resolution spread from edge to edge of the window; samples and resolution
/// without a window make their own, around straight ahead.
/// "preset": "urg04lx" in a file stands for the device as sold: 682 beams of 360/1024 deg, 5.6 m;
/// "hokuyo", "sick", "sick_ldmrs" and "infrared" for MORSE's scanners of these names.
struct LaserDef {
  Vec3 position{0.035, 0.0, 0.0};   ///< on the robot, m; z from the robot's origin
  double roll = 0.0;                ///< on the robot, rad
  double pitch = 0.0;               ///< on the robot, rad; positive looks down
  double yaw = 0.0;                 ///< on the robot, rad
  double frequency = 10.0;          ///< Hz, > 0
  double scan_window_deg = 270.0;   ///< degrees, (0, 360]
  double resolution_deg = 0.39589;  ///< degrees from beam to beam, > 0
  double range = 5.0;               ///< m, > 0; what a beam without a hit returns
  double range_std = 0.0;           ///< m, >= 0: standard deviation of a hit's noise
  int layers = 1;                   ///< fans above each other, 1..128; samples counts one of them
  double layer_separation = 0.8;    ///< degrees from layer to layer, around the level
  double layer_offset = 0.125;  ///< degrees that layers 0, 2, ... are turned left; not a lone one
  bool visible_arc = false;     ///< drawn by a viewer
  int samples = 682;            ///< beams, 2..10000; first at -window/2, counter-clockwise
};

/// One range sensor of a ring, on its robot.
struct RingMount {
  Vec3 position;     ///< m; z from the robot's origin
  double yaw = 0.0;  ///< rad
};

/// A ring of range sensors around a robot, infra-red or sonar: each gives the distance to the
/// nearest thing in its cone (specs: syrotek.md A).
struct RingDef {
  double frequency = 10.0;  ///< Hz, > 0
  double min_range = 0.05;  ///< m, >= 0: what anything nearer returns
  double range = 5.0;       ///< m, > min_range: what a sensor returns that sees nothing
  double cone_deg = 50.0;   ///< degrees, full opening angle of the cone, (0, 170]
  /// Where they sit, 1 to 1000 of them; empty: where the robot's type has them.
  std::vector<RingMount> mounts;
};

/// One more scanner or ring of a robot that has more of them than a laser, ir and sonar.
struct RangerDef {
  std::string name;               ///< of the component, unlike all others of the robot
  std::optional<LaserDef> laser;  ///< either this
  std::optional<RingDef> ring;    ///< or this, with mounts
};

/// An upright prism of a robot's hull.
struct HullPart {
  std::vector<Vec2> outline;  ///< m, convex, counter-clockwise, in the robot's frame
  double bottom = 0.0;        ///< m above the floor
  double top = 0.0;           ///< m above the floor
};

/// A wheel of a dynamic robot: a body of its own, held by the robot's (specs: morse.md H.1).
struct WheelDef {
  Vec3 position;                 ///< m, of its middle in the robot's frame
  double radius = 0.1;           ///< m, > 0
  double width = 0.05;           ///< m, > 0, along the robot's y
  double mass = 1.0;             ///< kg, > 0
  double friction = 0.5;         ///< >= 0, multiplied by that of the ground
  double linear_damping = 0.04;  ///< share of its speed that it loses in a second, 0..1
  double angular_damping = 0.1;  ///< likewise
  std::string drive;  ///< "left" or "right": by a motor; "free": it rolls; "ball": a caster
};

/// Springs, rays for wheels and forces where they touch the ground, as Bullet's vehicles have them:
/// what SteerForce drives (specs: morse.md H.1, Hummer). Two wheels in front, which steer, two
/// behind.
struct VehicleDef {
  double front = 1.0;            ///< m from the robot's origin forwards, of the front axle
  double rear = -1.0;            ///< m, of the rear axle
  double half_track = 0.5;       ///< m from the middle to a wheel, > 0
  double height = 0.0;           ///< m, of where springs are fixed, in the robot's frame
  double wheel_radius = 0.5;     ///< m, > 0
  double rest_length = 0.3;      ///< m, of a spring without load, > 0
  double stiffness = 15.0;       ///< N/m a kg of the robot, >= 0
  double damping = 10.0;         ///< Ns/m a kg of the robot, of a spring that stretches, >= 0
  double compression = 2.0;      ///< likewise, of one that is pressed together
  double friction = 200.0;       ///< most of a wheel's force along the ground, of its load, >= 0
  double roll_influence = 0.05;  ///< 0: forces sideways do not roll the robot, to 1: as they are
};

/// A body that forces move: how MORSE's robots are in Blender's game engine (design: Physics;
/// specs: morse.md H).
struct DynamicsDef {
  /// "rigid": moved by Bullet; "free": without physics, but anywhere in space, where its actuators
  /// put it.
  std::string kind = "rigid";
  double bottom = 0.0;           ///< m, of what touches, in the robot's frame
  double top = 0.5;              ///< m, > bottom, likewise
  double friction = 0.5;         ///< >= 0, multiplied by that of what it touches
  double linear_damping = 0.04;  ///< share of its speed that it loses in a second, 0..1
  double angular_damping = 0.1;  ///< likewise
  /// False: it is pushed up by as many newtons as gravity has m/s^2, which is its weight where its
  /// mass is 1 kg (MORSE's NoGravity).
  bool gravity = true;
  bool ground = false;           ///< commands leave its fall and its tilt alone (GroundRobot)
  double roll = 0.0;             ///< rad, at the start
  double pitch = 0.0;            ///< rad, likewise
  double turning_track = 0.0;    ///< m, what MORSE calls FixTurningSpeed; 0: its wheels' track
  std::vector<WheelDef> wheels;  ///< none: it slides
  std::optional<VehicleDef> vehicle;
};

/// The body of a robot of type "Custom": what a model of robots.h says of the others.
struct BodyDef {
  std::vector<HullPart> hull;   ///< what scanners of others see: 0 or more of 3..64 corners
  std::vector<Vec2> footprint;  ///< m, convex, counter-clockwise, 3..16 corners: what touches
  double mass = 10.0;           ///< kg, > 0
  std::string drive = "diff";   ///< "diff", "omni" or "car" (specs: player.md C.3)
  double wheelbase = 1.0;       ///< m, > 0, of a car
  double max_speed = 1.0;       ///< m/s, > 0; commands are clamped to it
  double max_side_speed = 0.0;  ///< m/s, >= 0; more than 0 only for "omni"
  double max_turn_rate = 1.5;   ///< rad/s, > 0; commands are clamped to it
  double origin_height = 0.0;  ///< m above the floor, >= 0: where the robot's frame lies, or starts
  /// What viewers show in place of the hull, in the robot's own frame; empty: the hull. Nothing
  /// touches it and no sensor sees it: that is what the hull is for.
  std::vector<Mesh> shape;
  bool flies = false;  ///< stays at its height where others follow the ground (World::terrain)
  std::optional<DynamicsDef> dynamics;  ///< of a dynamic robot; all others are kinematic
};

/// What a robot's odometry reports (specs: player.md C.3, localization "odom").
struct OdometryDef {
  Pose2 start;  ///< what it reports at the start, m and rad
  /// Largest gain errors forward, sideways and in turning, 0..1: each run draws its own within half
  /// of them to either side, by its seed.
  Vec3 error;
};

/// How a worn robot's turning differs from what it is told: one wheel is smaller than the other,
/// and the motors answer late. It turns at w + pull * v, where dw/dt = (told - w) / turn_lag.
struct WearDef {
  double pull = 0.0;      ///< rad/m, to the left of a robot that goes forward
  double turn_lag = 0.0;  ///< s, >= 0: time constant of its turning
  bool operator==(const WearDef&) const = default;
};

/// The noise of a robot's pose sensor, with the names of MORSE's PoseNoise modifier (specs:
/// morse.md B.5): what it adds to each fresh pose, normally distributed.
struct PoseNoiseDef {
  double pos_std = 0.0;  ///< m, >= 0, on x and y each
  double rot_std = 0.0;  ///< rad, >= 0, on yaw
};

/// A service of a component of one's own, as clients see it (specs: morse.md A.5).
struct OwnServiceDef {
  struct Parameter {
    std::string name;
    bool optional = false;
  };
  std::string name;
  std::vector<Parameter> parameters;
  bool asynchronous = false;  ///< answers later
};

/// The code of a component that a user has written, and what is to be known of it where the code
/// cannot run: a record is simulated again without it (docs/components.md).
struct OwnDef {
  std::string language;              ///< "python", or "c++" for a plug-in
  std::string kind;                  ///< "sensor" or "actuator"
  std::string code;                  ///< "package.module.Class", or the path of the plug-in's file
  std::vector<std::string> path;     ///< folders where Python looks for it first
  std::string level;                 ///< of realism, among its own; "": the one as delivered
  Json data = Json(Json::Object{});  ///< its fields in order, with their first values
  Json properties = Json(Json::Object{});  ///< name to value as delivered: number, text or flag
  std::vector<OwnServiceDef> services;
};
/// Something that changes a component's numbers on their way out, or an actuator's on their way in:
/// MORSE's alter() (specs: morse.md B.5; docs/morse.md, Modifiers).
struct ModifierDef {
  std::string type;  ///< one of ModifierTypes()
  /// By MORSE's names, an object; what is not there has its default.
  Json settings = Json(Json::Object{});
};

/// The types of modifier that the simulator has, sorted.
const std::vector<std::string>& ModifierTypes();

/// A user's class of Python that offers the services of a component in another form, under a name
/// of its own: MORSE's add_overlay() (specs: morse.md C.8; docs/components.md).
struct OverlayDef {
  std::string code;                      ///< "package.module.Class"
  std::vector<std::string> path;         ///< folders where Python looks for it first
  Json settings = Json(Json::Object{});  ///< arguments of its constructor by name, an object
  std::vector<OwnServiceDef> services;
};

/// One device of a robot that has others than those of its type, as a MORSE builder script mounts
/// it (specs: morse.md C.2; docs/morse.md).
struct ComponentDef {
  std::string name;         ///< after the robot's, unique there; dots where nested ("arm.tool")
  std::string type;         ///< one of ComponentTypes(); with `own` the name of its class
  double frequency = 60.0;  ///< Hz, > 0
  Vec3 position;            ///< on the robot, m, in its frame
  Vec3 rotation;            ///< there: roll, pitch, yaw, rad
  bool stream = true;       ///< has a port of its own (MORSE's add_stream)
  bool services = true;     ///< answers on the service port (MORSE's add_service)
  PoseNoiseDef noise;       ///< of a Pose
  LaserDef laser;           ///< of a LaserScanner or VelodyneRayCast; mounted, timed as above
  std::string level;        ///< of realism, one of LevelsOf(type); "": the one as delivered
  /// MORSE's properties that differ from what the type is delivered with, by MORSE's names, an
  /// object; those that the simulator's type has not are of no effect.
  Json properties = Json(Json::Object{});
  std::optional<OwnDef> own;  ///< the user's code, where it is none of the simulator's types
  std::vector<ModifierDef> modifiers;  ///< in the order in which they work
  std::vector<OverlayDef> overlays;
};

/// The types of component that the simulator has, sorted, by MORSE's names.
const std::vector<std::string>& ComponentTypes();

/// The devices that robots of a type may go without (RobotDef::without), sorted.
const std::vector<std::string>& RemovableDevices();

/// What robots may do themselves, sorted: "grasp" of MORSE's Human, "heal" of its Victim.
const std::vector<std::string>& RobotSkills();

/// MORSE's levels of realism of a type, the one as delivered first; empty where there is one only.
std::vector<std::string> LevelsOf(const std::string& type);

/// Something from a model file that stands in the world: MORSE's passive object. Its shapes are
/// among the world's meshes.
struct PropDef {
  std::string name;
  /// Of the model: a path of a file of shapes, or what MORSE calls it, which is only kept.
  std::string file;
  std::string object;       ///< of the file's objects only those whose names start so; "": all
  Vec3 position;            ///< m
  Vec3 rotation;            ///< roll, pitch, yaw, rad
  std::vector<int> meshes;  ///< ids of the world's meshes that it is made of
  /// MORSE's properties of it, by name, an object: some sensors look for them.
  Json properties = Json(Json::Object{});
};

/// A box of space with a meaning: MORSE's Zone (specs: morse.md B.6). Lies along the axes.
struct ZoneDef {
  std::string type;  ///< "Charging" is one that a battery knows
  Vec3 position;     ///< m, of its middle
  Vec3 half_size;    ///< m, half of its extents, >= 0
};

/// Where on the Earth the world lies (specs: morse.md B.2, GPS): WGS84, of the world's origin.
struct GeodesyDef {
  double longitude = 0.0;  ///< degrees, positive east, -180..180
  double latitude = 0.0;   ///< degrees, positive north, -90..90
  double altitude = 0.0;   ///< m above the ellipsoid
  /// Degrees clockwise from north to the world's x axis: as delivered x points east.
  double angle_against_north = 90.0;
};

/// What one robot carries under Player's names (thesis 3.2: "indexes of proxies available").
/// interface name -> index -> device of the robot that serves it, for example
/// position2d: {0: "pose", 2: "pose", 3: "odometry"}, laser: {0: "hokuyo"}.
using ProxyTable = std::map<std::string, std::map<int, std::string>>;

/// One robot of the scenario.
struct RobotDef {
  /// Unique, 1 to 64 letters, digits or _ (thesis 4.1.2: no two alike). In a file without,
  /// robots[0] is s1r, robots[1] is s1r_2, and so on.
  std::string name = "s1r";
  std::string type = "S1R";  ///< a type of robots.h
  Pose2 pose;                ///< start, m and rad; (1.20, 2.00, 150 deg) in a file without
  /// m: where it stands at the start when the ground has several storeys there (World::terrain), or
  /// how high it flies.
  double z = 0.0;
  Color color{60, 110, 190};
  ProxyTable proxies;                   ///< defaults of the type where not given
  std::map<std::string, Json> drivers;  ///< driver name ("snd") -> object of its settings, as given
  /// What its front bay holds: "laser", or "sensors", the module with three more infra-red sensors
  /// and sonars in the laser's place (thesis 2.1; specs: syrotek.md A).
  /// "none" for a Custom robot without laser.
  std::string front = "laser";
  LaserDef laser;                  ///< mounted where front is "laser"
  std::optional<RingDef> ir;       ///< mounted where given
  std::optional<RingDef> sonar;    ///< mounted where given
  std::vector<RangerDef> rangers;  ///< and these
  PoseNoiseDef pose_noise;
  OdometryDef odometry;
  WearDef wear;
  /// Devices of its type that it has not, of RemovableDevices(): a task may hide where it is.
  std::vector<std::string> without;
  std::optional<BodyDef> body;  ///< of a robot of type "Custom", and of no other
  /// All its devices where it has not those of its type; then front is "none".
  std::optional<std::vector<ComponentDef>> components;
  /// MORSE's properties of it, by name, an object: some sensors of others look for them.
  Json properties = Json(Json::Object{});
  bool services = false;  ///< answers on the service port itself (MORSE's add_service of a robot)
  /// Of RobotSkills(): what it does itself when its services are asked for it (specs: morse.md
  /// B.4).
  std::vector<std::string> skills;
};

/// The grid-map canvas (thesis 4.2.1).
struct CanvasDef {
  int width = 172;              ///< cells, 1..4096
  int height = 186;             ///< cells, 1..4096
  double alpha = 1.0;           ///< 0 transparent .. 1 opaque, fixed at start
  std::string mode = "ground";  ///< "ground", "minimap" or "fullscreen"
  bool mode_switching = true;   ///< may the user change the mode
};

/// The viewer's camera at start: MORSE's set_camera_location and set_camera_rotation.
struct CameraDef {
  Vec3 position{1.71, -3.2, 4.2};  ///< m
  Vec3 rotation{0.75, 0.0, 0.0};   ///< Euler angles XYZ, rad; (0,0,0) looks straight down
};

/// Simulated time (thesis 3.2 "simulation-time strategy"; design: Time).
struct TimeDef {
  double frequency = 60.0;  ///< ticks per simulated second, Hz, 1..1000
  /// Pace: "realtime", "lockstep" or "max". A file may say as MORSE does: "best_effort" for
  /// realtime, "fixed_simulation_step" for max.
  std::string strategy = "realtime";
  double factor = 1.0;           ///< simulated seconds per wall second in real time, 0.001..1000
  double read_frequency = 10.0;  ///< how often a client's Read() gets data, Hz, 0.01..frequency
  double end = 0.0;              ///< s of simulated time after which a run stops; 0: never
  /// MORSE's time_sync of sockets (specs: morse.md A.6): while a client is connected to this port a
  /// tick waits for bytes from it. 0: there is none.
  int sync_port = 0;
};

/// A scene that several simulators share, each with some of its robots (specs: morse.md A.7).
struct MultinodeDef {
  std::string server = "localhost";                       ///< host of the server between them
  int port = 65000;                                       ///< of that server
  std::map<std::string, std::vector<std::string>> nodes;  ///< name -> its robots
};

/// What moves dynamic robots (specs: morse.md H.2).
struct PhysicsDef {
  double gravity = 9.81;  ///< m/s^2 downwards, 0..1000
  int substeps = 2;       ///< of a tick, 1..20; of less than 60 Hz there are as many more
  double friction = 0.5;  ///< of the ground and of what stands, >= 0
};

/// What is done to dynamic boxes at once (thesis 5.1: the arena controller): first the preset, then
/// the lists.
struct ObstacleAction {
  std::string preset;       ///< "": none
  std::vector<int> up;      ///< ids that rise
  std::vector<int> down;    ///< ids that go down
  std::vector<int> toggle;  ///< ids that do the one or the other
  std::string say;          ///< a line for the log; "": none
};

/// An action by time (N03).
struct ObstacleTimer {
  double at = 0.0;     ///< s of simulated time, >= 0
  double every = 0.0;  ///< s, > 0, until it happens again; 0: it does not
  ObstacleAction action;
};

/// An action whenever a robot's origin comes into a region (N04).
struct ObstacleTrap {
  std::string name;          ///< for the log
  std::vector<Vec2> region;  ///< m, 3..64 corners of a polygon
  std::string robot;         ///< only this one; "": any
  bool once = false;         ///< the first time only
  ObstacleAction action;
};

/// How a dynamic box moves: evenly from point to point. Where a robot is in its way it waits.
struct ObstaclePath {
  int box = 0;  ///< id
  struct Point {
    double time = 0.0;  ///< s of simulated time, growing
    Pose2 pose;         ///< m and rad
  };
  std::vector<Point> points;  ///< two or more
  bool repeat = false;        ///< starts anew at the last point's time
};

/// What happens to dynamic boxes during a run.
struct ObstacleRules {
  std::map<std::string, std::vector<int>>
      presets;  ///< name -> ids that are up, all others down (N02)
  std::vector<ObstacleTimer> timers;
  std::vector<ObstacleTrap> traps;
  std::vector<ObstaclePath> paths;
};

/// Everything a run starts from. The defaults are those of an empty file: the SyRoTek arena with
/// all dynamic obstacles down and one S1R in it.
struct Scenario {
  std::string name;  ///< file name without folder and ending
  World world;
  /// The model file that the world stands in for, a path or a name of MORSE's; "": none. Only kept.
  std::string environment;
  std::vector<PropDef> props;
  std::vector<ZoneDef> zones;
  std::optional<GeodesyDef> geodesy;  ///< where it is said
  std::optional<PhysicsDef> physics;  ///< where it is said
  MagneticFieldDef magnetic_field;    ///< of the Earth: a dipole where none is given
  ObstacleRules obstacles;
  std::vector<RobotDef> robots;
  CanvasDef canvas;
  CameraDef camera;
  TimeDef time;
  std::uint64_t seed = 1;                 ///< of all noise, 0..2^63-1
  std::optional<PlayerSetup> player;      ///< what Player's clients are served, where it is said
  std::optional<MultinodeDef> multinode;  ///< where it is said
};

/// Reads and checks a scenario. `file` names it in messages; names of files in it start from the
/// folder of `file`. "world" is a world's name ("syrotek"), {"file": "..."} or a world in full; all
/// that a scenario leaves out has a default; the file of a world or a mesh may be one of shapes,
/// such as MORSE's .blend (assets/load.h), which is also looked for in MORSE's folders. Throws
/// Error "FILE:LINE: ..." with the key and the nearest known one, also for a robot that stands in a
/// raised box, in another robot or beside the floor.
Scenario ParseScenario(const std::string& text, const std::string& file);
Scenario LoadScenario(const std::string& file);

/// What is wrong with where each of the robots stands, "robot 'r0' at (1, 2) overlaps ...": beside
/// the floor, in a box, a mesh or one of the robots before it; "" for those with whom nothing is.
std::vector<std::string> PlaceProblems(const Scenario& scenario);

/// The names of a robot's components that have data for Player's interface: "position2d" is served
/// by pose and odometry, "laser" by scanners, "sonar" and "ir" by rings, "ranger" by both.
std::vector<std::string> DevicesFor(const RobotDef& robot, const std::string& interface);

/// The scenario with all defaults filled in, in the same form that ParseScenario reads; the world
/// is written out in full, so the text needs no other file.
Json ToJson(const Scenario& scenario);

/// Where `name` is found: a path that exists; else NAME.json in a folder of worlds/ (NAME may be
/// written folder/NAME, and a folder's own name means the scenario of that name in it). Looks in
/// $CCMORSE_WORLDS, ../share/ccmorse/worlds from the program's folder, the source tree it was built
/// from, and where it was to be installed. Throws Error that names the places looked at and the
/// scenarios there are.
std::string FindScenario(const std::string& name);

/// Names that FindScenario knows, sorted, one for each scenario: NAME, or folder/NAME where several
/// folders have a NAME.
std::vector<std::string> ListScenarios();

}  // namespace ccmorse::scene
