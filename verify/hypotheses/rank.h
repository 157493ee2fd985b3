#pragma once
// Names the fault: hypotheses of what may be wrong are drawn at chosen pixels, and ranked by how many unexplained
// pixels each explains. docs/hypotheses.md lists them.

#include <refraster/image.h>
#include <refraster/render.h>

#include "verify/device/device_profile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace refraster::hypotheses {

/// A pixel that was judged. Values as the image that is judged stores them: 1 is white.
struct JudgedPixel {
  int x = 0, y = 0;
  Double3 actual{0}, reference{0};
  Double3 half_width{0}; ///< how far a right device may be from a colour there, quantisation included
};

/// Whether values below 0 and above 1 are stored as such.
enum class StoredRange { unit, any };

/// No more pixels of each kind are looked at.
inline constexpr std::size_t max_judged_pixels = 4096;

struct RankRequest {
  const Scene& scene; ///< as it is to be drawn
  int width = 0, height = 0, samples = 1;
  int threads = 0;                           ///< 0: as many as the machine has
  Transfer transfer = Transfer::linear;      ///< of the values
  StoredRange range = StoredRange::unit;     ///< of the values
  DeviceProfile device = {};                 ///< whose lattice, texel and level-of-detail errors are allowed for
  std::vector<JudgedPixel> unexplained = {}; ///< up to max_judged_pixels, chosen at random
  std::vector<JudgedPixel> explained = {};   ///< as many that pass
  std::uint64_t unexplained_in_image = 0;    ///< of which those are a part; for the text
  const Image<float>* actual = nullptr;      ///< the whole image: a shift by whole pixels is not found without
};

/// One hypothesis, or a pair.
struct Cause {
  std::vector<std::string> keys; ///< one, or two of a pair
  std::string text;              ///< a clause that says what is wrong
  double explained = 0;          ///< share of the unexplained pixels that it explains, in [0, 1]
  double kept = 0;               ///< share of the explained pixels of the same objects that stay explained, in [0, 1]

  /// What is ranked by: what it explains, less what it breaks.
  double score() const { return explained + kept - 1; }
};

struct Ranking {
  std::vector<Cause> causes; ///< the best first; those with a score above 0, five singles and five pairs at most
  std::vector<std::uint32_t> objects; ///< to which the unexplained pixels belong; hypotheses change these alone
  bool background = false;            ///< whether some belong to no object
  std::uint64_t unexplained_in_image = 0;
  std::size_t tried = 0; ///< hypotheses, pairs included

  /// The best, where it explains more than half of the pixels and breaks less than it explains; else null: no
  /// hypothesis covers what is wrong.
  const Cause* named() const;
};

/// Empty where nothing is unexplained: a scene that passes is never given a fault. Deterministic: the same for any
/// number of threads.
Ranking rank_hypotheses(const RankRequest& request);

/// "normals transformed by the model matrix instead of its inverse transpose: explains 99.8 % of 9,972 unexplained
/// pixels of `torus`".
std::string sentence(const Cause& cause, const Ranking& ranking, const Scene& scene);

} // namespace refraster::hypotheses
