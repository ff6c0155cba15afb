#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sim {

enum class Model { kBcre, kBcreInertial, kVoellmy };  // docs/physics.md, "Equations"
inline constexpr std::array kEveryModel{Model::kBcre, Model::kBcreInertial, Model::kVoellmy};
// Whether forces change the velocity of the rolling layer; in bcre its speed is given.
inline constexpr bool has_momentum(Model model) {
    return model != Model::kBcre;
}
enum class Scheme { kLaxFriedrichs, kLocalLaxFriedrichs, kMuscl };  // kBcre only; the others have their own
enum class Law { kConstant, kSlope, kShear };  // speed in kBcre: (C), (HK), (T) of bcre/velocity.h
enum class Border { kWall, kOpen, kSink };     // stages.h

enum Side { kWest, kEast, kSouth, kNorth };
inline constexpr std::array<std::string_view, 4> kSides{"west", "east", "south", "north"};

inline constexpr double kGravity = 9.81;       // m/s²
inline constexpr double kWaterDensity = 1000;  // kg/m³

// Every parameter of the physics, in SI units; slopes are tangents. The defaults describe a slow dry sand.
// Scenes use the presets in assets/materials. kParams below gives unit, range and meaning of each.
struct Params {
    Model model = Model::kBcreInertial;
    Scheme scheme = Scheme::kLocalLaxFriedrichs;
    Law law = Law::kConstant;
    std::array<Border, 4> borders{Border::kOpen, Border::kOpen, Border::kOpen, Border::kOpen};  // by Side

    // kg/m³, of the material; 0: unknown, and then nothing breaks and a forest catches nothing. A constant of a world.
    float density = 0;

    float tick_s = 1.f / 60.f;
    float courant = 0.25f;

    float start_slope = 0.7002f;
    float start_depth = 0.3f;
    float freeze_depth = 0.005f;

    float exchange_rate = 1.5f;
    float exchange_depth = 128.f;
    float stop_slope = 0.6249f;
    float rolling_speed = 1.f;
    float shear_rate = 1.f;
    float speed_per_slope = 15.f;
    float max_speed = 12.f;

    float friction = 0.55f;
    float drag = 400.f;
    float friction_thin = 0.7002f;
    float friction_fold_depth = 0.1f;
    float erosion_rate = 0.3f;
    float erosion_slope = 0.6494f;
    float erosion_depth = 0.05f;
    float deposit_rate = 5.f;
    float deposit_speed = 1.f;
    float loose_slope = 0.6494f;
    float anchor_gain = 1.02f;
    float anchor_margin = 0.02f;
    float anchor_step = 1.f;

    float drag_exponent = 0.f;
    float fluidization = 0.f;
    float cohesion_depth = 0.f;
    float greatest_speed = 150.f;
    float levelling = 0.f;

    bool operator==(const Params&) const = default;
};

enum class UsedBy { kAll, kBcre, kBcreInertial, kExchange, kMomentum };  // the models that have it

// One row of the manifest that generates the readers and writers of scenes and recordings, the panels and
// tests.
struct ParamInfo {
    std::string_view name;
    std::string_view unit;  // "1" is a tangent if the name ends in _slope
    float Params::*value;
    float least, most;
    UsedBy used_by;
    std::string_view meaning;
    bool fixed = false;  // cannot change while a world exists
    int since = 0;  // minor version of the recordings that have it; in older ones it is the default of Params
};

