#include "raster/render.h"
