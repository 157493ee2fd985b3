#pragma once
// placeholder: see the elementary helper
#include "math/vec.h"
