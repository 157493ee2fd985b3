// shading/phong.h and shading/blinn_phong.h:
//     ka t + emissive + sum over lights of (kd t <n.l> + ks highlight) C,     <x> = max(x, 0)
//     Phong: highlight = <r.v>^s, r = 2 (n.l) n - l.     Blinn-Phong: highlight = <n.h>^s, h = (l + v) / |l + v|.
uniform vec3 ka;
uniform vec3 kd;
uniform vec3 ks;
uniform float glossiness;
#ifdef HAS_SPECULAR_MAP
uniform sampler2D specularTex;
#endif

vec3 specular_colour; // ks, times its texture: read once, for all lights

vec3 surface_colour() {
    specular_colour = ks;
#ifdef HAS_SPECULAR_MAP
    specular_colour *= texture(specularTex, SPECULAR_MAP_AT).rgb;
#endif
    return texture_colour();
}

vec3 ambient(vec3 t) {
    return with_emission(ka * t);
}

float highlight(vec3 n, vec3 v, vec3 l, float n_l) {
#ifdef BLINN
    float cosine = dot(n, unit(l + v));
#else
    float cosine = dot(2.0 * n_l * n - l, v);
#endif
#ifdef ZERO_GLOSSINESS // pow(0, 0) is undefined in GLSL; here it is 1
    float lobe = 1.0;
#else
    float lobe = pow(max(cosine, 0.0), glossiness);
#endif
#ifdef SPECULAR_GATE
    lobe = n_l > 0.0 ? lobe : 0.0;
#endif
    return lobe;
}

vec3 reflected(vec3 n, vec3 v, vec3 t, Incident light) {
    float n_l = dot(n, light.direction);
    vec3 colour = kd * t * max(n_l, 0.0);
#ifdef SPECULAR // ks is not 0
    colour += specular_colour * highlight(n, v, light.direction, n_l);
#endif
    return colour * light.radiance;
}
