// Which object and triangle is seen, both counted from 1, instead of a colour.
uniform float objectNumber;
uniform float triangleNumber;
out vec4 FragColor;

void main() {
    FragColor = vec4(objectNumber, triangleNumber, 0.0, 1.0);
#ifdef HAS_OPACITY_MAP
    if (is_cut_out()) discard;
#endif
}
