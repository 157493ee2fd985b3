#include "verify/compare.h"
