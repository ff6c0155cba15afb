#pragma once

#include "sim/verification/cases.h"

// The cases defined in each file; cases() puts them in order.

namespace sim::verification {

extern const Case kDecay, kSimpleWave, kObliqueWave, kDepositFront, kThickPulse;  // waves.cpp
extern const Case kManufactured;                                                  // manufactured.cpp
extern const Case kEroding, kDepositing;                                          // inertial.cpp
extern const Case kStrip, kSquare, kDisk;                                         // tables.cpp
extern const Case kGrowth, kTerminalSpeed, kSpeedGate, kRestingLayer;             // uniform.cpp

}  // namespace sim::verification
