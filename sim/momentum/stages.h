#pragma once

// The stages of the models with momentum in call order: the ground, the forces, exchange, transport, start and
// rest. `voellmy` has no exchange, start and rest.
#include "sim/momentum/ground.h"

#include "sim/momentum/walls.h"

#include "sim/momentum/forces.h"

#include "sim/momentum/exchange.h"

#include "sim/momentum/transport.h"

#include "sim/momentum/finish.h"

#include "sim/momentum/yield.h"
