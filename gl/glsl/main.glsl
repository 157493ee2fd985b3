#ifdef TWO_SIDED
uniform float frontSign; // 1; -1 where the model mirrors, which turns its faces round but not its normals
#endif

void main() {
    vec3 n = unit(fs_in(Normal));
#ifdef TWO_SIDED
    float side = gl_FrontFacing ? frontSign : -frontSign;
    n *= side;
#endif
#ifdef HAS_TANGENTS // and maps that turn normals
    vec4 tangent = fs_in(Tangent);
#ifdef TWO_SIDED
    tangent *= side;
#endif
    n = mapped_normal(n, tangent);
#endif
    vec3 v = unit(viewPos - fs_in(FragPos));
    vec3 t = surface_colour();
    FragColor = vec4(with_lights(ambient(t), n, v, t), 1.0);
#ifdef HAS_OPACITY_MAP // at the end: behind a discard, the derivatives that textures are read by are undefined
    if (is_cut_out()) discard;
#endif
}
