// The lecture's vertex shader, with its products of matrices made once an object, in double, instead of once a vertex.
layout(location = 0) in vec3 vPos;
layout(location = 1) in vec3 vNormal;
layout(location = 2) in vec2 vTexCoord;
uniform mat4 model;
uniform mat4 clipFromObject; // projection . view . model
uniform mat3 normalMatrix;   // cofactors of model's 3x3 part: its inverse transpose, up to a positive factor

#ifdef GL_ES // has no blocks between stages
out vec3 FragPos;
out vec3 Normal;
out vec2 TexCoord;
#define vs_out(name) name
#else
out VS_OUT {
    vec3 FragPos;
    vec3 Normal;
    vec2 TexCoord;
} vs_out_block;
#define vs_out(name) vs_out_block.name
#endif

void main() {
    vs_out(FragPos) = vec3(model * vec4(vPos, 1.0));
    vs_out(Normal) = normalMatrix * vNormal;
    vs_out(TexCoord) = vTexCoord;
    gl_Position = clipFromObject * vec4(vPos, 1.0);
}
