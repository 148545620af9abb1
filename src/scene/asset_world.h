#pragma once

#include <string>
#include <vector>

#include "assets/asset_scene.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// The meshes of the objects that the file shows, numbered from `first_id` on, in the world as they
/// lie. What collides in MORSE (specs: morse.md H.4) is solid and seen by sensors; what it hides is
/// not drawn, nor is a box that is called a sky, which would hide all else. Adds to `notes` what is
/// left out: what lies farther than 1 km from the origin.
std::vector<Mesh> MeshesOf(const assets::AssetScene& asset, int first_id,
                           std::vector<std::string>* notes = nullptr);

/// All of them as one mesh, each triangle in its own colour; without triangles where there are
/// none. Things that collide with nothing are in it, too, unless there is nothing else.
Mesh MergedMesh(const assets::AssetScene& asset);

/// A world around the meshes: the floor reaches as far as they do, and is drawn only where they do
/// not have a ground of their own. Throws Error when there is nothing to see or too much.
World WorldOf(const assets::AssetScene& asset, const std::string& name,
              std::vector<std::string>* notes = nullptr);

/// WorldOf(), read from a file. Throws Error.
World LoadAssetWorld(const std::string& path);

/// A scenario of such a file alone: no robots, and a camera that looks at it all.
Scenario ScenarioOfAsset(const std::string& path, std::vector<std::string>* notes = nullptr);

}  // namespace ccmorse::scene
