#pragma once
// What there is to choose from when a scene goes through OpenGL.

#include <refraster/fields.h>

#include <string_view>
#include <utility>

namespace refraster {

/// Who draws: one of Mesa's software drivers, or whatever the machine has.
enum class GlRenderer { system_default, llvmpipe, softpipe };

template <>
struct EnumNames<GlRenderer> {
  static constexpr std::pair<GlRenderer, std::string_view> names[] = {
      {GlRenderer::system_default, "default"},
      {GlRenderer::llvmpipe, "llvmpipe"},
      {GlRenderer::softpipe, "softpipe"},
  };
};

/// How our GLSL reads a measured table between its samples.
///   manual    texelFetch and arithmetic in float, as shading/merl_lookup.h has it
///   hardware  the sampler's own linear filter, which may compute with 8-bit weights
enum class MerlFilter { manual, hardware };

template <>
struct EnumNames<MerlFilter> {
  static constexpr std::pair<MerlFilter, std::string_view> names[] = {{MerlFilter::manual, "manual"},
                                                                      {MerlFilter::hardware, "hardware"}};
};

} // namespace refraster
