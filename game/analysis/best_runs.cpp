#include "game/analysis/best_runs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <optional>
#include <system_error>
#include <tuple>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "game/files/text_file.h"
#include "game/files/user_folders.h"
#include "game/recording/recorder.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtension = ".couloir";
constexpr std::array<std::string_view, 4> kMedalsInNames{"none", "bronze", "silver", "gold"};

std::string run_name(std::int64_t score, int medal, std::uint64_t hash) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{}_{}_{:%Y-%m-%d_%H-%M-%S}_{}{}", score,
                       kMedalsInNames.at(static_cast<std::size_t>(medal)), fmt::localtime(now), hex(hash),
                       kExtension);
}

// Whether a text has the form of a mask, in which 0 stands for any digit.
bool has_form(std::string_view text, std::string_view mask) {
    return std::ranges::equal(
        text, mask, [](char c, char form) { return form == '0' ? c >= '0' && c <= '9' : c == form; });
}

// Takes the text before the first '_' away from a name.
std::string_view take_part(std::string_view& name) {
    const std::string_view part = name.substr(0, name.find('_'));
    name.remove_prefix(std::min(part.size() + 1, name.size()));
    return part;
}

// Nothing if the file has no name of a run.
std::optional<BestRun> run_of(const fs::path& file) {
    const std::string stem = file.stem().string();
    std::string_view rest = stem;
    const std::string_view score = take_part(rest), medal = take_part(rest), date = take_part(rest),
                           time = take_part(rest);
    const auto found = std::ranges::find(kMedalsInNames, medal);
    const auto hash = from_hex(rest);
    BestRun run;
    const auto [end, error] = std::from_chars(score.data(), score.data() + score.size(), run.score);
    if (error != std::errc{} || end != score.data() + score.size() || found == kMedalsInNames.end() ||
        !has_form(date, "0000-00-00") || !has_form(time, "00-00-00") || !hash ||
        file.extension() != kExtension)
        return std::nullopt;
    run.medal = static_cast<int>(found - kMedalsInNames.begin());
    run.when = fmt::format("{} {}", date, time);
    std::ranges::replace(run.when.begin() + 11, run.when.end(), '-', ':');
    run.hash = *hash;
    run.file = file;
    return run;
}

bool is_same_run(const BestRun& one, const BestRun& other) {
    return std::tie(one.score, one.medal, one.hash) == std::tie(other.score, other.medal, other.hash);
}

bool is_better(const BestRun& one, const BestRun& other) {
    return std::tie(other.medal, other.score, one.when, one.hash) <
           std::tie(one.medal, one.score, other.when, other.hash);
}

// The runs of a folder: those that count, the best first, and the rest.
struct Ranking {
    std::vector<BestRun> best, rest;
};
Ranking ranking_of(const fs::path& folder) {
    std::vector<BestRun> all;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (auto run = run_of(entry->path())) all.push_back(std::move(*run));
    std::ranges::sort(all, is_better);
    Ranking ranking;
    for (BestRun& run : all) {
        const bool again =
            std::ranges::any_of(ranking.best, [&](const BestRun& one) { return is_same_run(one, run); });
        const bool counts = !again && ranking.best.size() < kMostBestRuns;
        (counts ? ranking.best : ranking.rest).push_back(std::move(run));
    }
    return ranking;
}

}  // namespace

Outcome<fs::path> best_runs_folder(const Scenario& scenario) {
    const auto folder = data_folder("best");
    if (!folder) return tl::unexpected(folder.error());
    return *folder / fmt::format("{}-{}", file_name_of(scenario.scene), challenge_id(scenario));
}

std::vector<BestRun> best_runs(const fs::path& folder) {
    return ranking_of(folder).best;
}

Outcome<std::string> recording_of_try(const Recording& of, const std::string& name, const Score& score,
                                      const StateLine& at_end) {
    auto recorder = Recorder::fork(in_memory(name), of, name, score.tick);
    if (!recorder) return tl::unexpected(recorder.error());
    if (recorder->last_state() != score.tick)
        if (auto written = recorder->state(at_end); !written) return tl::unexpected(written.error());
    if (auto claimed = recorder->claim(score.claim()); !claimed) return tl::unexpected(claimed.error());
    return recorder->copy_ended_at(score.tick, nullptr);
}

Outcome<void> keep_run(const fs::path& folder, const Score& score, std::uint64_t hash,
                       std::string_view recording) {
    const fs::path file = folder / run_name(score.points, score.medal, hash);
    const BestRun run = run_of(file).value();
    const std::vector<BestRun> best = best_runs(folder);
    if (std::ranges::any_of(best, [&](const BestRun& one) { return is_same_run(one, run); })) return {};
    if (best.size() == kMostBestRuns && !is_better(run, best.back())) return {};
    if (auto written = write_text(file, recording); !written) return written;
    std::error_code ignored;  // it is not shown, and the next run tries again
    for (const BestRun& dropped : ranking_of(folder).rest) fs::remove(dropped.file, ignored);
    return {};
}

}  // namespace game
