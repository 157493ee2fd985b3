void main() {
    vec3 n = unit(fs_in(Normal));
    vec3 v = unit(viewPos - fs_in(FragPos));
    vec3 t = surface_colour();
    FragColor = vec4(with_lights(ambient(t), n, v, t), 1.0);
}