inline constexpr ParamInfo kParams[] = {
    {"tick_s", "s", &Params::tick_s, 1e-3f, 0.1f, UsedBy::kAll, "simulated time per tick", true},
    {"courant", "1", &Params::courant, 0.01f, 0.5f, UsedBy::kBcre,
     "Courant number: most cells the flow may cross per sub-step"},
    {"exchange_rate", "1/s", &Params::exchange_rate, 0.f, 100.f, UsedBy::kBcre,
     "rate of exchange between the layers, per unit of slope beyond the threshold"},
    {"exchange_depth", "m", &Params::exchange_depth, 1e-3f, 128.f, UsedBy::kBcre,
     "greatest thickness of the rolling layer, from its base, that exchanges; 128: all of it"},
    {"stop_slope", "1", &Params::stop_slope, 0.f, 10.f, UsedBy::kBcre, "slope below which the flow deposits"},
    {"start_slope", "1", &Params::start_slope, 0.f, 10.f, UsedBy::kExchange,
     "slope above which ground at rest fails"},
    {"start_depth", "m", &Params::start_depth, 0.f, 10.f, UsedBy::kExchange,
     "depth released at once when ground fails"},
    {"freeze_depth", "m", &Params::freeze_depth, 1.25e-4f, 1.f, UsedBy::kExchange,
     "depth below which a rolling layer comes to rest"},
    {"rolling_speed", "m/s", &Params::rolling_speed, 0.f, 100.f, UsedBy::kBcre,
     "speed of the rolling layer; with law shear, of a thin layer"},
    {"shear_rate", "1/s", &Params::shear_rate, 0.f, 1000.f, UsedBy::kBcre,
     "shear rate of law shear: speed gained from base to surface, per metre of depth"},
    {"speed_per_slope", "m/s", &Params::speed_per_slope, 0.f, 1000.f, UsedBy::kBcre,
     "speed per unit of surface slope, with law slope"},
    {"max_speed", "m/s", &Params::max_speed, 0.1f, 200.f, UsedBy::kBcre,
     "greatest speed with laws slope and shear"},
    {"friction", "1", &Params::friction, 0.f, 2.f, UsedBy::kMomentum,
     "Coulomb friction of a thick layer: shear stress per normal stress at the base"},
    {"drag", "m/s2", &Params::drag, 10.f, 1e6f, UsedBy::kMomentum,
     "turbulent friction coefficient xi; smaller is slower; 1e6: hardly any drag"},
    {"friction_thin", "1", &Params::friction_thin, 0.f, 2.f, UsedBy::kBcreInertial,
     "Coulomb friction of a layer whose thickness goes to 0"},
    {"friction_fold_depth", "m", &Params::friction_fold_depth, 1e-4f, 10.f, UsedBy::kBcreInertial,
     "thickness over which friction falls from friction_thin toward friction, by 1 - 1/e"},
    {"erosion_rate", "1", &Params::erosion_rate, 0.f, 10.f, UsedBy::kBcreInertial,
     "depth eroded per distance travelled, per unit of slope beyond erosion_slope"},
    {"erosion_slope", "1", &Params::erosion_slope, 0.f, 10.f, UsedBy::kBcreInertial,
     "slope of the standing layer above which a flow erodes it"},
    {"erosion_depth", "m", &Params::erosion_depth, 0.f, 10.f, UsedBy::kBcreInertial,
     "depth below which a rolling layer erodes nothing"},
    {"deposit_rate", "1/s", &Params::deposit_rate, 0.f, 100.f, UsedBy::kBcreInertial,
     "share of a slow layer that is deposited per second, per unit of slope below its friction"},
    {"deposit_speed", "m/s", &Params::deposit_speed, 0.01f, 200.f, UsedBy::kBcreInertial,
     "speed above which a layer deposits nothing"},
    {"loose_slope", "1", &Params::loose_slope, 0.f, 10.f, UsedBy::kBcreInertial,
     "slope above which loose material starts: what was poured or deposited"},
    {"anchor_gain", "1", &Params::anchor_gain, 0.f, 10.f, UsedBy::kBcreInertial,
     "slope at which natural ground fails, as a multiple of its initial slope"},
    {"anchor_margin", "1", &Params::anchor_margin, 0.f, 10.f, UsedBy::kBcreInertial,
     "slope added to anchor_gain times the initial slope before natural ground fails"},
    {"anchor_step", "m", &Params::anchor_step, 0.f, 10.f, UsedBy::kBcreInertial,
     "height of a scarp across two cells at which natural ground beside it stays stable"},
    {"drag_exponent", "1", &Params::drag_exponent, 0.f, 1.f, UsedBy::kMomentum,
     "power of the thickness with which xi grows: drag is that of 1 m; a multiple of 0.125", true, 1},
    {"fluidization", "1", &Params::fluidization, 0.f, 10.f, UsedBy::kMomentum,
     "v2/(N h) at which friction is 1.5 times that of a fast layer; at rest it is twice that; 0: the same at "
     "any "
     "speed",
     false, 1},
    {"cohesion_depth", "m", &Params::cohesion_depth, 0.f, 10.f, UsedBy::kMomentum,
     "cohesion at the base over density and g: the thickness that weighs as much", false, 1},
    {"greatest_speed", "m/s", &Params::greatest_speed, 10.f, 150.f, UsedBy::kMomentum,
     "greatest speed in plan, which bounds the sub-steps; what is faster is slowed to it and counted", true,
     1},
    {"levelling", "1", &Params::levelling, 0.f, 1.f, UsedBy::kMomentum,
     "share of the speed by which a surface that jumps between two cells levels itself; 0: none", true, 2},
};

inline bool is_used_by(const ParamInfo& info, Model model) {
    switch (info.used_by) {
        case UsedBy::kAll:
            return true;
        case UsedBy::kBcre:
            return model == Model::kBcre;
        case UsedBy::kBcreInertial:
            return model == Model::kBcreInertial;
        case UsedBy::kExchange:
            return model != Model::kVoellmy;
        case UsedBy::kMomentum:
            return has_momentum(model);
    }
    return false;
}

std::string_view to_string(Model model);
std::string_view to_string(Scheme scheme);
std::string_view to_string(Law law);
std::string_view to_string(Border border);
std::optional<Model> model_from(std::string_view name);
std::optional<Scheme> scheme_from(std::string_view name);
std::optional<Law> law_from(std::string_view name);
std::optional<Border> border_from(std::string_view name);

// What is wrong with these parameters, as a sentence; nothing if they are valid. Checks the range of each
// number and the required order of the thresholds.
std::optional<std::string> fault_of(const Params& params);

// Friction on level ground of a layer of thickness h, m, at rest, in bcre-inertial (momentum/friction.h).
double friction_of(const Params& params, double h);

// Number and length of the sub-steps of a tick. Depends only on the parameters and the cell size, so that a
// replay never depends on a reduction over the state.
struct Substeps {
    int count = 1;
    float dt = 0;  // s
};
Substeps substeps_of(const Params& params, float dx);

}  // namespace sim
