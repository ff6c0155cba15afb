#pragma once

#include "sim/verification/cases.h"

// The cases defined in each file; cases() puts them in order.

namespace sim::verification {

extern const Case kDecay, kSimpleWave, kObliqueWave, kDepositFront, kThickPulse;  // waves.cpp
extern const Case kManufactured;                                                  // manufactured.cpp
extern const Case kEntraining, kDepositing, kFilm;                                // inertial.cpp
extern const Case kStrip, kSquare, kDisk;                                         // tables.cpp
extern const Case kGrowth, kRestingLayer;                                         // uniform.cpp
extern const Case kFreeSlab, kCoulombSlab, kStopping, kVoellmyTerminal;           // voellmy.cpp
extern const Case kThickDrag, kFluidized, kCohesive;                              // voellmy.cpp
extern const Case kFreeRamp, kCoulombRamp, kSpread, kRitter, kMangeney, kSwing;   // voellmy_flows.cpp
extern const Case kBowl, kCircularBend, kSlidingHeap, kSmoothEnergy;              // voellmy_flows.cpp

}  // namespace sim::verification
