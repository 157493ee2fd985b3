#pragma once
// What a right device may have at a pixel, and why: a chapter of its story.

#include "verify/device/device_profile.h"
#include "verify/explain/explain_pixel.h"

namespace refraster {

/// Of the surface that our image shows at the pixel, shaded once at its centre, by a vertex shader that multiplies
/// three matrices; in linear radiance. Nothing where it shows none.
std::optional<BoundsStory> bounds_story(const Scene& scene, const ExplainRequest& request,
                                        const DeviceProfile& profile);

} // namespace refraster
