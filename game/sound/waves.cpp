#include "game/sound/waves.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <random>

#include "sim/core/check.h"

namespace game::sound {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

constexpr std::array<WaveInfo, kWaves> kInfos{{
    {Wave::kRumble, "rumble", Group::kFlow, true, 9, 20, 160, "the low part of a flow"},
    {Wave::kRoar, "roar", Group::kFlow, true, 8, 100, 1600, "the middle part of a flow"},
    {Wave::kHiss, "hiss", Group::kFlow, true, 7, 1500, 14000, "powder, and the high part of a flow of snow"},
    {Wave::kStones, "stones", Group::kFlow, true, 9, 250, 6000, "what knocks in a flow of earth"},
    {Wave::kWind, "wind", Group::kAir, true, 12, 60, 1200, "air over ridges"},
    {Wave::kScrape, "scrape", Group::kEvents, true, 4, 300, 5000, "the tool in hand"},
    {Wave::kBlast, "blast", Group::kEvents, false, 2.4, 20, 900, "a blast"},
    {Wave::kEcho, "echo", Group::kEvents, false, 2.8, 20, 400, "a blast, from a slope"},
    {Wave::kCrack, "crack", Group::kEvents, false, 1.5, 30, 6000, "a slab that breaks off"},
    {Wave::kTree, "tree", Group::kEvents, false, 0.9, 150, 4000, "a tree that breaks"},
    {Wave::kWood, "wood", Group::kEvents, false, 1.4, 45, 3500, "wooden walls that break"},
    {Wave::kWall, "wall", Group::kEvents, false, 2, 40, 3500, "brick and concrete that break"},
    {Wave::kMetal, "metal", Group::kEvents, false, 2, 150, 5000, "steel that breaks"},
    {Wave::kHint, "hint", Group::kNotes, false, 0.8, 500, 1400, "a hint"},
    {Wave::kMedal, "medal", Group::kNotes, false, 2, 400, 1700, "a challenge that is won"},
    {Wave::kRefusal, "refusal", Group::kNotes, false, 0.5, 150, 500, "what cannot be done"},
}};

class Dice {
  public:
    explicit Dice(unsigned seed) : bits_(seed) {}
    double real(double least, double most) {
        return least + (most - least) * static_cast<double>(bits_()) / 4294967295.;
    }
    std::vector<double> noise(std::size_t size) {
        std::vector<double> all(size);
        for (double& each : all) each = real(-1, 1);
        return all;
    }

  private:
    std::mt19937 bits_;
};

// A state-variable filter of second order, whose frequency may change with every sample (A. Simper, Linear trapezoidal
// integrated state variable filter, 2011).
class Filter {
  public:
    struct Parts {
        double low, band, high;
    };
    // `width`: damping; 2 does not ring, 0.1 rings long.
    Parts take(double sample, double hz, double width) {
        const double g = std::tan(std::numbers::pi * hz / kRate);
        const double a = 1 / (1 + g * (g + width));
        const double v3 = sample - second_, v1 = a * (first_ + g * v3), v2 = second_ + g * v1;
        first_ = 2 * v1 - first_, second_ = 2 * v2 - second_;
        return {v2, width * v1, sample - width * v1 - v2};
    }

  private:
    double first_ = 0, second_ = 0;
};

// Samples in order, from `make(second)`, of a sound that goes on for two rounds: what is heard is the second one, so that
// its end goes on as it begins if `make` repeats.
template <class Make>
std::vector<double> looped(double seconds, const Make& make) {
    const auto size = static_cast<std::size_t>(seconds * kRate);
    std::vector<double> all(size);
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < size; ++i) all[i] = make(i);
    return all;
}

// Swells between 0 and 1, so many times or less in a loop.
class Swell {
  public:
    Swell(Dice& dice, std::size_t size, int least, int most) : size_(static_cast<double>(size)) {
        for (auto& [times, begin] : waves_)
            times = std::floor(dice.real(least, most + 1)), begin = dice.real(0, 1);
    }
    double operator()(std::size_t i) const {
        double sum = 0;
        for (const auto& [times, begin] : waves_)
            sum += std::sin(kTurn * (begin + times * static_cast<double>(i) / size_));
        return std::clamp(0.5 + sum / 5, 0., 1.);
    }

