#include "sim/verification/cases.h"

#include <array>
#include <cmath>

#include "sim/verification/case_list.h"

namespace sim::verification {

double Series::order() const {
    const std::size_t n = errors.size();
    if (n < 2) return 0;
    return std::log(errors[n - 2] / errors[n - 1]) /
           std::log(static_cast<double>(squares[n - 1]) / squares[n - 2]);
}

bool Series::holds() const {
    return errors.back() <= most && (least_order == 0 || order() >= least_order);
}

std::span<const Case> cases() {
    static const std::array kCases{
        kDecay,        kSimpleWave,  kObliqueWave, kDepositFront,    kThickPulse, kManufactured, kGrowth,
        kStrip,        kSquare,      kDisk,        kRestingLayer,    kEntraining, kDepositing,   kFilm,
        kFreeSlab,     kCoulombSlab, kStopping,    kVoellmyTerminal, kThickDrag,  kFluidized,    kCohesive,
        kFreeRamp,     kCoulombRamp, kSpread,      kRitter,          kMangeney,   kSwing,        kBowl,
        kCircularBend, kSlidingHeap, kSmoothEnergy};
    return kCases;
}

}  // namespace sim::verification
