#include "verify/image_pair.h"
