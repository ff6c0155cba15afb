#include "tests/support/worlds.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

namespace support {

Ground::Ground(const sim::Grid& on)
    : grid(on),
      bedrock(on.size()),
      depth(on.size()),
      rolling(on.size()),
      has_data(on.size(), 1),
      lower_depth(on.size()) {}

std::size_t Ground::at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
}

sim::InitialState Ground::world() const {
    sim::InitialState world{grid, 0, bedrock, depth, rolling, has_data};
    if (lower) world.lower = sim::InitialState::Lower{*lower, lower_depth};
    world.density = density, world.lower_density = lower_density;
    world.standing = {forest, placed, earth_budget};
    world.weather = weather;
    return world;
}

void Ground::set(std::vector<float>& field, const std::function<double(double, double)>& of) {
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x)
            field[at(x, y)] =
                static_cast<float>(of(x * static_cast<double>(grid.dx), y * static_cast<double>(grid.dx)));
}

Ground plane(int squares, float dx, double tangent, double depth) {
    Ground ground({squares + 1, squares + 1, dx});
    ground.set(ground.bedrock, [&](double, double y) { return -tangent * y; });
    ground.set(ground.depth, [&](double, double) { return depth; });
    return ground;
}

Ground pile(int squares, float dx, double tangent, double height) {
    Ground ground({squares + 1, squares + 1, dx});
    const double middle = squares * static_cast<double>(dx) / 2;
    const double blunt = 5 * static_cast<double>(dx);
    ground.set(ground.depth, [&](double x, double y) {
        const double away = std::hypot(std::hypot(x - middle, y - middle), blunt) - blunt;
        return std::max(0.0, height - tangent * away);
    });
    return ground;
}

Ground rough(int squares, float dx, unsigned seed) {
    Ground ground({squares + 1, squares + 3, dx});  // not square, so that swapped axes show
    std::mt19937 random(seed);
    const auto noise = [&] { return static_cast<double>(random()) / 4294967296.0; };
    ground.set(ground.bedrock,
               [&](double, double y) { return -0.6 * y + 0.8 * noise() * static_cast<double>(dx); });
    ground.set(ground.depth, [&](double, double) { return noise(); });
    ground.set(ground.rolling, [&](double, double) { return noise() < 0.1 ? 0.5 * noise() : 0.0; });
    return ground;
}

Play::Play(const Ground& ground, const sim::Params& with, const sim::StepOptions& options)
    : state(sim::make_state(ground.world(), with)), engine(state, options) {}

void Play::ticks(int count, std::span<const sim::Command> first) {
    for (int i = 0; i < count; ++i)
        sim::step(state, i == 0 ? first : std::span<const sim::Command>{}, engine);
}
void Play::until_rest(int seconds) {
    for (int tick = 0; tick < 60 * seconds && !sim::at_rest(state); ++tick) ticks(1);
}

sim::Params lively(sim::Model model, sim::Scheme scheme) {
    sim::Params params;
    params.model = model;
    params.scheme = scheme;
    params.exchange_rate = 2;
    params.rolling_speed = 5;
    params.stop_slope = 0.5f;
    params.start_slope = 0.7f;
    params.friction = 0.36f;
    params.friction_thin = 0.75f;
    params.drag = 1000;
    params.erosion_slope = params.loose_slope = 0.55f;
    params.deposit_rate = 2;
    params.deposit_speed = 2.5f;
    return params;
}

sim::Params loose_dry_snow() {
    const auto tangent = [](double angle_deg) {
        return static_cast<float>(std::tan(angle_deg * std::numbers::pi / 180));
    };
    sim::Params params;
    params.friction = 0.2f;
    params.drag = 1500;
    params.friction_thin = 1;
    params.friction_fold_depth = 0.1f;
    params.erosion_rate = 0.1f;
    params.erosion_slope = params.loose_slope = tangent(33);
    params.erosion_depth = 0.1f;
    params.deposit_rate = 1.5f;
    params.deposit_speed = 6;
    params.start_slope = tangent(40);
    params.start_depth = 0.5f;
    params.freeze_depth = 0.02f;
    return params;
}

bool same_bits(const sim::Field<float>& a, const sim::Field<float>& b) {
    if (a.nx() != b.nx() || a.ny() != b.ny()) return false;
    for (int y = 0; y < a.ny(); ++y)
        if (std::memcmp(a.row(y), b.row(y), sizeof(float) * static_cast<std::size_t>(a.nx())) != 0)
            return false;
    return true;
}

sim::Command of_its_kind(const sim::Command& command) {
    const sim::CommandInfo& info = sim::info_of(command.kind);
    sim::Command kept;
    kept.kind = command.kind;
    for (const sim::CommandNumber& number : info.numbers) kept.*number.value = command.*number.value;
    if (info.has_layer) kept.layer = command.layer;
    if (info.has_profile) kept.profile = command.profile;
    if (info.has_part) kept.of = command.of;
    if (info.has_param) kept.param = command.param;
    if (info.has_slope) kept.least_slope = command.least_slope, kept.most_slope = command.most_slope;
    return kept;
}

sim::Command pour_at(double x, double y, double radius, double rate, double duration) {
    sim::Command command;
    command.x = x;
    command.y = y;
    command.radius = radius;
    command.rate = rate;
    command.duration = duration;
    return command;
}

}  // namespace support
