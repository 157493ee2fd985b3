// shading/merl.h: f(l, v) <n.l> C, 0 unless n.l > 0 and n.v > 0; f from the table.
uniform sampler3D merlBrdf; // at (phi_d, theta_d, theta_h): f and 1, or 0 and 0 where it was never measured

const float pi = 3.14159265358979;
const ivec3 bins = ivec3(180, 90, 90);

vec3 surface_colour() {
    return vec3(1.0);
}

vec3 ambient(vec3 t) {
    return vec3(0.0);
}

// shading/half_difference.h: (cos phi_d, sin phi_d) times any factor.
vec2 difference_azimuth(vec3 n, vec3 i, vec3 o) {
#if MERL_ANGLES == ANGLES_CLOSED
    return vec2(length(i + o) * dot(n, i - o), 2.0 * dot(n, cross(i, o)));
#elif MERL_ANGLES == ANGLES_ROTATION
    float side = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + n.z), b = n.x * n.y * a;
    vec3 tangent = vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
    vec3 bitangent = vec3(b, side + n.y * n.y * a, -n.y);
    vec3 h = unit(i + o);
    vec2 h_flat = vec2(dot(h, tangent), dot(h, bitangent));
    float cos_theta_h = dot(h, n), sin_theta_h = length(h_flat);
    vec2 phi_h = sin_theta_h > 0.0 ? h_flat / sin_theta_h : vec2(1.0, 0.0); // cosine, sine
    vec2 i_flat = vec2(dot(i, tangent), dot(i, bitangent));
    float upright_x = dot(phi_h, i_flat);
    float upright_y = phi_h.x * i_flat.y - phi_h.y * i_flat.x;
    return vec2(cos_theta_h * upright_x - sin_theta_h * dot(i, n), upright_y);
#else
    vec3 h = unit(i + o);
    vec3 h_x = h * dot(n, h) - n;
    vec3 h_y = cross(h, h_x);
    vec3 p = i - h * dot(i, h);
    return vec2(dot(p, h_x), dot(p, h_y));
#endif
}

// The direction of the line through 0 and p, in [0, pi).
float line_angle(vec2 p) {
    float upper_x = p.y < 0.0 ? -p.x : (p.y > 0.0 ? p.x : abs(p.x));
    float angle = atan(abs(p.y), upper_x);
    return angle < pi ? angle : 0.0;
}

// The point of the table, in bins along (phi_d, theta_d, theta_h). Neither theta is an arc cosine, which loses half of
// all digits at a highlight. atan(0, 0) is undefined in GLSL.
vec3 table_point(vec3 n, vec3 i, vec3 o) {
    vec3 s = i + o, d = i - o;
    float sin_h = length(cross(n, s)), sin_d = length(d), cos_d = length(s);
    vec2 azimuth = difference_azimuth(n, i, o);
    bool defined = min(min(sin_h, sin_d), max(abs(azimuth.x), abs(azimuth.y))) > 0.0;
    float theta_h = sin_h > 0.0 ? atan(sin_h, dot(n, s)) : 0.0;
    float theta_d = atan(sin_d, cos_d);
    float phi_d = defined ? line_angle(azimuth) : pi / 2.0;
    return vec3(phi_d * (180.0 / pi), theta_d * (180.0 / pi), 90.0 * sqrt(theta_h * (2.0 / pi)));
}

// The theta are clamped, phi_d wraps: it is periodic in pi.
vec4 sample_at(ivec3 bin) {
    ivec3 inside = clamp(bin, ivec3(0), bins - 1);
    inside.x = bin.x < 0 ? bin.x + bins.x : (bin.x >= bins.x ? bin.x - bins.x : bin.x);
    return texelFetch(merlBrdf, inside, 0);
}

// `at` counts in samples: sample k is at k.
vec4 trilinear(vec3 at) {
    ivec3 low = ivec3(floor(at));
    vec3 fraction = at - floor(at);
    vec4 along_d[2];
    for (int h = 0; h < 2; ++h) {
        vec4 along_p[2];
        for (int d = 0; d < 2; ++d)
            along_p[d] = mix(sample_at(low + ivec3(0, d, h)), sample_at(low + ivec3(1, d, h)), fraction.x);
        along_d[h] = mix(along_p[0], along_p[1], fraction.y);
    }
    return mix(along_d[0], along_d[1], fraction.z);
}

// Catmull-Rom, between b and c.
vec4 mix_cubic(vec4 a, vec4 b, vec4 c, vec4 d, float fraction) {
    vec4 slope_b = (c - a) * 0.5, slope_c = (d - b) * 0.5, rise = c - b;
    return b + (slope_b + (rise * 3.0 - slope_b * 2.0 - slope_c + (slope_b + slope_c - rise * 2.0) * fraction) * fraction)
               * fraction;
}

// Where one of the 64 samples was never measured: trilinear.
vec4 tricubic(vec3 at) {
    ivec3 low = ivec3(floor(at)) - 1;
    vec3 fraction = at - floor(at);
    float measured = 1.0;
    vec4 along_d[4];
    for (int h = 0; h < 4; ++h) {
        vec4 along_p[4];
        for (int d = 0; d < 4; ++d) {
            vec4 tap[4];
            for (int p = 0; p < 4; ++p) {
                tap[p] = sample_at(low + ivec3(p, d, h));
                measured = min(measured, tap[p].w);
            }
            along_p[d] = mix_cubic(tap[0], tap[1], tap[2], tap[3], fraction.x);
        }
        along_d[h] = mix_cubic(along_p[0], along_p[1], along_p[2], along_p[3], fraction.y);
    }
    vec4 smoothed = mix_cubic(along_d[0], along_d[1], along_d[2], along_d[3], fraction.z);
    return measured < 1.0 ? trilinear(at) : vec4(smoothed.rgb, 1.0);
}

vec4 looked_up(vec3 point) {
#if MERL_LOOKUP == LOOKUP_NEAREST
    return texelFetch(merlBrdf, clamp(ivec3(floor(point)), ivec3(0), bins - 1), 0);
#elif MERL_LOOKUP == LOOKUP_TRICUBIC_LOG
    return tricubic(point - 0.5);
#else
#if MERL_LOOKUP == LOOKUP_TRILINEAR_EDGE
    const float first = 0.0; // the coordinate of sample 0
#else
    const float first = 0.5;
#endif
#ifdef MERL_HARDWARE_FILTER
    return texture(merlBrdf, (point - first + 0.5) / vec3(bins)); // texels are at 0.5, 1.5 ...
#else
    return trilinear(point - first);
#endif
#endif
}

// The weighted mean of what was measured.
vec3 brdf(vec3 n, vec3 i, vec3 o) {
    vec4 sum = looked_up(table_point(n, i, o));
    vec3 f = sum.w > 0.0 ? sum.rgb / sum.w : vec3(0.0);
#if MERL_LOOKUP == LOOKUP_TRILINEAR_LOG || MERL_LOOKUP == LOOKUP_TRICUBIC_LOG
    f = MERL_LOG_EPSILON * max(exp2(f) - 1.0, 0.0); // the table holds log2(1 + f / epsilon)
#endif
    return f;
}

vec3 reflected(vec3 n, vec3 v, vec3 t, Incident light) {
    float n_l = dot(n, light.direction);
    bool lit = min(n_l, dot(n, v)) > 0.0;
    return lit ? brdf(n, light.direction, v) * n_l * light.radiance : vec3(0.0);
}
