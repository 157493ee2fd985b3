// The lecture's vertex shader, with its products of matrices made once an object, in double, instead of once a vertex.
uniform mat4 model;
uniform mat4 clipFromObject; // projection . view . model
uniform mat3 normalMatrix;   // cofactors of model's 3x3 part: its inverse transpose, up to a positive factor

// a / |a|, and 0 for 0, where normalize() is undefined.
vec3 unit(vec3 a) {
    float squared = dot(a, a);
    return a * (squared > 0.0 ? inversesqrt(squared) : 0.0);
}

void pass_attributes(); // made from the list of vertex attributes

void main() {
    pass_attributes();
    gl_Position = clipFromObject * vec4(vPos, 1.0);
}
