#include "game/bench/against.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "files/input.h"
#include "game/base/limits.h"
#include "game/bench/report.h"
#include "terrains/json_reader.h"

namespace game {
namespace {

constexpr double kLeastMs = 0.01;     // shorter times are noise
constexpr double kLeastShare = 0.05;  // of the tick

using Fault = std::runtime_error;

// A required member; throws Fault, which entries_of() catches.
const Json& required(const Json& json, const char* name) {
    if (!json.is_object() || !json.contains(name)) throw Fault(fmt::format("has no \"{}\"", name));
    return json[name];
}
double required_number(const Json& json, const char* name) {
    const Json& value = required(json, name);
    if (!value.is_number() || !(value.get<double>() >= 0) || !std::isfinite(value.get<double>()))
        throw Fault(fmt::format("has a \"{}\" that is not a number above 0", name));
    return value.get<double>();
}
std::string required_text(const Json& json, const char* name) {
    const Json& value = required(json, name);
    if (!value.is_string()) throw Fault(fmt::format("has a \"{}\" that is not a string", name));
    return value.get<std::string>();
}

// The reported parts that are large enough to matter.
void keep_great(BenchEntry& entry) {
    double whole = 0;
    for (const auto& stage : entry.stages)
        if (stage.name == "tick") whole = stage.ms;
    std::erase_if(entry.stages, [&](const BenchEntry::Stage& stage) {
        return stage.ms < kLeastMs || stage.ms < kLeastShare * whole;
    });
}

BenchEntry entry_of_case(const Json& json) {
    BenchEntry entry{fmt::format("{} {} {}", required_text(json, "recording"),
                                 required_number(json, "squares"), required_text(json, "physics")),
                     required_text(json, "end_hash"),
                     {}};
    const Json& stages = required(json, "stages");
    if (!stages.is_object()) throw Fault("has \"stages\" that is not an object");
    const bool drawn = required_number(required(stages, "draw"), "count") > 0;  // else a frame is but a tick
    for (const auto& [name, figures] : stages.items())
        if (required_number(figures, "count") > 0 && (name != "frame" || drawn))
            entry.stages.push_back({name, required_number(figures, "median_ms")});
    keep_great(entry);
    return entry;
}

BenchEntry entry_of_row(const Json& scaling, const Json& row) {
    BenchEntry entry{fmt::format("{} {} {} at {:.0f} s", required_text(scaling, "recording"),
                                 required_number(row, "squares"), required_text(scaling, "physics"),
                                 required_number(row, "time_s")),
                     "",
                     {}};
    const Json& ms = required(row, "ms");
    if (!ms.is_object()) throw Fault("has \"ms\" that is not an object");
    for (const auto& [name, value] : ms.items())
        entry.stages.push_back({name, required_number(ms, name.c_str())});
    keep_great(entry);
    return entry;
}

const Json& list(const Json& json, const char* name) {
    const Json& value = required(json, name);
    if (!value.is_array()) throw Fault(fmt::format("has \"{}\" that is not a list", name));
    return value;
}

}  // namespace

Outcome<Json> read_report(const std::filesystem::path& path) {
    auto stream = files::open_input(path);
    if (!stream) return unusable(stream.error());
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (error || size > kMostReportBytes)
        return unusable(fmt::format("{}: more than {} bytes", path.string(), kMostReportBytes));
    const std::string bytes{std::istreambuf_iterator<char>(*stream), {}};
    auto read = terrains::read_json<Json>(bytes, kReportLimits);
    if (!read) return unusable(fmt::format("{}: {}", path.string(), read.error()));
    Json& json = *read;
    if (!json.is_object() || json.value("format", Json()) != kBenchFormat)
        return unusable(fmt::format("{}: is not a report from bench --summary", path.string()));
    if (json.value("version", Json()) != kBenchVersion)
        return unusable(fmt::format("{}: is of another version than {}", path.string(), kBenchVersion));
    if (const auto entries = entries_of(json); !entries)
        return unusable(fmt::format("{}: {}", path.string(), entries.error()));
    return std::move(json);
}

tl::expected<std::vector<BenchEntry>, std::string> entries_of(const Json& report) try {
    std::vector<BenchEntry> entries;
    for (const Json& each : list(report, "cases")) entries.push_back(entry_of_case(each));
    if (report.contains("scaling")) {
        const Json& scaling = report["scaling"];
        for (const Json& row : list(scaling, "rows")) entries.push_back(entry_of_row(scaling, row));
    }
    return entries;
} catch (const Fault& fault) {
    return tl::unexpected(std::string(fault.what()));
}

BenchComparison compare_entries(const std::vector<BenchEntry>& now, const std::vector<BenchEntry>& then,
                                double tolerance) {
    BenchComparison comparison{
        {"Against the earlier run: medians, ms", {"what", "stage", "then", "now", "ratio", ""}, {}, 2},
        {},
        std::nullopt,
        0};
    double worst = 1 + tolerance;
    for (const BenchEntry& entry : now) {
        const auto earlier = std::find_if(then.begin(), then.end(),
                                          [&](const BenchEntry& each) { return each.key == entry.key; });
        if (earlier == then.end()) {
            comparison.remarks.push_back(fmt::format("{} is not in the earlier run", entry.key));
            continue;
        }
        if (earlier->end_hash != entry.end_hash)
            comparison.remarks.push_back(
                fmt::format("{} ended in another state then, so the work is not the same", entry.key));
        for (const auto& stage : entry.stages) {
            const auto before = std::find_if(earlier->stages.begin(), earlier->stages.end(),
                                             [&](const auto& each) { return each.name == stage.name; });
            if (before == earlier->stages.end()) continue;
            const double ratio = stage.ms / before->ms;
            ++comparison.compared;
            comparison.table.rows.push_back({entry.key, stage.name, fmt::format("{:.4f}", before->ms),
                                             fmt::format("{:.4f}", stage.ms), fmt::format("{:.2f}", ratio),
                                             ratio > 1 + tolerance ? "slower" : ""});
            if (ratio <= worst) continue;
            worst = ratio;
            comparison.too_slow =
                fmt::format("{} of {} takes {:.2f} times as long as then, above the limit {:.2f}", stage.name,
                            entry.key, ratio, 1 + tolerance);
        }
    }
    return comparison;
}

}  // namespace game
