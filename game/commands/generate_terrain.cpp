#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "game/base/number.h"
#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/recording/json_values.h"
#include "sim/core/angle.h"
#include "terrains/export.h"
#include "terrains/generators.h"

namespace game {
namespace {

using terrains::Generated;
using terrains::Generator;

// The generator's numbers, some of them set by "NAME=VALUE".
Outcome<std::vector<double>> values_of(const Generator& generator, const std::vector<std::string>& settings) {
    std::vector<double> values;
    for (const auto& number : generator.numbers) values.push_back(number.usual);
    for (const std::string& setting : settings) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos) return unusable(fmt::format("--set {}: is not NAME=VALUE", setting));
        const std::string_view name = std::string_view(setting).substr(0, equals);
        const auto found = std::ranges::find(generator.numbers, name, &terrains::GeneratorNumber::name);
        if (found == generator.numbers.end())
            return unusable(
                fmt::format("--set {}: {} has no parameter {}; couloir terrain generate --help lists them",
                            setting, generator.name, name));
        const auto value = number_from(std::string_view(setting).substr(equals + 1),
                                       Range<double>{found->lowest, found->highest, found->unit});
        if (!value) return unusable(fmt::format("--set {}: {}", setting, value.error()));
        values[static_cast<std::size_t>(found - generator.numbers.begin())] = *value;
    }
    return values;
}

// Shares of the area by slope, in steps of 15 degrees, the last one all that is steeper.
constexpr std::array kSteps{"0-15", "15-30", "30-45", "45-60", "60-90"};
std::array<double, kSteps.size()> slopes_of(const terrains::Terrain& terrain) {
    const sim::Grid& grid = terrain.grid;
    const auto height = [&](int x, int y) {
        return static_cast<double>(
            terrain.surface[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) +
                            static_cast<std::size_t>(x)]);
    };
    std::array<double, kSteps.size()> shares{};
    for (int y = 1; y + 1 < grid.ny; ++y)
        for (int x = 1; x + 1 < grid.nx; ++x) {
            const double run = 2.0 * static_cast<double>(grid.dx);
            const double rise =
                std::hypot(height(x + 1, y) - height(x - 1, y), height(x, y + 1) - height(x, y - 1));
            const auto step = static_cast<std::size_t>(sim::degrees_of_slope(rise, run) / 15);
            shares[std::min(step, shares.size() - 1)] += 1;
        }
    for (double& share : shares) share /= static_cast<double>(grid.nx - 2) * (grid.ny - 2);
    return shares;
}

Outcome<void> write(const Generated& made, const GenerateOptions& options) {
    const terrains::Terrain& terrain = made.terrain;
    const bool is_text = options.out.extension() == ".asc";
    const auto written =
        is_text ? terrains::write_ascii(options.out, terrain.grid, terrain.georeference, terrain.surface)
                : terrains::write_geotiff(options.out, terrain.grid, terrain.georeference, terrain.surface);
    if (!written) return machine_fails(written.error());
    if (!options.layers) return {};
    if (auto made_folder = make_folder(*options.layers); !made_folder) return made_folder;
    const auto layer = [&](const std::string& name, const std::vector<float>& values) {
        return terrains::write_geotiff(*options.layers / (name + ".tif"), terrain.grid, terrain.georeference,
                                       values);
    };
    if (auto cover = layer("cover", terrain.cover); !cover) return machine_fails(cover.error());
    for (const terrains::GroundLayer& each : made.layers)
        if (auto one = layer(each.name, each.values); !one) return machine_fails(one.error());
    return {};
}

}  // namespace

Outcome<int> generate_terrain(const GenerateOptions& options) {
    const Generator* generator = terrains::find_generator(options.generator);
    if (!generator)
        return unusable(fmt::format("there is no generator '{}'; there are {}", options.generator,
                                    terrains::generator_names()));
    const std::string ending = options.out.extension().string();
    if (ending != ".tif" && ending != ".tiff" && ending != ".asc")
        return unusable(fmt::format("--out {}: its name must end in .tif or .asc", options.out.string()));
    if (options.seed != GenerateOptions().seed && !generator->seeded)
        return unusable(fmt::format("--seed: {} is always the same mountain", generator->name));
    const auto values = values_of(*generator, options.settings);
    if (!values) return tl::unexpected(values.error());
    FileUse use;
    use.writes("--out", options.out).writes_into("--layers", options.layers, {"*.tif"});
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());

    const auto made = generator->make(*values, options.seed,
                                      terrains::GridChoice(options.squares.value_or(generator->squares)));
    if (!made) return unusable(made.error());
    if (auto done = write(*made, options); !done) return tl::unexpected(done.error());

    const terrains::Terrain& terrain = made->terrain;
    const auto [lowest, highest] = std::ranges::minmax(terrain.surface);
    const auto slopes = slopes_of(terrain);
    if (options.json) {
        Json json{{"generator", generator->name}, {"squares", terrain.grid.nx - 1},
                  {"cell_m", terrain.grid.dx},    {"lowest_m", lowest},
                  {"highest_m", highest},         {"slopes_deg", Json::object()}};
        if (generator->seeded) json["seed"] = options.seed;
        for (std::size_t i = 0; i < kSteps.size(); ++i) json["slopes_deg"][kSteps[i]] = slopes[i];
        print_text(printed(json));
        return 0;
    }
    std::string text = fmt::format("{}: {}, {} x {} squares of {:.4g} m, {:.0f} to {:.0f} m; of its area",
                                   options.out.string(), generator->name, terrain.grid.nx - 1,
                                   terrain.grid.ny - 1, terrain.grid.dx, lowest, highest);
    for (std::size_t i = 0; i < kSteps.size(); ++i)
        text += fmt::format("{} {:.0f} % at {} deg", i == 0 ? "" : ",", 100 * slopes[i], kSteps[i]);
    print_line(stdout, "{}", text);
    return 0;
}

}  // namespace game
