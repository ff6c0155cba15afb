#include "game/compare/comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "game/analysis/export_results.h"
#include "game/base/print.h"
#include "game/base/progress.h"
#include "game/compare/desync_picture.h"
#include "game/compare/difference_map.h"
#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/pages/table.h"
#include "game/recording/divergence_report.h"
#include "game/recording/recording_file.h"
#include "game/recording/scenario_difference.h"
#include "terrains/export.h"

namespace game {
namespace {

constexpr std::size_t kMostSaid = 8;  // listed differences of scenarios and commands

std::vector<std::uint8_t> extent_of(const Played& played) {
    const std::vector<float>& depth = played.session.peaks().depth;
    std::vector<std::uint8_t> extent(depth.size());
    std::transform(depth.begin(), depth.end(), extent.begin(),
                   [](float metres) { return metres >= Measures::kExtentDepth; });
    return extent;
}

std::vector<float> less(const std::vector<float>& one, const std::vector<float>& other) {
    std::vector<float> difference(one.size());
    std::transform(one.begin(), one.end(), other.begin(), difference.begin(), std::minus<>());
    return difference;
}

// A row of the table: a measure of both, and its number of digits.
struct Row {
    const char *what, *key;
    double a, b;
    int digits;
};

std::vector<Row> rows_of(const Comparison& comparison) {
    const Measures &a = comparison.a.measures, &b = comparison.b.measures;
    const Session &one = comparison.a.session, &other = comparison.b.session;
    const auto out = [](const Session& session) { return session.cubic_metres(session.state().ledger.out); };
    std::vector<Row> rows{
        {"time, s", "seconds", one.seconds(), other.seconds(), 1},
        {"run-out, m", "run_out_m", a.run_out, b.run_out, 1},
        {"fall, m", "fall_m", a.fall, b.fall, 1},
        {"reach, deg", "reach_deg", a.reach_deg, b.reach_deg, 2},
        {"extent, ha", "extent_ha", a.extent_area / 1e4, b.extent_area / 1e4, 3},
        {"eroded, m3", "eroded_m3", a.eroded, b.eroded, 0},
        {"deposited, m3", "deposited_m3", a.deposited, b.deposited, 0},
        {"left the world, m3", "out_m3", out(one), out(other), 0},
        {"peak depth, m", "peak_depth_m", a.peak_depth, b.peak_depth, 2},
        {"peak speed on slope, m/s", "peak_speed_slope_m_s", a.peak_speed_slope, b.peak_speed_slope, 2},
        {"peak speed in plan, m/s", "peak_speed_plan_m_s", a.peak_speed_plan, b.peak_speed_plan, 2}};
    if (a.peak_pressure && b.peak_pressure)
        rows.push_back({"peak pressure, kPa", "peak_pressure_kpa", *a.peak_pressure, *b.peak_pressure, 1});
    return rows;
}

// With a sign, or "0" if all shown digits are zero.
std::string signed_text(double value, int digits) {
    const std::string text = fmt::format("{:+.{}f}", value, digits);
    return text.find_first_of("123456789") == std::string::npos ? "0" : text;
}

std::string extremes(const std::vector<float>& field) {
    const auto [least, most] = std::minmax_element(field.begin(), field.end());
    return fmt::format("{} to {} m", signed_text(*least, 2), signed_text(*most, 2));
}

std::array<std::string, 2> names_of(const Comparison& comparison) {
    return {one_line(comparison.a.of.name), one_line(comparison.b.of.name)};
}

}  // namespace

Outcome<Named> open_recording(const std::string& name_or_path, const Memory& memory) {
    const auto path = find_asset(AssetKind::kRecording, name_or_path);
    if (!path) return tl::unexpected(path.error());
    auto recording = read_recording(*path, memory);
    if (!recording) return tl::unexpected(recording.error());
    if (recording->warning) print_line(stderr, "couloir: warning: {}", *recording->warning);
    if (!is_comparable(recording->header))
        print_line(
            stderr,
            "couloir: {}: recorded with version {} of the physics, played with version {}: its states are "
            "not comparable with the recorded ones",
            path->string(), recording->header.physics_version, kPhysicsVersion);
    return Named{path->stem().string(), *path, std::move(*recording)};
}

Outcome<Played> played(const Named& of, const Until& until, const sim::StepOptions& options,
                       std::optional<Recorder> recorder) {
    const Scenario& scenario = of.recording.header.scenario;
    auto session = Session::begin(scenario, options, std::move(recorder));
    if (!session) return tl::unexpected(session.error());
    if (auto done = play_headless(*session, of.recording.commands, until, {}, of.name); !done)
        return tl::unexpected(done.error());
    if (auto closed = session->finish(); !closed) return tl::unexpected(closed.error());
    const Measures measures = measure(scenario, *session, release_area(scenario, of.recording.commands), {});
    const bool rests = sim::at_rest(session->state());
    return Played{of, std::move(*session), measures, rests};
}

Outcome<void> check_ground(const Named& a, const Named& b) {
    const auto differences = differences_of_ground(a.recording.header.scenario, b.recording.header.scenario);
    if (differences.empty()) return {};
    return unusable(
        fmt::format("{} and {} are not on one ground: {}", a.name, b.name, fmt::join(differences, "; ")));
}

Comparison comparison_of(const Played& a, const Played& b, const sim::StepOptions& options) {
    const Recording &one = a.of.recording, &other = b.of.recording;
    const Scenario &scenario = one.header.scenario, &other_start = other.header.scenario;
    Comparison comparison{.a = a, .b = b};
    comparison.said = differences_of(scenario, other_start);
    for (std::string& difference : differences_of(one.commands, other.commands))
        comparison.said.push_back(std::move(difference));

    comparison.deposit =
        less(deposit_of(other_start, b.session.state()), deposit_of(scenario, a.session.state()));
    comparison.peak_depth = less(b.session.peaks().depth, a.session.peaks().depth);
    for (const float metres : comparison.deposit)
        (metres > 0 ? comparison.more : comparison.less) +=
            std::fabs(static_cast<double>(metres)) * scenario.grid.cell_area();
    comparison.overlap = overlap_of(extent_of(a), extent_of(b));

    comparison.followed = std::min(a.session.state().tick, b.session.state().tick);
    Progress progress("side by side");
    comparison.parted = first_divergence(
        {scenario, one.commands, options, nullptr}, {other_start, other.commands, options, nullptr},
        comparison.followed, [&](std::int64_t tick) {
            progress.show(static_cast<double>(tick) /
                              static_cast<double>(std::max<std::int64_t>(comparison.followed, 1)),
                          "alike so far");
        });
    return comparison;
}

std::string to_text(const Comparison& comparison) {
    const auto names = names_of(comparison);
    std::string text;
    if (comparison.said.empty()) {
        text += "same input: scenario and commands\n";
    } else {
        text += "different input:\n";
        for (std::size_t i = 0; i < std::min(comparison.said.size(), kMostSaid); ++i)
            text += fmt::format("  {}\n", comparison.said[i]);
        if (comparison.said.size() > kMostSaid)
            text += fmt::format("  and {} more\n", comparison.said.size() - kMostSaid);
    }
    Table table{"", {"", names[0], names[1], "difference"}, {}};
    for (const Row& row : rows_of(comparison))
        table.rows.push_back({row.what, fmt::format("{:.{}f}", row.a, row.digits),
                              fmt::format("{:.{}f}", row.b, row.digits),
                              signed_text(row.b - row.a, row.digits)});
    const auto rests = [](const Played& played) { return played.at_rest ? "yes" : "no"; };
    table.rows.push_back({"at rest", rests(comparison.a), rests(comparison.b), ""});
    text += as_text(table) + "\n";
    if (comparison.overlap)
        text += fmt::format("extents overlap by {:.3f} (intersection over union)\n", *comparison.overlap);
    text +=
        fmt::format("deposit, second minus first: {}; {:.0f} m3 more in places, {:.0f} m3 less in others\n",
                    extremes(comparison.deposit), comparison.more, comparison.less);
    text += fmt::format("peak depth, second minus first: {}\n\n", extremes(comparison.peak_depth));
    text += comparison.parted ? to_text(*comparison.parted, comparison.a.of.recording.header.scenario, names)
                              : fmt::format("bit-identical in all {} ticks\n", comparison.followed);
    return text;
}

Json to_json(const Comparison& comparison) {
    Json json;
    const auto side = [&](const Played& played) {
        return Json{{"name", played.of.name},
                    {"scene", played.of.recording.header.scenario.scene},
                    {"ticks", played.session.state().tick},
                    {"at_rest", played.at_rest},
                    {"state_hash", hex(played.session.state_line().hash)}};
    };
    json["first"] = side(comparison.a), json["second"] = side(comparison.b);
    for (const Row& row : rows_of(comparison)) {
        json["first"][row.key] = row.a, json["second"][row.key] = row.b;
        json["difference"][row.key] = row.b - row.a;
    }
    const auto extreme = [](const std::vector<float>& field) {
        const auto [least, most] = std::minmax_element(field.begin(), field.end());
        return Json{{"least_m", shortest(*least)}, {"greatest_m", shortest(*most)}};
    };
    json["deposit"] = extreme(comparison.deposit);
    json["deposit"].update(Json{{"more_m3", comparison.more}, {"less_m3", comparison.less}});
    json["peak_depth"] = extreme(comparison.peak_depth);
    if (comparison.overlap) json["overlap"] = *comparison.overlap;
    json["told_differently"] = comparison.said;
    json["ticks_side_by_side"] = comparison.parted ? comparison.parted->tick : comparison.followed;
    json["same"] = !comparison.parted;
    if (comparison.parted)
        json["parted"] = to_json(*comparison.parted, comparison.a.of.recording.header.scenario);
    return json;
}

Outcome<void> write_maps(const std::filesystem::path& folder, const Comparison& comparison) {
    if (auto made = make_folder(folder); !made) return made;
    const Scenario& scenario = comparison.a.of.recording.header.scenario;
    for (const auto& [name, field] : {std::pair{"difference.tif", &comparison.deposit},
                                      std::pair{"peak_difference.tif", &comparison.peak_depth}})
        if (auto written =
                terrains::write_geotiff(folder / name, scenario.grid, scenario.georeference, *field);
            !written)
            return machine_fails(written.error());
    const auto draw = [&](const render::Picture& picture, const char* name) -> Outcome<void> {
        if (auto written = render::write_png(picture, folder / name, render::kSmallestPngCompression);
            !written)
            return machine_fails(written.error());
        return {};
    };
    if (auto drawn = draw(difference_map(comparison, MapOf::kDeposit), "difference.png"); !drawn)
        return drawn;
    if (auto drawn = draw(difference_map(comparison, MapOf::kPeakDepth), "peak_difference.png"); !drawn)
        return drawn;
    if (!comparison.parted) return {};
    return draw(desync_picture(*comparison.parted, scenario, names_of(comparison)), "desync.png");
}

Outcome<void> tell(const Comparison& comparison, const std::optional<std::filesystem::path>& maps,
                   bool json) {
    if (maps)
        if (auto written = write_maps(*maps, comparison); !written) return written;
    print_text(json ? printed(to_json(comparison)) : to_text(comparison));
    return {};
}

}  // namespace game
