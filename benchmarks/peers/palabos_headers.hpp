#pragma once

// palabos3D.h and palabos3D.hh less the templates of its multi-grid part: that of Debian's 1.5 hands three
// arguments to std::vector::assign, which no compiler accepts. In Palabos's own order.

// clang-format off
#include <palabos3D.h>

#include <parallelism/headers3D.hh>
#include <latticeBoltzmann/headers3D.hh>
#include <core/headers3D.hh>
#include <basicDynamics/headers3D.hh>
#include <boundaryCondition/headers3D.hh>
#include <complexDynamics/headers3D.hh>
#include <multiPhysics/headers3D.hh>
#include <atomicBlock/headers3D.hh>
#include <multiBlock/headers3D.hh>
#include <algorithm/headers3D.hh>
#include <dataProcessors/headers3D.hh>
#include <finiteDifference/headers3D.hh>
#include <coProcessors/headers3D.hh>
// clang-format on
