#pragma once

// The stages of `voellmy` in call order: the ground, the forces, transport, and the layers at the end.
#include "sim/voellmy/ground.h"

#include "sim/voellmy/forces.h"
#include "sim/voellmy/transport.h"

#include "sim/voellmy/finish.h"
