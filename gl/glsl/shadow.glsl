// Shadow maps: raster/shadow/map/light_view.h and depth_map.h, operation by operation.
// Window depths; of a point light six layers, the faces of a cube in the order of OpenGL.
uniform sampler2DArray shadowMaps;

// In texels of the map, `at` in its axes: x to the right, y up, z away from the light. n: of any length, in the same.
float slope(vec3 at, vec3 n, bool perspective) {
    float rise = max(abs(n.x), abs(n.y)), run = perspective ? abs(dot(n, at)) : abs(n.z);
    if (perspective) rise *= at.z;
    return rise / max(run, 8.271806e-25); // 2^-80: huge where the light only grazes
}

bool is_lit(ShadowMap map, int layer, ivec2 texel, float depth, bool perspective) {
    int last = map.size - 1;
    if (perspective) texel = clamp(texel, ivec2(0), ivec2(last));
    else if (any(lessThan(texel, ivec2(0))) || any(greaterThan(texel, ivec2(last)))) return true;
    return depth <= texelFetch(shadowMaps, ivec3(texel, layer), 0).r;
}

float filtered(ShadowMap map, int layer, vec2 place, float depth, bool perspective) {
    float size = float(map.size);
    place = clamp(place, vec2(-4.0), vec2(size + 4.0));
    if (map.taps == 1) return is_lit(map, layer, ivec2(floor(place)), depth, perspective) ? 1.0 : 0.0;
    int lit = 0;
    if (map.taps == 4) {
        vec2 from_centre = place - 0.5, first = floor(from_centre), f = from_centre - first;
        float sum = 0.0;
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i)
                if (is_lit(map, layer, ivec2(first) + ivec2(i, j), depth, perspective)) {
                    ++lit;
                    sum += (i == 1 ? f.x : 1.0 - f.x) * (j == 1 ? f.y : 1.0 - f.y);
                }
        return lit == 4 ? 1.0 : sum;
    }
    for (int j = -1; j < 2; ++j)
        for (int i = -1; i < 2; ++i)
            if (is_lit(map, layer, ivec2(floor(place)) + ivec2(i, j), depth, perspective)) ++lit;
    return lit == 9 ? 1.0 : float(lit) / 9.0;
}

// The six faces: their columns run along sc, their rows along tc (OpenGL 4.6, table 8.19).
vec3 in_face(int face, vec3 v) {
    if (face == 0) return vec3(-v.z, -v.y, v.x);
    if (face == 1) return vec3(v.z, -v.y, -v.x);
    if (face == 2) return vec3(v.x, v.z, v.y);
    if (face == 3) return vec3(v.x, -v.z, -v.y);
    if (face == 4) return vec3(v.x, -v.y, v.z);
    return vec3(-v.x, -v.y, -v.z);
}

int face_of(vec3 d) {
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) return d.x < 0.0 ? 1 : 0;
    if (a.y >= a.z) return d.y < 0.0 ? 3 : 2;
    return d.z < 0.0 ? 5 : 4;
}

float visibility(PointLight light, vec3 position, vec3 normal) {
    ShadowMap map = light.shadow;
    if (map.layer < 0) return 1.0;
    vec3 d = position - light.position;
    int face = face_of(d);
    vec3 at = in_face(face, d);
    float bias = map.bias;
    if (map.slopeBias != 0.0) bias += map.slopeBias * slope(at, in_face(face, normal), true);
    float z = at.z - map.texel * at.z * bias;
    float depth = min(map.depthScale - map.depthOffset / max(z, map.near), 1.0);
    vec2 place = vec2(at.x / at.z, at.y / at.z) * map.scale + map.middle;
    return filtered(map, map.layer + face, place, depth, true);
}

float visibility(DirectionLight light, vec3 position, vec3 normal) {
    ShadowMap map = light.shadow;
    if (map.layer < 0) return 1.0;
    vec3 d = position - map.origin;
    vec3 at = vec3(dot(map.right, d), dot(map.up, d), dot(map.ahead, d));
    vec3 n = vec3(dot(map.right, normal), dot(map.up, normal), dot(map.ahead, normal));
    float bias = map.bias;
    if (map.slopeBias != 0.0) bias += map.slopeBias * slope(at, n, false);
    float z = at.z - map.texel * bias;
    float depth = min((z - map.near) * map.depthScale, 1.0);
    return filtered(map, map.layer, at.xy * map.scale + map.middle, depth, false);
}
