// What every fragment function starts from: shading/fragment.h and shading/light.h.
out vec4 FragColor;

#ifdef SHADOW_MAPS
// Of a light's shadow map; members that only one type of light has are 0 in the other.
struct ShadowMap {
    int layer;  // the first of shadowMaps; -1: the light has none
    int size;   // texels a side
    int taps;   // texels that are compared: 1, 4 by bilinear weights, or 9
    float bias, slopeBias;          // in texels
    float texel;                    // its width: at distance 1 for a point light
    float scale, middle;            // texels = place * scale + middle
    float near;                     // distance of the near plane
    float depthScale, depthOffset;  // window depth from distance
    vec3 origin, right, up, ahead;  // of a direction light, world space
};
#endif

// Of each type of light a struct and a function arriving(). The arrays, and the sum over them, are made from the list.
struct PointLight {
    vec3 position;
    vec3 radiance;
    float constant;
    float linear;
    float quadratic;
#ifdef SHADOW_MAPS
    ShadowMap shadow;
#endif
};
struct DirectionLight {
    vec3 direction; // where the light travels to, unit
    vec3 radiance;
#ifdef SHADOW_MAPS
    ShadowMap shadow;
#endif
};

uniform vec3 viewPos;

// Light that reaches the surface: the unit direction to it, and radiance times attenuation.
struct Incident {
    vec3 direction;
    vec3 radiance;
};

// a / |a|, and 0 for 0, where normalize() is undefined.
vec3 unit(vec3 a) {
    float squared = dot(a, a);
    return a * (squared > 0.0 ? inversesqrt(squared) : 0.0);
}

Incident arriving(PointLight light, vec3 position) {
    vec3 way = light.position - position;
    float d = length(way);
    float attenuation = 1.0 / (light.constant + light.linear * d + light.quadratic * d * d);
    return Incident(way * (d > 0.0 ? 1.0 / d : 0.0), light.radiance * (d > 0.0 ? attenuation : 0.0));
}

Incident arriving(DirectionLight light, vec3 position) {
    return Incident(-light.direction, light.radiance);
}
