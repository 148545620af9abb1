#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/image.h"
#include "base/pose.h"
#include "render/camera.h"
#include "render/picture_scene.h"

namespace ccmorse::render {

struct RenderOptions {
  int width = 1280;     ///< pixels, 1..8192
  int height = 720;     ///< pixels, 1..8192
  int samples = 16;     ///< light paths a pixel, 1..65536; the noise goes with their root
  int bounces = 4;      ///< surfaces on a path, >= 1
  bool denoise = true;  ///< smooths what noise is left
  int threads = 0;      ///< 0: all cores; they change nothing but the time
  std::uint32_t seed = 1;
  /// Called now and then with the share that is done, 0..1; by one thread at a time.
  std::function<void(double done)> progress;
};

/// Light as a picture has it, before it is made to fit a screen. All (height x width), row 0 at the
/// top, linear r, g, b.
struct Radiance {
  int width = 0;
  int height = 0;
  std::vector<Vec3> light;           ///< what reaches the camera, without the fans
  std::vector<Vec3> albedo;          ///< of what is seen first; white where nothing is
  std::vector<Vec3> normal;          ///< of it; zero where nothing is
  std::vector<double> distance;      ///< m to it; 0 where nothing is
  std::vector<double> variance;      ///< of the mean luminance of the light over the albedo
  std::vector<Vec3> film;            ///< colour of the fans before it, times their opacity
  std::vector<double> film_through;  ///< share of light that the fans let through
};

/// Traces light paths from the camera: direct light from suns and spots with soft shadows, light of
/// the sky, and light from surface to surface (J. Kajiya, "The rendering equation", SIGGRAPH 1986;
/// glossy coats after B. Walter et al., "Microfacet models for refraction", EGSR 2007). Samples are
/// R2 sequences, shifted for each pixel, so that the result is a function of scene, camera and
/// options alone. Throws Error when an option is out of its range.
Radiance TracePaths(const PictureScene& scene, const Camera& camera, const RenderOptions& options);

/// The picture: TracePaths(), smoothed if asked for, the fans before it, and tones for a screen.
Image RenderPicture(const PictureScene& scene, const Camera& camera, const RenderOptions& options);

}  // namespace ccmorse::render
