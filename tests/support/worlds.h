#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/engine.h"
#include "sim/initial_state.h"
#include "sim/step.h"
#include "sim/world/params.h"
#include "sim/world/state.h"

namespace support {

// A test terrain; all fields start at zero, and all of it has data.
struct Ground {
    sim::Grid grid;
    std::vector<float> bedrock, depth, rolling;  // m
    std::vector<std::uint8_t> has_data;
    std::optional<sim::Params> lower;      // of a world with two materials
    std::vector<float> lower_depth;        // m
    float density = 0, lower_density = 0;  // kg/m³; 0: unknown
    std::vector<sim::Stems> forest;        // none, or one for each vertex
    std::vector<sim::Command> placed;      // things at tick 0
    double earth_budget = -1;              // m³
    std::optional<sim::Calendar> weather;

    explicit Ground(const sim::Grid& on);
    // Sets a field from a function of x and y in metres.
    void set(std::vector<float>& field, const std::function<double(double, double)>& of);
    std::size_t at(int x, int y) const;
    sim::InitialState world() const;
};

// bedrock = −tangent · y: slopes down to the north.
Ground plane(int squares, float dx, double tangent, double depth = 0);
// A blunt cone of erodible material on flat bedrock, nowhere steeper than `tangent`.
Ground pile(int squares, float dx, double tangent, double height);
// A rough valley with cover and a heap, for properties that must hold on any ground; `seed` varies it.
Ground rough(int squares, float dx, unsigned seed);

// A world that can be stepped.
struct Play {
    sim::State state;
    sim::Engine engine;

    Play(const Ground& ground, const sim::Params& with, const sim::StepOptions& options = {});
    void ticks(int count, std::span<const sim::Command> first = {});
    // Until everything rests, for at most so many seconds.
    void until_rest(int seconds);
};

// Each scheme of bcre, and the other models.
struct Physics {
    sim::Model model;
    sim::Scheme scheme;
    std::string name() const {
        return std::string(model == sim::Model::kBcre ? sim::to_string(scheme) : sim::to_string(model));
    }
};
inline constexpr Physics kPhysics[] = {{sim::Model::kBcre, sim::Scheme::kLaxFriedrichs},
                                       {sim::Model::kBcre, sim::Scheme::kLocalLaxFriedrichs},
                                       {sim::Model::kBcre, sim::Scheme::kMuscl},
                                       {sim::Model::kBcreInertial, sim::Scheme::kLocalLaxFriedrichs},
                                       {sim::Model::kVoellmy, sim::Scheme::kLocalLaxFriedrichs}};

// Parameters that make all models active on grounds of a few metres per cell.
sim::Params lively(sim::Model model, sim::Scheme scheme = sim::Scheme::kLocalLaxFriedrichs);

// The material snow-dry in bcre-inertial.
sim::Params loose_dry_snow();

// Whether two fields are bit-identical, without the halo.
bool same_bits(const sim::Field<float>& a, const sim::Field<float>& b);

// The same command, with defaults for members that its kind does not use.
sim::Command of_its_kind(const sim::Command& command);

sim::Command pour_at(double x, double y, double radius, double rate, double duration);

}  // namespace support