  private:
    struct One {
        double times, begin;
    };
    std::array<One, 5> waves_{};
    double size_;
};

// Noise between two frequencies, steep outside.
class Band {
  public:
    double take(double sample, double least_hz, double most_hz) {
        const double low = b_.take(a_.take(sample, most_hz, 1.4).low, most_hz, 1.4).low;
        return d_.take(c_.take(low, least_hz, 1.4).high, least_hz, 1.4).high;
    }

  private:
    Filter a_, b_, c_, d_;
};

std::vector<double> loop_of_noise(unsigned seed, double seconds, double least_hz, double most_hz,
                                  std::array<int, 2> swells, double deepest) {
    Dice dice(seed);
    const auto size = static_cast<std::size_t>(seconds * kRate);
    const auto noise = dice.noise(size);
    const Swell swell(dice, size, swells[0], swells[1]);
    Band band;
    return looped(seconds, [&](std::size_t i) {
        return band.take(noise[i], least_hz, most_hz) * (deepest + (1 - deepest) * swell(i));
    });
}

// Adds what rings and dies away: at `begin` s, of this frequency and damping time, s.
void ring(std::vector<double>& into, double begin, double hz, double fades_s, double loud,
          bool wraps = false) {
    const auto first = static_cast<std::size_t>(begin * kRate);
    const auto size = static_cast<std::size_t>(8 * fades_s * kRate);
    for (std::size_t i = 0; i < size; ++i) {
        if (!wraps && first + i >= into.size()) break;
        const double t = static_cast<double>(i) / kRate;
        into[(first + i) % into.size()] += loud * std::exp(-t / fades_s) * std::sin(kTurn * hz * t);
    }
}

// Adds a burst of noise between two frequencies, which rises and dies away.
void burst(std::vector<double>& into, Dice& dice, double begin, double rises_s, double fades_s,
           double least_hz, double most_hz, double loud) {
    Band band;
    for (auto i = static_cast<std::size_t>(begin * kRate); i < into.size(); ++i) {
        const double t = static_cast<double>(i) / kRate - begin;
        into[i] += loud * (1 - std::exp(-t / rises_s)) * std::exp(-t / fades_s) *
                   band.take(dice.real(-1, 1), least_hz, most_hz);
    }
}

// A low tone that sinks, as the air after a blast or the thud of a slab.
void thump(std::vector<double>& into, double from_hz, double to_hz, double sinks_s, double fades_s,
           double loud) {
    double turns = 0;
    for (std::size_t i = 0; i < into.size(); ++i) {
        const double t = static_cast<double>(i) / kRate;
        turns += (to_hz + (from_hz - to_hz) * std::exp(-t / sinks_s)) / kRate;
        into[i] += loud * (1 - std::exp(-t / 0.004)) * std::exp(-t / fades_s) * std::sin(kTurn * turns);
    }
}

std::vector<double> silence(double seconds) {
    return std::vector<double>(static_cast<std::size_t>(seconds * kRate), 0.);
}

struct Note {
    double begin, hz, fades_s;
};

// Soft notes with a little of their octave.
std::vector<double> notes(double seconds, std::initializer_list<Note> all_notes) {
    auto all = silence(seconds);
    for (const auto& [begin, hz, fades_s] : all_notes)
        for (auto i = static_cast<std::size_t>(begin * kRate); i < all.size(); ++i) {
            const double t = static_cast<double>(i) / kRate - begin, phase = kTurn * hz * t;
            all[i] += (1 - std::exp(-t / 0.012)) * std::exp(-t / fades_s) *
                      (std::sin(phase) + 0.15 * std::sin(2 * phase));
        }
    return all;
}

