#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sim {

enum class Model { kBcre, kBcreInertial };                          // README.md, "Two models"
enum class Scheme { kLaxFriedrichs, kLocalLaxFriedrichs, kMuscl };  // of kBcre; kBcreInertial has its own
enum class Law { kConstant, kSlope, kShear };  // speed in kBcre: (C), (HK), (T) of bcre/velocity.h
enum class Border { kWall, kOpen, kSink };     // stages.h

enum Side { kWest, kEast, kSouth, kNorth };
inline constexpr std::array<std::string_view, 4> kSides{"west", "east", "south", "north"};

// Every number of the physics, in SI; slopes are tangents. Defaults make a slow dry sand; the presets in
// assets/materials are what scenes use. kParams below gives unit, range and meaning of each.
struct Params {
    Model model = Model::kBcreInertial;
    Scheme scheme = Scheme::kLocalLaxFriedrichs;
    Law law = Law::kConstant;
    std::array<Border, 4> borders{Border::kOpen, Border::kOpen, Border::kOpen, Border::kOpen};  // by Side

    float tick_s = 1.f / 60.f;
    float courant = 0.25f;

    float exchange_rate = 1.5f;
    float exchange_depth = 128.f;
    float stop_slope = 0.6249f;
    float start_slope = 0.7002f;
    float start_depth = 0.3f;
    float freeze_depth = 0.005f;

    float rolling_speed = 1.f;
    float shear_rate = 1.f;

    float speed_per_slope = 15.f;
    float max_speed = 12.f;
    float relaxation_time = 1.5f;
    float half_speed_depth = 0.1f;
    float stop_slope_thick = 0.4663f;
    float stop_fold_depth = 0.1f;
    float deposit_speed = 2.5f;
    float erosion_slope = 0.6494f;
    float erosion_depth = 0.05f;
    float anchor_gain = 1.02f;
    float anchor_margin = 0.02f;
    float anchor_step = 1.f;

    bool operator==(const Params&) const = default;
};

enum class UsedBy { kBoth, kBcre, kBcreInertial };

// One line of the manifest from which scene and recording reader, writer, --help and tests are made.
struct ParamInfo {
    std::string_view name;
    std::string_view unit;  // "1" is a tangent where the name ends in _slope
    float Params::*value;
    float least, most;
    UsedBy used_by;
    std::string_view meaning;
    bool fixed = false;  // for the life of a world
};

inline constexpr ParamInfo kParams[] = {
    {"tick_s", "s", &Params::tick_s, 1e-3f, 0.1f, UsedBy::kBoth, "simulated time between two states", true},
    {"courant", "1", &Params::courant, 0.01f, 0.5f, UsedBy::kBoth,
     "farthest way of the fastest grain in a sub-step, in cells; in bcre-inertial a quarter at most"},
    {"exchange_rate", "1/s", &Params::exchange_rate, 0.f, 100.f, UsedBy::kBoth,
     "how fast layers exchange material, per unit of slope beyond the threshold"},
    {"exchange_depth", "m", &Params::exchange_depth, 1e-3f, 128.f, UsedBy::kBoth,
     "how much of a thick rolling layer exchanges, the lowest part; 128 is all of it"},
    {"stop_slope", "1", &Params::stop_slope, 0.f, 10.f, UsedBy::kBoth,
     "below it rolling material deposits; for bcre-inertial, that of a thin layer"},
    {"start_slope", "1", &Params::start_slope, 0.f, 10.f, UsedBy::kBoth, "above it ground at rest starts"},
    {"start_depth", "m", &Params::start_depth, 0.f, 10.f, UsedBy::kBoth, "depth that starts at once"},
    {"freeze_depth", "m", &Params::freeze_depth, 1.25e-4f, 1.f, UsedBy::kBoth,
     "a rolling layer thinner than this comes to rest"},
    {"rolling_speed", "m/s", &Params::rolling_speed, 0.f, 100.f, UsedBy::kBcre,
     "speed of the rolling layer; by the law shear, of a thin one"},
    {"shear_rate", "1/s", &Params::shear_rate, 0.f, 1000.f, UsedBy::kBcre,
     "by the law shear, how much faster a layer is at its surface than at its ground, per depth"},
    {"speed_per_slope", "m/s", &Params::speed_per_slope, 0.f, 1000.f, UsedBy::kBoth,
     "terminal speed of a deep layer, per unit of surface slope; by the law slope of bcre, of any layer"},
    {"max_speed", "m/s", &Params::max_speed, 0.1f, 200.f, UsedBy::kBoth,
     "greatest terminal speed; greatest of the laws slope and shear of bcre"},
    {"relaxation_time", "s", &Params::relaxation_time, 0.01f, 100.f, UsedBy::kBcreInertial,
     "time to approach the terminal speed by 1 - 1/e"},
    {"half_speed_depth", "m", &Params::half_speed_depth, 1e-4f, 10.f, UsedBy::kBcreInertial,
     "depth of a layer that reaches half of the terminal speed"},
    {"stop_slope_thick", "1", &Params::stop_slope_thick, 0.f, 10.f, UsedBy::kBcreInertial,
     "stop slope of a thick layer"},
    {"stop_fold_depth", "m", &Params::stop_fold_depth, 1e-4f, 10.f, UsedBy::kBcreInertial,
     "depth over which the stop slope falls from thin to thick by 1 - 1/e"},
    {"deposit_speed", "m/s", &Params::deposit_speed, 0.01f, 200.f, UsedBy::kBcreInertial,
     "a layer faster than this deposits nothing"},
    {"erosion_slope", "1", &Params::erosion_slope, 0.f, 10.f, UsedBy::kBcreInertial,
     "above it a layer erodes"},
    {"erosion_depth", "m", &Params::erosion_depth, 0.f, 10.f, UsedBy::kBcreInertial,
     "a rolling layer thinner than this erodes nothing"},
    {"anchor_gain", "1", &Params::anchor_gain, 0.f, 10.f, UsedBy::kBcreInertial,
     "start slope of natural ground, as a multiple of its first slope"},
    {"anchor_margin", "1", &Params::anchor_margin, 0.f, 10.f, UsedBy::kBcreInertial, "and this more"},
    {"anchor_step", "m", &Params::anchor_step, 0.f, 10.f, UsedBy::kBcreInertial,
     "height of a step between a vertex and the next that natural ground holds besides"},
};

inline bool is_used_by(const ParamInfo& info, Model model) {
    return info.used_by == UsedBy::kBoth ||
           info.used_by == (model == Model::kBcre ? UsedBy::kBcre : UsedBy::kBcreInertial);
}

std::string_view to_string(Model model);
std::string_view to_string(Scheme scheme);
std::string_view to_string(Law law);
std::string_view to_string(Border border);
std::optional<Model> model_from(std::string_view name);
std::optional<Scheme> scheme_from(std::string_view name);
std::optional<Law> law_from(std::string_view name);
std::optional<Border> border_from(std::string_view name);

// What is wrong with these parameters, as a sentence; nothing if all is well. Checks each number's range and
// the order that the thresholds must keep.
std::optional<std::string> fault_of(const Params& params);

// Sub-steps of a tick, and the length of one. Fixed by the parameters and the cell alone, so that a replay
// never depends on a reduction over the state.
struct Substeps {
    int count = 1;
    float dt = 0;  // s
};
Substeps substeps_of(const Params& params, float dx);

}  // namespace sim
