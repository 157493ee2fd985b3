#pragma once
// The closed list of fragment functions.

#include "shading/blinn_phong.h"
#include "shading/merl.h"
#include "shading/phong.h"

#include <variant>

namespace refraster {

/// Every fragment function. The order is that of `refraster list fragment-functions`; nothing else depends on it.
using FragmentFunction = std::variant<Phong, BlinnPhong, Merl>;

} // namespace refraster
