#pragma once
// All that a fragment function of one's own needs: the numbers and their functions, Fragment, Incident,
// user_function(). A component of its own of the package: CONTRIBUTING.md, "A fragment function of your own".

#include "math/elementary.h"
#include "shading/fragment.h"
#include "shading/user_function.h"
