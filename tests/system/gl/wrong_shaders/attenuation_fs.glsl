#version 410 core
// Phong reflection, the formula of shading/phong.h:
//     ka t + sum over lights of (kd t <n.l> + ks <r.v>^s) C,     r = 2 (n.l) n - l,     <x> = max(x, 0).

#define MAX_LIGHTS 64

in VS_OUT {
    vec3 FragPos;
    vec3 Normal;
    vec2 TexCoord;
} fs_in;
out vec4 FragColor;

struct PointLight {
    vec3 position;
    vec3 radiance;
    float constant;
    float linear;
    float quadratic;
};
struct DirectionLight {
    vec3 direction; // where the light travels to
    vec3 radiance;
};

uniform vec3 viewPos;
uniform int pointLightCount;
uniform PointLight pointLights[MAX_LIGHTS];
uniform int directionLightCount;
uniform DirectionLight directionLights[MAX_LIGHTS];

uniform vec3 ka;
uniform vec3 kd;
uniform vec3 ks;
uniform float glossiness;
uniform sampler2D tex;

vec3 reflected(vec3 n, vec3 v, vec3 t, vec3 l, vec3 radiance) {
    vec3 r = 2.0 * dot(n, l) * n - l;
    // pow(0, 0) is undefined in GLSL; here it is 1.
    float highlight = glossiness == 0.0 ? 1.0 : pow(max(dot(r, v), 0.0), glossiness);
    return (kd * t * max(dot(n, l), 0.0) + ks * highlight) * radiance;
}

void main() {
    vec3 n = normalize(fs_in.Normal);
    vec3 v = normalize(viewPos - fs_in.FragPos);
    vec3 t = texture(tex, fs_in.TexCoord).rgb;

    vec3 sum = ka * t;
    for (int i = 0; i < pointLightCount; ++i) {
        PointLight light = pointLights[i];
        vec3 way = light.position - fs_in.FragPos;
        float d = length(way);
        float attenuation = 1.0;
        sum += reflected(n, v, t, way / d, light.radiance * attenuation);
    }
    for (int i = 0; i < directionLightCount; ++i) {
        DirectionLight light = directionLights[i];
        sum += reflected(n, v, t, normalize(-light.direction), light.radiance);
    }
    FragColor = vec4(sum, 1.0);
}