// Knocks of many sizes: the larger, the rarer and the lower.
std::vector<double> stones(double seconds) {
    Dice dice(4);
    auto all = silence(seconds);
    for (int i = 0; i < 260 * seconds; ++i) {
        const double size = std::pow(dice.real(0.02, 1), 2.5);  // m
        ring(all, dice.real(0, seconds - 0.01), dice.real(0.8, 1.3) * 420 / (0.12 + size),
             0.004 + 0.012 * size, 0.25 + size, true);
    }
    return all;
}

std::vector<double> wind(double seconds) {
    Dice dice(5);
    const auto size = static_cast<std::size_t>(seconds * kRate);
    const auto noise = dice.noise(size);
    const Swell gust(dice, size, 1, 4), whistle(dice, size, 1, 6);
    Filter wide, narrow, soft;
    return looped(seconds, [&](std::size_t i) {
        const double strong = 0.25 + 0.75 * gust(i);
        return strong * soft.take(wide.take(noise[i], 180 + 140 * gust(i), 1.2).band +
                                      0.35 * narrow.take(noise[i], 420 + 260 * whistle(i), 0.12).band,
                                  900, 1.4)
                            .low;
    });
}

// A shovel, twice a second.
std::vector<double> scrape(double seconds) {
    Dice dice(6);
    const auto size = static_cast<std::size_t>(seconds * kRate);
    const auto noise = dice.noise(size);
    Band band;
    return looped(seconds, [&](std::size_t i) {
        const double stroke =
            std::abs(std::sin(std::numbers::pi * 8 * static_cast<double>(i) / static_cast<double>(size)));
        return (0.3 + 0.7 * stroke) * band.take(noise[i], 600, 1800 + 1600 * stroke);
    });
}

std::vector<double> blast(double seconds) {
    Dice dice(7);
    auto all = silence(seconds);
    thump(all, 120, 32, 0.07, 0.5, 1);
    burst(all, dice, 0, 0.001, 0.05, 60, 900, 5);
    burst(all, dice, 0, 0.02, 0.5, 30, 320, 3);
    return all;
}

std::vector<double> echo(double seconds) {
    Dice dice(8);
    auto all = silence(seconds);
    thump(all, 80, 34, 0.1, 0.45, 0.6);
    burst(all, dice, 0, 0.09, 0.6, 30, 220, 3);
    return all;
}

// Cracks that run, and the thud of what comes to lie on the ground below.
std::vector<double> crack(double seconds) {
    Dice dice(9);
    auto all = silence(seconds);
    for (int i = 0; i < 14; ++i)
        burst(all, dice, 0.018 * i * dice.real(0.6, 1.4), 0.0005, 0.012, 500, 5000,
              dice.real(0.6, 1.6) / (1 + 0.2 * i));
    auto low = silence(seconds);
    thump(low, 90, 42, 0.08, 0.28, 0.8);
    const auto late = static_cast<std::size_t>(0.09 * kRate);
    for (std::size_t i = late; i < all.size(); ++i) all[i] += low[i - late];
    return all;
}

// Fibres that tear, one after the other.
std::vector<double> splinter(unsigned seed, double seconds, int snaps, double low_hz, double high_hz) {
    Dice dice(seed);
    auto all = silence(seconds);
    for (int i = 0; i < snaps; ++i) {
        const double begin = 0.55 * seconds * std::pow(dice.real(0, 1), 1.8), loud = dice.real(0.3, 1);
        ring(all, begin, dice.real(low_hz, high_hz), dice.real(0.006, 0.03), loud);
        burst(all, dice, begin, 0.0004, 0.008, 400, 3500, 1.5 * loud);
    }
    return all;
}

std::vector<double> wood(double seconds) {
    auto all = splinter(11, seconds, 34, 180, 1100);
    thump(all, 110, 55, 0.05, 0.16, 0.9);
    return all;
}

std::vector<double> wall(double seconds) {
    Dice dice(12);
    auto all = silence(seconds);
    thump(all, 85, 40, 0.06, 0.3, 1.4);
    burst(all, dice, 0, 0.004, 0.25, 120, 2200, 2);
    for (int i = 0; i < 120; ++i)
        ring(all, 1.3 * std::sqrt(dice.real(0, 1)), dice.real(350, 1900), dice.real(0.004, 0.012),
             dice.real(0.05, 0.35));
    return all;
}

