#include "sim/world/params.h"

#include <algorithm>
#include <cmath>

#include "sim/core/number_text.h"

namespace sim {
namespace {

template <class Enum>
struct Named {
    Enum value;
    std::string_view name;
};

constexpr Named<Model> kModels[] = {
    {Model::kBcre, "bcre"}, {Model::kBcreInertial, "bcre-inertial"}, {Model::kVoellmy, "voellmy"}};
constexpr Named<Scheme> kSchemes[] = {{Scheme::kLaxFriedrichs, "lax-friedrichs"},
                                      {Scheme::kLocalLaxFriedrichs, "local-lax-friedrichs"},
                                      {Scheme::kMuscl, "muscl"}};
constexpr Named<Law> kLaws[] = {{Law::kConstant, "constant"}, {Law::kSlope, "slope"}, {Law::kShear, "shear"}};
constexpr Named<Border> kBorders[] = {
    {Border::kWall, "wall"}, {Border::kOpen, "open"}, {Border::kSink, "sink"}};

template <class Enum, std::size_t n>
std::string_view name_of(const Named<Enum> (&table)[n], Enum value) {
    for (const auto& entry : table)
        if (entry.value == value) return entry.name;
    return {};
}

template <class Enum, std::size_t n>
std::optional<Enum> value_of(const Named<Enum> (&table)[n], std::string_view name) {
    for (const auto& entry : table)
        if (entry.name == name) return entry.value;
    return std::nullopt;
}

}  // namespace

std::string_view to_string(Model model) {
    return name_of(kModels, model);
}
std::string_view to_string(Scheme scheme) {
    return name_of(kSchemes, scheme);
}
std::string_view to_string(Law law) {
    return name_of(kLaws, law);
}
std::string_view to_string(Border border) {
    return name_of(kBorders, border);
}
std::optional<Model> model_from(std::string_view name) {
    return value_of(kModels, name);
}
std::optional<Scheme> scheme_from(std::string_view name) {
    return value_of(kSchemes, name);
}
std::optional<Law> law_from(std::string_view name) {
    return value_of(kLaws, name);
}
std::optional<Border> border_from(std::string_view name) {
    return value_of(kBorders, name);
}

std::optional<std::string> fault_of(const Params& params) {
    for (const ParamInfo& info : kParams) {
        const float value = params.*info.value;
        if (!(value >= info.least && value <= info.most))  // NaN too
            return std::string(info.name) + " is " + number_text(value, info.unit) + ", outside " +
                   number_text(info.least) + " to " + number_text(info.most);
    }
    if (const float eighths = 8 * params.drag_exponent; eighths != std::round(eighths))
        return "drag_exponent is " + number_text(params.drag_exponent) + ", no multiple of 0.125";
    if (params.model == Model::kBcre && params.start_slope < params.stop_slope)
        return "start_slope is below stop_slope";
    if (params.model == Model::kBcreInertial) {
        if (params.friction > params.friction_thin) return "friction is above friction_thin";
        const double started = friction_of(params, double{params.start_depth});
        if (started >= std::min(params.start_slope, params.loose_slope))
            return "friction of a layer of start_depth is not below start_slope and loose_slope, so what "
                   "starts "
                   "would stop at once";
        if (params.start_depth < 3 * params.erosion_depth)
            return "start_depth is below three times erosion_depth, so released material would erode nothing";
    }
    if (params.model != Model::kVoellmy && params.freeze_depth >= params.start_depth)
        return "start_depth is not above freeze_depth";
    return std::nullopt;
}

double friction_of(const Params& params, double h) {
    const double thick = params.friction, more = double{params.friction_thin} - thick;
    const double slides = thick + more * std::exp(-h / double{params.friction_fold_depth});
    const double depth = params.cohesion_depth,
                 sticks = depth > 0 ? (1 - thick) * -std::expm1(-h / depth) * depth / h : 0;
    return (params.fluidization > 0 ? 2 : 1) * slides + sticks;
}

Substeps substeps_of(const Params& params, float dx) {
    if (has_momentum(params.model)) {
        const float diagonal = 1.41421356f * params.greatest_speed;  // the sum of both components
        const int needed = static_cast<int>(std::ceil(diagonal * params.tick_s / dx));
        return {needed, params.tick_s / static_cast<float>(needed)};
    }
    const float speed = params.law == Law::kConstant ? params.rolling_speed : params.max_speed;
    const int count = static_cast<int>(std::ceil(speed * params.tick_s / (params.courant * dx)));
    const int at_least_one = count > 1 ? count : 1;
    return {at_least_one, params.tick_s / static_cast<float>(at_least_one)};
}

}  // namespace sim
