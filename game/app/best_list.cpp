#include "game/app/best_list.h"

#include <exception>
#include <system_error>
#include <utility>

#include "game/files/user_folders.h"
#include "game/scene/scene.h"
#include "game/scene/week.h"

namespace game {
namespace {

namespace fs = std::filesystem;

// Whether there may be runs of a scene of this name.
bool has_runs(const fs::path& all, const std::string& scene) {
    const std::string begin = file_name_of(scene) + '-';
    std::error_code error;
    for (fs::directory_iterator entry(all, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().filename().string().starts_with(begin)) return true;
    return false;
}

// A scene that cannot be loaded has an empty path.
std::map<std::string, fs::path> find_folders(const std::vector<std::string>& scenes,
                                             const std::atomic<bool>& stopped) {
    std::map<std::string, fs::path> folders;
    for (const std::string& name : scenes) {
        if (stopped) break;
        fs::path& found = folders[name];
        try {
            Overrides overrides;
            overrides.week = this_week();
            const auto scene = load_scene(name, overrides);
            if (!scene || !scene->scenario.goal) continue;
            if (const auto folder = best_runs_folder(scene->scenario)) found = *folder;
        } catch (const std::exception&) {  // such as out of memory
        }
    }
    return folders;
}

}  // namespace

void BestList::open(const Scenario& scenario) {
    open_.clear();
    if (scenario.goal)
        if (const auto folder = best_runs_folder(scenario)) open_ = *folder;
    runs_ = open_.empty() ? std::vector<BestRun>() : best_runs(open_);
    outdated_ = true;
}

Outcome<void> BestList::keep(const Score& score, std::uint64_t hash, std::string_view recording) {
    if (open_.empty()) return {};  // nothing can be recorded there either, which was told
    auto kept = keep_run(open_, score, hash, recording);
    runs_ = best_runs(open_);
    outdated_ = true;
    return kept;
}

void BestList::mark(std::vector<Catalogue::Entry>& scenes) {
    if (auto found = job_.result()) {
        if (*found) folders_.merge(**found);
        outdated_ = true;
    }
    if (job_.is_busy() || !std::exchange(outdated_, false)) return;
    for (Catalogue::Entry& scene : scenes) {
        scene.best.reset();
        const auto folder = folders_.find(scene.name);
        if (folder == folders_.end()) continue;
        if (const auto runs = best_runs(folder->second); !runs.empty())
            scene.best = Catalogue::Best{runs.front().score, runs.front().medal};
    }
    look_for_folders(scenes);
}

void BestList::look_for_folders(const std::vector<Catalogue::Entry>& scenes) {
    const auto all = data_folder("best");
    if (!all) return;
    std::vector<std::string> wanted;
    for (const Catalogue::Entry& scene : scenes)
        if (scene.kind == Catalogue::Kind::kChallenge && !folders_.contains(scene.name) &&
            has_runs(*all, scene.name))
            wanted.push_back(scene.name);
    if (wanted.empty()) return;
    // Without a thread the list has no medals.
    (void)job_.begin([wanted = std::move(wanted)](const std::atomic<bool>& stopped) -> Outcome<Folders> {
        return find_folders(wanted, stopped);
    });
}

}  // namespace game
