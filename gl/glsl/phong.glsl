// shading/phong.h and shading/blinn_phong.h:
//     ka t + sum over lights of (kd t <n.l> + ks highlight) C,     <x> = max(x, 0)
//     Phong: highlight = <r.v>^s, r = 2 (n.l) n - l.     Blinn-Phong: highlight = <n.h>^s, h = (l + v) / |l + v|.
uniform vec3 ka;
uniform vec3 kd;
uniform vec3 ks;
uniform float glossiness;
#ifdef HAS_TEXTURE
uniform sampler2D tex;
#endif

vec3 surface_colour() {
    vec3 t = vec3(1.0);
#ifdef HAS_TEXTURE
    t = texture(tex, fs_in(TexCoord)).rgb;
#endif
#ifdef HAS_COLOURS
    t *= max(fs_in(Color), 0.0);
#endif
    return t;
}

vec3 ambient(vec3 t) {
    return ka * t;
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
    colour += ks * highlight(n, v, light.direction, n_l);
#endif
    return colour * light.radiance;
}
