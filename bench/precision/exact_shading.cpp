#include "bench/precision/exact_shading.h"

namespace refraster::precision {

ExactLit exactly_lit(const Inputs& in) {
  const Exact radiance(in.radiance);
  if (in.path == Path::directions) return {exact(in.n), exact(in.l), exact(in.v), radiance};
  const Exact3 position = exact(in.position), n = unit(exact(in.normal)), v = unit(exact(in.eye) - position);
  if (in.path == Path::direction_light) return {n, unit(exact(in.direction.direction)) * Exact(-1), v, radiance};
  const Exact3 way = exact(in.point.position) - position;
  const Exact d = norm(way);
  const Exact divisor = in.point.constant + in.point.linear * d + in.point.quadratic * d * d;
  return {n, unit(way), v, radiance / divisor};
}

namespace {

Exact cosine_of_angle(const Exact3& a, const Exact3& b) {
  return inner(a, b) / sqrt(Exact(inner(a, a) * inner(b, b)));
}

Exactly reflected(const Inputs& in, const ExactLit& lit, const Exact& cosine) {
  const Exact highlight = cosine > 0 ? pow(cosine, Exact(in.glossiness)) : Exact(0);
  const Exact diffuse = Exact(in.kd) * in.texture;
  return {(diffuse * positive_part(inner(lit.n, lit.l)) + in.ks * highlight) * lit.radiance,
          (diffuse * inner_magnitude(lit.n, lit.l) + in.ks) * lit.radiance};
}

} // namespace

Exactly exact_phong(const Inputs& in) {
  const ExactLit lit = exactly_lit(in);
  const Exact3 r = lit.n * Exact(2 * inner(lit.n, lit.l)) - lit.l;
  return reflected(in, lit, cosine_of_angle(r, lit.v));
}

Exactly exact_blinn_phong(const Inputs& in) {
  const ExactLit lit = exactly_lit(in);
  return reflected(in, lit, cosine_of_angle(lit.n, lit.l + lit.v));
}

} // namespace refraster::precision
