// raster/shade/opacity.h: how much of the surface is there, at the pixel's centre, as long as no input is a centroid.
#ifdef HAS_OPACITY_MAP
uniform sampler2D opacityTex;
uniform float opacityThreshold;

bool is_cut_out() {
    return texture(opacityTex, OPACITY_MAP_AT).r < opacityThreshold;
}
#endif
