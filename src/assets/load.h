#pragma once

#include <string>
#include <vector>

#include "assets/asset_scene.h"

namespace ccmorse::assets {

/// Whether LoadAsset reads files of this name's ending: .blend, .gltf, .glb, .obj, .stl, .dae, in
/// small letters or large.
bool IsAssetName(const std::string& name);

/// The path of the file that `name` means: as it is, when absolute; else in `folder`, then below
/// each folder of $MORSE_RESOURCE_PATH (a list with ':'), then below /usr/share/morse/data, MORSE's
/// own. Throws Error that names the places looked at.
std::string FindAsset(const std::string& name, const std::string& folder);

/// What LoadAsset did, for people.
struct LoadReport {
  bool from_cache = false;
  double seconds = 0.0;  ///< wall-clock time it took
};

/// Reads a file of shapes. What was read before and has not changed since comes from the cache in
/// $XDG_CACHE_HOME/ccmorse (~/.cache/ccmorse without it), which CCMORSE_CACHE=off turns off; a
/// cache that is broken or cannot be written costs time and nothing else. Throws Error "FILE: ...".
/// Thread safe.
AssetScene LoadAsset(const std::string& path, const AssetLimits& limits = {},
                     LoadReport* report = nullptr);

}  // namespace ccmorse::assets
