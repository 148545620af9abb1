#pragma once

#include <vector>

#include "scene/field.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// Reads a world in full: name, size [x, y], floor, kinds, boxes, meshes, docks, lights. `kinds`
/// gives the boxes of each kind their height, colour and mobility, which a single box may override;
/// without `kinds` every box says all of it. Throws Error.
World ReadWorld(const Field& field);

/// Reads the world file at `path`. Throws Error that names it.
World LoadWorld(const std::string& path);

/// The world as ReadWorld reads it, with all dynamic boxes down: which are up is the scenario's.
Json WorldToJson(const World& world);

/// A list of meshes as in a world, whose ids may be left out: they are numbered from 1. What they
/// are to robots and sensors is nothing. Throws Error.
std::vector<Mesh> ReadShape(const Field& field);
Json ShapeToJson(const std::vector<Mesh>& shape);

/// {"x": , "y": , "yaw": } (or "yaw_deg"); x and y must be given, yaw is 0 where it is not.
Pose2 ReadPose(const Field& field);
Json PoseToJson(const Pose2& pose);
Json VectorToJson(const Vec3& vector);

}  // namespace ccmorse::scene
