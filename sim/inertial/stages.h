#pragma once

// The stages of `bcre-inertial` in call order: half of the relaxation, transport and exchange by Heun's
// method, and the other half of the relaxation (heun.h).
#include "sim/inertial/exchange.h"
#include "sim/inertial/heun.h"
#include "sim/inertial/transport.h"
#include "sim/inertial/velocity.h"
#include "sim/inertial/yield.h"
