#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ccmorse::tools {

/// What `ccmorse render` was asked for.
struct RenderArguments {
  std::string what;               ///< a scenario's name or path, or a record
  std::string out;                ///< PNG; "": the scenario's or record's name in this folder
  std::string camera = "scene";   ///< render::FindCamera
  std::vector<double> from;       ///< m, x y z: a place instead of a camera by name; empty: none
  std::vector<double> at;         ///< m, x y z: what it looks at; empty: the middle of the floor
  std::string size = "1280x720";  ///< pixels
  int samples = 32;               ///< light paths a pixel
  std::optional<double> time;     ///< s, simulated; a scenario's start, a record's end
  bool lasers = false;            ///< what laser scanners see
  bool canvas = true;
  bool noise = false;  ///< leaves the noise that light paths leave
  int threads = 0;     ///< 0: all cores
  bool quiet = false;
};

/// `ccmorse render`: a ray-traced picture of a scenario or of a moment of a record. Returns the
/// exit status. Throws Error for what the user can put right.
int Render(const RenderArguments& arguments);

}  // namespace ccmorse::tools
