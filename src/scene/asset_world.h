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

/// A name as scenarios have it: whatever is no letter, digit or '_' becomes '_', 64 at most.
std::string IdentifierOf(const std::string& name);

/// Gives the colour to that part of a mesh that has the largest surface of one colour: to what one
/// would call its colour.
void Paint(Color color, Mesh& mesh);

/// One object's mesh, without an id: what it is to robots, sensors and viewers as in MeshesOf().
Mesh MeshOf(const assets::AssetScene& asset, const assets::AssetObject& object);

/// All of them as one mesh, each triangle in its own colour; without triangles where there are
/// none. Things that collide with nothing are in it, too, unless there is nothing else.
Mesh MergedMesh(const assets::AssetScene& asset);

/// A world around the meshes: the floor reaches as far as they do, and is drawn only where they do
/// not have a ground of their own. Throws Error when there is nothing to see or too much.
World WorldOf(const assets::AssetScene& asset, const std::string& name,
              std::vector<std::string>* notes = nullptr);

/// Those of the file's objects that have game properties, which some sensors look for: name, place
/// and properties, and which of `world`'s meshes they are.
std::vector<PropDef> PropsOf(const assets::AssetScene& asset, const World& world);

/// WorldOf() and, into `props`, PropsOf(), read from a file. Throws Error.
World LoadAssetWorld(const std::string& path, std::vector<PropDef>* props = nullptr);

/// A scenario of such a file alone: no robots, and a camera that looks at it all.
Scenario ScenarioOfAsset(const std::string& path, std::vector<std::string>* notes = nullptr);

}  // namespace ccmorse::scene