std::vector<double> metal(double seconds) {
    Dice dice(13);
    auto all = silence(seconds);
    for (const double hz : {212., 347., 531., 843., 1291., 1874., 2650.})
        ring(all, 0, hz, 90 / hz, dice.real(0.5, 1));
    burst(all, dice, 0, 0.0005, 0.04, 300, 4500, 2);
    return all;
}

std::vector<double> made(Wave wave, double seconds) {
    switch (wave) {
        case Wave::kRumble:
            return loop_of_noise(1, seconds, 28, 95, {8, 30}, 0.35);
        case Wave::kRoar:
            return loop_of_noise(2, seconds, 160, 900, {10, 60}, 0.45);
        case Wave::kHiss:
            return loop_of_noise(3, seconds, 2400, 8000, {3, 24}, 0.6);
        case Wave::kStones:
            return stones(seconds);
        case Wave::kWind:
            return wind(seconds);
        case Wave::kScrape:
            return scrape(seconds);
        case Wave::kBlast:
            return blast(seconds);
        case Wave::kEcho:
            return echo(seconds);
        case Wave::kCrack:
            return crack(seconds);
        case Wave::kTree:
            return splinter(10, seconds, 16, 220, 1500);
        case Wave::kWood:
            return wood(seconds);
        case Wave::kWall:
            return wall(seconds);
        case Wave::kMetal:
            return metal(seconds);
        case Wave::kHint:
            return notes(seconds, {{0, 659.3, 0.12}, {0.11, 880, 0.16}});
        case Wave::kMedal:
            return notes(seconds,
                         {{0, 523.3, 0.3}, {0.14, 659.3, 0.3}, {0.28, 784, 0.35}, {0.42, 1046.5, 0.4}});
        case Wave::kRefusal:
            return notes(seconds, {{0, 233.1, 0.07}, {0.1, 207.7, 0.09}});
    }
    return {};
}

double root_mean_square(const std::vector<double>& all) {
    double sum = 0;
    for (const double each : all) sum += each * each;
    return std::sqrt(sum / static_cast<double>(all.size()));
}

double greatest(const std::vector<double>& all) {
    double most = 0;
    for (const double each : all) most = std::max(most, std::abs(each));
    return most;
}

}  // namespace

std::span<const WaveInfo, kWaves> wave_infos() {
    return kInfos;
}

const GroupInfo& info_of(Group group) {
    static constexpr std::array<GroupInfo, kGroups> kGroupInfos{
        {{"Flow", "What moves: rumble, roar, hiss, stones."},
         {"Events", "Blasts, slabs, what breaks, the tool in hand."},
         {"Wind", "Air over the ridges."},
         {"Notes", "Quiet notes for a hint, a medal, a refusal."}}};
    return kGroupInfos.at(static_cast<std::size_t>(group));
}

std::vector<float> samples_of(Wave wave) {
    const WaveInfo& info = info_of(wave);
    const auto all = made(wave, info.seconds);
    const double scale =
        info.loops ? std::min(kLoopLevel / root_mean_square(all), static_cast<double>(kPeak) / greatest(all))
                   : static_cast<double>(kPeak) / greatest(all);
    CHECK(std::isfinite(scale));
    std::vector<float> samples(all.size());
    constexpr double kRises = 0.001, kFalls = 0.08;  // s, of a shot
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double t = static_cast<double>(i) / kRate,
                     left = static_cast<double>(all.size() - 1 - i) / kRate;
        const double shape = info.loops ? 1 : std::min({1., t / kRises, left / kFalls});
        samples[i] = static_cast<float>(scale * shape * all[i]);
    }
    return samples;
}

SamplesOfWaves samples_of_waves() {
    SamplesOfWaves all;
    for (const WaveInfo& info : kInfos) all.push_back(samples_of(info.wave));
    return all;
}

}  // namespace game::sound
