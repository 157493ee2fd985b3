// What phong.glsl and microfacet.glsl begin with: the texture's colour, and light of the surface's own.
#ifdef EMISSIVE // emissive is not 0
uniform vec3 emissive;
#endif
// Where each texture is read, TEXTURE_AT and so on, is defined above: at fs_in(TexCoord), or scaled and moved.
#ifdef HAS_TEXTURE
uniform sampler2D tex;
#endif
#ifdef HAS_EMISSIVE_MAP
uniform sampler2D emissiveTex;
#endif

vec3 texture_colour() {
    vec3 t = vec3(1.0);
#ifdef HAS_TEXTURE
    t = texture(tex, TEXTURE_AT).rgb;
#endif
#ifdef HAS_COLOURS
    t *= max(fs_in(Color), 0.0);
#endif
    return t;
}

// The colour, with light of its own.
vec3 with_emission(vec3 colour) {
#ifdef EMISSIVE
    vec3 own = emissive;
#ifdef HAS_EMISSIVE_MAP
    own *= texture(emissiveTex, EMISSIVE_MAP_AT).rgb;
#endif
    colour += own;
#endif
    return colour;
}

