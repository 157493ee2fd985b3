// shading/microfacet/microfacet.h: emissive + sum over lights of (diffuse + specular) C.
uniform vec3 baseColor;
uniform float metallic;
uniform float roughness;
uniform float ior;
#if MICROFACET_FRESNEL == FRESNEL_CONDUCTOR
uniform vec3 eta;
uniform vec3 k;
#endif
#ifdef HAS_ROUGHNESS_MAP
uniform sampler2D roughnessTex;
#endif
#ifdef HAS_METALLIC_MAP
uniform sampler2D metallicTex;
#endif

const float inverse_pi = 0.318309886183791;

float metal, alpha; // metallic and roughness^2, with their textures: read once, for all lights

vec3 surface_colour() {
    float rough = roughness;
    metal = metallic;
#ifdef HAS_ROUGHNESS_MAP
    rough *= texture(roughnessTex, ROUGHNESS_MAP_AT).r;
#endif
#ifdef HAS_METALLIC_MAP
    metal *= texture(metallicTex, METALLIC_MAP_AT).r;
#endif
    rough = max(rough, 1e-4);
    alpha = rough * rough;
    return texture_colour();
}

vec3 ambient(vec3 t) {
    return with_emission(vec3(0.0));
}

float square(float x) {
    return x * x;
}

// shading/microfacet/fresnel.h, with s_2 = 1 - c^2 and excess = ior^2 - 1.
float schlick_weight(float c, float s_2) {
    float away = s_2 / (1.0 + c);
    return square(square(away)) * away;
}

float dielectric_reflectance(float c, float excess) {
    float g = sqrt(excess + c * c);
    return 0.5 * square((g - c) / (g + c)) * (1.0 + square((c * (g + c) - 1.0) / (c * (g - c) + 1.0)));
}

float dielectric_transmittance(float c, float excess) {
    float i = excess + 1.0, g = sqrt(excess + c * c);
    float across = 1.0 / (c + g), along = 1.0 / (i * c + g);
    return min(2.0 * c * g * (across * across + i * (along * along)), 1.0);
}

float conductor_reflectance(float c, float s_2, float e, float k) {
    float p = (e - k) * (e + k) - s_2, half_q = square(e * k);
    float larger = 0.5 * (sqrt(p * p + 4.0 * half_q) + abs(p));
    float smaller = half_q / (larger > 0.0 ? larger : 1.0);
    float a = sqrt(p >= 0.0 ? larger : smaller), b_2 = p >= 0.0 ? smaller : larger;
    float across = min((square(a - c) + b_2) / (square(a + c) + b_2), 1.0);
    float b_2_c_2 = b_2 * (c * c), a_c = a * c;
    float along = min((square(a_c - s_2) + b_2_c_2) / (square(a_c + s_2) + b_2_c_2), 1.0);
    return 0.5 * across * (1.0 + along);
}

vec3 mixed(float dielectric, vec3 metallic_colour) {
    return vec3((1.0 - metal) * dielectric) + metallic_colour * metal;
}

vec3 fresnel(vec3 base, float c, float s_2) {
    float less = ior - 1.0, more = ior + 1.0;
#if MICROFACET_FRESNEL == FRESNEL_SCHLICK
    vec3 f0 = mixed(square(less / more), base);
    return f0 + (vec3(1.0) - f0) * schlick_weight(c, s_2);
#else
    float dielectric = min(dielectric_reflectance(c, less * more), 1.0);
#if MICROFACET_FRESNEL == FRESNEL_DIELECTRIC
    return mixed(dielectric, base + (vec3(1.0) - base) * schlick_weight(c, s_2));
#else
    return mixed(dielectric, vec3(conductor_reflectance(c, s_2, eta.x, k.x), conductor_reflectance(c, s_2, eta.y, k.y),
                                  conductor_reflectance(c, s_2, eta.z, k.z)));
#endif
#endif
}

float transmittance(float c) {
    float less = ior - 1.0, more = ior + 1.0;
#if MICROFACET_FRESNEL == FRESNEL_SCHLICK
    float y = 1.0 - c;
    return (1.0 - square(less / more)) * (c * (1.0 + y * (1.0 + y * (1.0 + y * (1.0 + y)))));
#else
    return dielectric_transmittance(c, less * more);
#endif
}

// shading/microfacet/ggx.h.
float density(float spread, float a) {
    return a * inverse_pi / square(spread);
}

float smith_divisor(float n_l, float n_v, float a) {
    return n_v * sqrt(a + (1.0 - a) * (n_l * n_l)) + n_l * sqrt(a + (1.0 - a) * (n_v * n_v));
}

vec3 reflected(vec3 n, vec3 v, vec3 t, Incident light) {
    vec3 l = light.direction, s = l + v, base = baseColor * t;
    float n_l = max(dot(n, l), 0.0), n_v = max(dot(n, v), 0.0), a = alpha * alpha;
    if (!(min(n_l, n_v) > 0.0)) return vec3(0.0);

    vec3 n_s = cross(n, s), d = l - v;
    float squared_sum = dot(s, s), divisor = squared_sum > 0.0 ? squared_sum : 1.0;
    float spread = a * (square(dot(n, s)) / divisor) + dot(n_s, n_s) / divisor;
    float cosine_over_divisor = max(min(0.5 * n_l / smith_divisor(n_l, n_v, a), 0.5 / alpha), 0.0);
    float lobe = density(spread > 0.0 ? spread : 1.0, a) * cosine_over_divisor;
    float ground = (1.0 - metal) * inverse_pi * transmittance(n_l) * transmittance(n_v) * n_l;
    vec3 specular = fresnel(base, min(0.5 * sqrt(squared_sum), 1.0), 0.25 * dot(d, d)) * lobe;
    return (base * ground + specular) * light.radiance;
}
