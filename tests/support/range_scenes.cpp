#include "tests/support/range_scenes.h"

namespace ccmorse::testing {

std::string SonarScene() {
  return R"({"world": "syrotek", "obstacles": {"up": [69, 70, 71, 72, 73, 74, 75, 76]},
  "robots": [
    {"name": "a", "pose": {"x": 1.2, "y": 2.0, "yaw_deg": 30}, "sonar": true},
    {"name": "b", "pose": {"x": 2.0, "y": 2.1, "yaw_deg": 100}, "sonar": true, "front": "sensors"},
    {"name": "c", "pose": {"x": 3.1, "y": 1.0, "yaw_deg": 80},
     "sonar": {"frequency": 20, "cone_deg": 30, "range": 2.0}}]})";
}

std::string InfraredScene() {
  return R"({"world": "syrotek", "robots": [
    {"name": "a", "pose": {"x": 0.5, "y": 2.0, "yaw_deg": 180}, "ir": true},
    {"name": "b", "pose": {"x": 3.1, "y": 0.3, "yaw_deg": -90}, "ir": true, "front": "sensors"},
    {"name": "c", "pose": {"x": 3.1, "y": 0.55, "yaw_deg": 90}, "ir": {"frequency": 30}}]})";
}

std::string MeshScene() {
  return R"({"world": {"name": "hall", "size": [6, 6],
  "boxes": [
    {"id": 1, "kind": "wall", "x": 3, "y": 0.05, "size": [6, 0.1], "height": 0.5, "color": "gray"},
    {"id": 2, "kind": "wall", "x": 3, "y": 5.95, "size": [6, 0.1], "height": 0.5, "color": "gray"},
    {"id": 3, "kind": "wall", "x": 0.05, "y": 3, "size": [0.1, 6], "height": 0.5, "color": "gray"},
    {"id": 4, "kind": "wall", "x": 5.95, "y": 3, "size": [0.1, 6], "height": 0.5, "color": "gray"},
    {"id": 5, "kind": "crate", "x": 4.2, "y": 1.6, "yaw_deg": 30, "size": [0.4, 0.3],
     "height": 0.16, "color": "brown"}],
  "meshes": [
    {"id": 11, "name": "ramp", "color": "olive",
     "vertices": [[0, 0, 0], [1.2, 0, 0], [1.2, 0.8, 0], [0, 0.8, 0], [1.2, 0, 0.4], [1.2, 0.8, 0.4]],
     "triangles": [[0, 1, 4], [3, 5, 2], [1, 2, 5], [1, 5, 4], [0, 4, 5], [0, 5, 3]],
     "position": [3.4, 3.2, 0], "rotation": [0, 0, 0.35]},
    {"id": 12, "name": "pyramid", "color": "orange",
     "vertices": [[-0.4, -0.4, 0], [0.4, -0.4, 0], [0.4, 0.4, 0], [-0.4, 0.4, 0], [0, 0, 0.7]],
     "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
     "position": [1.5, 4.2, 0], "rotation": [0, 0, 0.6]},
    {"id": 13, "name": "table", "color": "brown",
     "vertices": [[-0.5, -0.3, 0], [0.5, -0.3, 0], [0.5, 0.3, 0], [-0.5, 0.3, 0]],
     "triangles": [[0, 1, 2], [0, 2, 3]],
     "position": [2.0, 1.5, 0.3], "rotation": [0.1, -0.05, 0.2]}]},
  "robots": [
    {"name": "level", "pose": {"x": 1.2, "y": 2.6, "yaw_deg": 40}},
    {"name": "tilted", "pose": {"x": 2.6, "y": 2.4, "yaw_deg": 10},
     "laser": {"preset": "sick", "pitch_deg": 15, "roll_deg": 5, "position": [0.03, 0, 0.3]}},
    {"name": "layers", "type": "BoxRobot", "pose": {"x": 4.6, "y": 2.4, "yaw_deg": 120},
     "laser": {"preset": "sick_ldmrs", "frequency": 10, "layer_separation": 3}},
    {"name": "rings", "pose": {"x": 1.4, "y": 3.4, "yaw_deg": 90}, "front": "sensors",
     "ir": {"range": 0.8}, "sonar": true}]})";
}

std::string ObstaclesUpScene() {
  return R"({"world": "syrotek", "obstacles": {"up": [
    5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 56, 57, 59, 61, 63, 65, 66, 67,
    68, 69, 70, 71, 72, 73, 74, 75, 76]},
  "robots": [{"name": "a", "pose": {"x": 1.2, "y": 2.0, "yaw_deg": 150}},
             {"name": "b", "pose": {"x": 3.14, "y": 2.4, "yaw_deg": 60}}]})";
}

std::vector<RangeScene> RangeScenesForTests() {
  return {{"Sonar", SonarScene()},
          {"Infrared", InfraredScene()},
          {"Mesh", MeshScene()},
          {"ObstaclesUp", ObstaclesUpScene()}};
}

}  // namespace ccmorse::testing
