#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/asset_scene.h"

namespace ccmorse::assets {

using Bytes = std::vector<std::uint8_t>;

/// Gives the file that another one names, by a path relative to the latter; throws Error where
/// there is none or it is too large.
using FindFile = std::function<Bytes(const std::string& path)>;

// Each of these reads one format, whole, and throws Error "FILE: ..." that says where and why. The
// bytes may be anything: what is read costs memory in proportion to them, and never more than
// `limits`. Positions are finite. Thread safe.

/// Blender 2.60 to 2.79; others are tried, with a note. Packed by gzip or not. Modifiers,
/// armatures' deformation, curves and what is linked from other files are left out, with notes.
/// `find` gives the pictures that lie beside it; without, only those within it count.
AssetScene ReadBlend(Bytes bytes, const std::string& name, const AssetLimits& limits,
                     const FindFile& find = {});

/// glTF 2.0 as .gltf or .glb (Khronos, "glTF 2.0 specification"): triangles, strips and fans of the
/// file's scene; metres with y up there, z up here. No skins, morphs and compression extensions.
AssetScene ReadGltf(const Bytes& bytes, const std::string& name, const FindFile& find,
                    const AssetLimits& limits);

/// Wavefront OBJ with its .mtl; in metres with z up. Each o or g begins an object.
AssetScene ReadObj(std::string_view text, const std::string& name, const FindFile& find,
                   const AssetLimits& limits);

/// STL, binary or ASCII; in metres with z up.
AssetScene ReadStl(const Bytes& bytes, const std::string& name, const AssetLimits& limits);

/// COLLADA 1.4 and 1.5: geometry, its instances in the visual scene, diffuse colours; unit and up
/// axis as the file says.
AssetScene ReadCollada(const Bytes& bytes, const std::string& name, const AssetLimits& limits);

/// Is it packed by gzip (RFC 1952)?
bool IsGzip(const Bytes& bytes);
/// Unpacks it. Throws Error when it is broken, or more than `limit` bytes.
Bytes Gunzip(const Bytes& bytes, const std::string& name, std::size_t limit);

}  // namespace ccmorse::assets
