void main() {
    vec3 n = unit(fs_in(Normal));
    vec3 v = unit(viewPos - fs_in(FragPos));
    vec3 t = surface_colour();
    vec3 sum = ambient(t);
#if POINT_LIGHTS > 0
    for (int i = 0; i < POINT_LIGHTS; ++i) sum += reflected(n, v, t, arriving(pointLights[i], fs_in(FragPos)));
#endif
#if DIRECTION_LIGHTS > 0
    for (int i = 0; i < DIRECTION_LIGHTS; ++i) sum += reflected(n, v, t, arriving(directionLights[i]));
#endif
    FragColor = vec4(sum, 1.0);
}
