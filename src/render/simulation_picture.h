#pragma once

#include <string>
#include <vector>

#include "render/camera.h"
#include "render/picture_scene.h"
#include "sim/simulation.h"

namespace ccmorse::render {

/// What a picture of a simulation shows.
struct PictureOptions {
  bool lasers = false;  ///< what laser scanners see, as fans
  bool canvas = true;   ///< the canvas on the ground
};

/// The simulation as it is now: floor with canvas, boxes that stand, meshes, robots with wheels and
/// scanners, and the world's lamps. Fills `scene`, which is empty; Build() is left to the caller.
void ShowSimulation(const sim::Simulation& simulation, const PictureOptions& options,
                    PictureScene& scene);

/// A camera by name: "scene" (the scenario's), "top", "follow" and "robot" (a robot's eyes), the
/// last two also with ":NAME" of a robot; without, the first by name. `aspect`: width over height
/// of the picture. Throws Error that lists the names.
Camera FindCamera(const sim::Simulation& simulation, const std::string& name, double aspect);

}  // namespace ccmorse::render
