#pragma once
// The formula of every fragment function in the list of <refraster/material.h>. For a block of parameters of its own,
// each defines, for every Number T,
//     Rgb<T> ambient(const Block&, const Fragment<T>&)                       without any light
//     Rgb<T> reflected(const Block&, const Fragment<T>&, const Incident<T>&)   from one light

#include "shading/blinn_phong.h"
#include "shading/merl.h"
#include "shading/microfacet/microfacet.h"
#include "shading/phong.h"
