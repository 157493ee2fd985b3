// shading/normal_map.h: unit(m.x t + m.y b + m.z n), b = w cross(n, t). Where each texture is read is defined above.
#ifdef HAS_NORMAL_MAP
uniform sampler2D normalTex;
uniform vec2 normalFactors; // of x and y
#endif
#ifdef HAS_BUMP_MAP
uniform sampler2D bumpTex;
uniform vec2 bumpTexel;   // its width and height
uniform vec2 bumpFactors; // from what heights differ by, two texels apart, to slopes

float rise(vec2 at, vec2 to) {
    return texture(bumpTex, at + to).r - texture(bumpTex, at - to).r;
}
#endif

// `tangent`: where u grows, and the handedness of the frame.
vec3 mapped_normal(vec3 n, vec4 tangent) {
    vec3 m = vec3(0.0, 0.0, 1.0);
#ifdef HAS_NORMAL_MAP
    m = 2.0 * texture(normalTex, NORMAL_MAP_AT).rgb - 1.0;
    m.xy *= normalFactors;
#endif
#ifdef HAS_BUMP_MAP
    vec2 at = BUMP_MAP_AT;
    m.xy -= bumpFactors * vec2(rise(at, vec2(bumpTexel.x, 0.0)), rise(at, vec2(0.0, bumpTexel.y)));
#endif
    vec3 b = tangent.w * cross(n, tangent.xyz);
    vec3 sum = m.x * tangent.xyz + m.y * b + m.z * n;
    return abs(sum.x) + abs(sum.y) + abs(sum.z) > 0.0 && dot(n, n) > 0.0 ? unit(sum) : n;
}
