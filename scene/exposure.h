#pragma once
// Exposure: how bright a picture of a scene is, before it is cut off at 1.

#include <refraster/scene.h>

namespace refraster {

/// Makes the scene's radiance 2^stops times what it is, and changes nothing else of its images: all that shines is
/// multiplied, lights, background, light of a material's own, and ka, which stands for ambient light. For whole stops
/// every value of an image is multiplied exactly, but where it leaves the range of its precision. What a fragment
/// function of the user's makes without light stays as it is.
void expose(Scene& scene, double stops);

} // namespace refraster
