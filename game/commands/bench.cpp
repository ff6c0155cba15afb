#include <fmt/format.h>

#include "game/analysis/trace.h"
#include "game/base/print.h"
#include "game/bench/against.h"
#include "game/bench/page.h"
#include "game/bench/report.h"
#include "game/commands/commands.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/recording/file_hash.h"
#include "game/recording/recording_file.h"
#include "game/scene/shipped_look.h"

namespace game {
namespace {

Outcome<std::vector<BenchRecording>> read_all(const std::vector<std::string>& names, const Memory& memory) {
    std::vector<BenchRecording> recordings;
    for (const std::string& name : names) {
        const auto path = find_asset(AssetKind::kRecording, name);
        if (!path) return tl::unexpected(path.error());
        auto recording = read_recording(*path, memory);
        if (!recording) return tl::unexpected(recording.error());
        if (recording->warning) print_line(stderr, "couloir: warning: {}", *recording->warning);
        if (recording->header.scenario.flow)
            return unusable(
                fmt::format("{}: is a flow demo; bench measures only avalanches", path->string()));
        if (recording->last_tick() < 1) return unusable(fmt::format("{}: contains no ticks", path->string()));
        if (auto taken = take_look(LookFrom::kShipped, recording->header.scenario); !taken)
            return tl::unexpected(taken.error());
        recordings.push_back({path->stem().string(), file_hash(*path), std::move(*recording), *path});
    }
    return recordings;
}

Outcome<std::vector<BenchRecording>> recordings_of(const BenchOptions& options) {
    if (!options.recordings.empty()) return read_all(options.recordings, options.measure.memory);
    if (options.scaling) return read_all({"snow-avalanche"}, options.measure.memory);
    const auto names = asset_names(AssetKind::kRecording);
    if (!names) return tl::unexpected(names.error());
    return read_all(*names, options.measure.memory);
}

FileUse files_of(const BenchOptions& options, const std::vector<BenchRecording>& recordings) {
    FileUse use;
    use.reads(options.against);
    for (const BenchRecording& each : recordings) use.reads(each.file);
    if (options.draws) use.reads(drawing_assets());
    use.writes("--perf", options.perf).writes("--summary", options.summary);
    use.writes("--page", options.page).writes("--trace", options.trace);
    return use;
}

std::vector<BenchPhysics> physics_of(const BenchOptions& options) {
    std::vector<BenchPhysics> all;
    for (const std::string& name : options.physics) all.push_back(*bench_physics_named(name));
    if (all.empty()) all.assign(kBenchPhysics.begin(), kBenchPhysics.end());
    return all;
}

MeasureOptions measure_options_of(const BenchOptions& options) {
    MeasureOptions measure = options.measure;
    measure.memory.use.draws = options.draws;
    if (options.draws)
        measure.memory.use.frames = {options.canvas.size.width, options.canvas.size.height,
                                     options.canvas.samples};
    return measure;
}

Outcome<std::vector<Measured>> measure_cases(const std::vector<BenchRecording>& recordings,
                                             const BenchOptions& options, Canvas* canvas) {
    const std::vector<int> squares = options.squares.empty() ? std::vector{80, 160} : options.squares;
    const auto physics = physics_of(options);
    const std::size_t count = recordings.size() * squares.size() * physics.size();
    std::vector<Measured> cases;
    for (const BenchRecording& recording : recordings)
        for (const int each : squares)
            for (const BenchPhysics& way : physics) {
                auto measured = measure(recording, each, way, measure_options_of(options), canvas,
                                        fmt::format("{} of {}: {}, {} squares, {}", cases.size() + 1, count,
                                                    recording.name, each, way.name));
                if (!measured) return tl::unexpected(measured.error());
                if (!options.trace) measured->last = {};
                cases.push_back(std::move(*measured));
            }
    return cases;
}

Outcome<Scaling> scale(const std::vector<BenchRecording>& recordings, const BenchOptions& options,
                       Canvas* canvas) {
    const BenchRecording& recording = recordings.front();
    const Scenario& scenario = recording.recording.header.scenario;
    const auto physics = physics_of(options);
    // The recording's own physics, unless another is given.
    auto way = physics.front();
    if (options.physics.empty())
        for (const BenchPhysics& each : physics)
            if (is_own(scenario, each)) way = each;
    const std::vector<int> usual(kScalingSquares.begin(), kScalingSquares.end());
    return measure_scaling(recording, options.squares.empty() ? usual : options.squares, way,
                           measure_options_of(options), canvas);
}

Outcome<void> write_all(const BenchReport& report, const std::vector<Table>& tables,
                        const BenchOptions& options) {
    const auto write = [](const auto& path, const auto& make) -> Outcome<void> {
        return path ? write_text(*path, make()) : Outcome<void>();
    };
    auto written = write(options.perf, [&] { return csv_of(report); });
    if (written) written = write(options.summary, [&] { return printed(to_json(report)); });
    if (written) written = write(options.page, [&] { return printable(page_of(report, tables)); });
    if (written)
        written = write(options.trace, [&] {
            std::vector<TracedRun> runs;
            for (const Measured& each : report.cases)
                runs.push_back({fmt::format("{}, {} squares, {}", each.recording, each.squares, each.physics),
                                each.last});
            return trace_of(runs);
        });
    return written;
}

// The report of an earlier run. It is read first, so that any fault in it is reported before measuring.
struct Earlier {
    std::vector<BenchEntry> entries;
    std::string processor;
};
Outcome<Earlier> read_earlier(const std::filesystem::path& path) {
    const auto json = read_report(path);
    if (!json) return tl::unexpected(json.error());
    return Earlier{*entries_of(*json), json->value("/surroundings/processor"_json_pointer, std::string())};
}

Outcome<BenchComparison> compare_with(const Earlier& earlier, const BenchReport& report,
                                      const BenchOptions& options) {
    const Json json = to_json(report);
    BenchComparison comparison = compare_entries(*entries_of(json), earlier.entries, options.tolerance);
    if (comparison.compared == 0)
        return unusable(fmt::format("{}: has no case in common with this run", options.against->string()));
    if (const auto here = json.value("/surroundings/processor"_json_pointer, std::string());
        here != earlier.processor)
        comparison.remarks.push_back(fmt::format("the earlier run used another processor: {}; this one is {}",
                                                 earlier.processor, here));
    for (const std::string& remark : comparison.remarks) print_line(stderr, "couloir: {}", remark);
    return comparison;
}

}  // namespace

Outcome<int> bench(const BenchOptions& options) {
    std::optional<Earlier> earlier;
    if (options.against) {
        auto read = read_earlier(*options.against);
        if (!read) return tl::unexpected(read.error());
        earlier = std::move(*read);
    }
    const auto recordings = recordings_of(options);
    if (!recordings) return tl::unexpected(recordings.error());
    if (auto sound = files_of(options, *recordings).check(); !sound) return tl::unexpected(sound.error());
    for (const auto& file : {options.perf, options.summary, options.page, options.trace})
        if (file)
            if (auto placed = make_place_for(*file); !placed) return tl::unexpected(placed.error());
    std::optional<Canvas> canvas;
    if (options.draws) {
        auto opened = Canvas::open(options.canvas);
        if (!opened) return tl::unexpected(opened.error());
        canvas = std::move(*opened);
    }

    BenchReport report;
    report.around = {options.scaling ? "bench --scaling" : "bench", "", options.measure.step.threads,
                     canvas ? std::optional(canvas->drawn_by()) : std::nullopt};
    if (options.scaling) {
        auto scaling = scale(*recordings, options, canvas ? &*canvas : nullptr);
        if (!scaling) return tl::unexpected(scaling.error());
        report.scaling = std::move(*scaling);
    } else {
        auto cases = measure_cases(*recordings, options, canvas ? &*canvas : nullptr);
        if (!cases) return tl::unexpected(cases.error());
        report.cases = std::move(*cases);
    }

    auto tables = tables_of(report);
    std::optional<BenchComparison> comparison;
    if (earlier) {
        auto compared = compare_with(*earlier, report, options);
        if (!compared) return tl::unexpected(compared.error());
        comparison = std::move(*compared);
        tables.push_back(comparison->table);
    }
    if (auto written = write_all(report, tables, options); !written) return tl::unexpected(written.error());
    if (options.json)
        print_text(printed(to_json(report)));
    else
        for (const Table& table : tables) print_text(as_text(table) + "\n");
    if (const auto fault = report.invalid()) return tl::unexpected(Failure{Failure::kBadAnswer, *fault});
    if (comparison && comparison->too_slow)
        return tl::unexpected(Failure{Failure::kBadAnswer, *comparison->too_slow});
    return 0;
}

}  // namespace game
