#version 410 core
// A measured BRDF as the lecture has it: half and difference angles by a change of frame, and one filtered read of the
// 3D texture, whose axes are reversed. Arc cosines would lose half of all digits where they are near 0.

#define MAX_LIGHTS 16

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
uniform sampler3D merlBrdf;

const float pi = 3.14159265358979;

vec3 brdf(vec3 n, vec3 i, vec3 o) {
    vec3 h = normalize(i + o);
    float theta_h = atan(length(cross(n, h)), dot(n, h));
    float theta_d = atan(length(cross(i, h)), dot(i, h));
    vec3 h_x = h * dot(n, h) - n;
    vec3 h_y = cross(h, h_x);
    vec3 p = i - dot(i, h) * h;
    float phi_d = atan(dot(p, h_y), dot(p, h_x));
    phi_d = max(phi_d, 0.0);
    float x = sqrt(theta_h / (pi / 2.0)), y = theta_d / (pi / 2.0), z = phi_d / pi;
    vec4 sum = texture(merlBrdf, vec3(z, y, x));
    return sum.rgb / max(sum.a, 1e-6); // alpha is the weight of what was measured
}

vec3 reflected(vec3 n, vec3 v, vec3 l, vec3 radiance) {
    if (dot(n, l) <= 0.0 || dot(n, v) <= 0.0) return vec3(0.0);
    return brdf(n, l, v) * dot(n, l) * radiance;
}

void main() {
    vec3 n = normalize(fs_in.Normal);
    vec3 v = normalize(viewPos - fs_in.FragPos);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < pointLightCount; ++i) {
        PointLight light = pointLights[i];
        vec3 way = light.position - fs_in.FragPos;
        float d = length(way);
        float attenuation = 1.0 / (light.constant + light.linear * d + light.quadratic * d * d);
        sum += reflected(n, v, way / d, light.radiance * attenuation);
    }
    for (int i = 0; i < directionLightCount; ++i)
        sum += reflected(n, v, normalize(-directionLights[i].direction), directionLights[i].radiance);
    FragColor = vec4(sum, 1.0);
}
