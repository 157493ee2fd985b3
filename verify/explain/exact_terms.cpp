// A full instantiation of shading in 60 digits: in a file of its own.

#include "verify/explain/fragment_story.h"
#include "verify/explain/fragment_terms.h"

namespace refraster {

ExactTerms exact_terms(const FrameContext& context, std::uint32_t number, std::int32_t x, std::int32_t y) {
  const FragmentTerms<Exact> terms = fragment_terms<Exact>(context, number, x, y);
  ExactTerms result{plain(terms.ambient), {}, plain(terms.radiance)};
  for (const LightTerm<Exact>& light : terms.lights) result.reflected.push_back(plain(light.reflected));
  return result;
}

} // namespace refraster
