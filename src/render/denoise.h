#pragma once

#include "render/path_tracer.h"

namespace ccmorse::render {

/// The light over the albedo, channel by channel; an albedo counts as 0.04 at least, so that what a
/// coat reflects does not become huge over a dark base.
Vec3 OverAlbedo(const Vec3& light, const Vec3& albedo);

/// Smooths the light over the albedo where neither surface nor light has an edge: the edge-avoiding
/// a-trous wavelets of H. Dammertz et al. (HPG 2010), told by the samples' variance how far to go
/// (C. Schied et al., "Spatiotemporal variance-guided filtering", HPG 2017). `threads` >= 1.
void Denoise(Radiance& radiance, int threads);

}  // namespace ccmorse::render
