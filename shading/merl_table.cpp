#include "shading/merl_table.h"
