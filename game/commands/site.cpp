#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "game/base/one_line.h"
#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/controls/catalogue.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/session/loaded_world.h"
#include "game/share/share_recording.h"
#include "game/share/site.h"

namespace game {
namespace {

namespace fs = std::filesystem;

// What is known of a page before it is written. `given`: what the user calls its world.
Outcome<SitePage> page_of(const LoadedWorld& world, const std::string& given, const Catalogue& shipped) {
    const Scenario& scenario = world.scene.scenario;
    SitePage page;
    page.name = fs::path(given).stem().string();
    if (!names_a_site_page(page.name))
        return unusable(
            fmt::format("{}: names no page of a site, which has letters, digits, '-' and '_', and is not "
                        "called index",
                        one_line(given)));
    page.title = scenario.title;
    if (scenario.goal) {
        page.shelf = SitePage::Shelf::kChallenges;
        page.medals = scenario.goal->medals;
        page.words = scenario.goal->say;
    } else if (world.watched || !world.scene.commands.empty()) {
        page.shelf = SitePage::Shelf::kSlides;
    }
    const auto entry = std::ranges::find(shipped.scenes, given, &Catalogue::Entry::name);
    if (entry != shipped.scenes.end()) page.harder_than = entry->harder_than;
    for (const char* kind : {".jpg", ".png"}) {
        fs::path picture = world.scene.files.front();
        picture.replace_extension(kind);
        std::error_code error;
        if (page.picture || !fs::is_regular_file(picture, error)) continue;
        page.picture = std::move(picture);
    }
    return page;
}

}  // namespace

Outcome<int> site(const SiteOptions& options) {
    const auto shipped = read_catalogue();
    if (!shipped) return tl::unexpected(shipped.error());
    std::vector<std::string> names = options.worlds;
    if (names.empty())
        for (const Catalogue::Entry& scene : shipped->scenes)
            if (scene.kind != Catalogue::Kind::kFlowDemo) names.push_back(scene.name);  // those have no slide
    Overrides overrides;
    overrides.memory = options.memory;
    overrides.memory.use.page = true;

    // First all that can be refused.
    std::vector<LoadedWorld> worlds;
    std::vector<SitePage> pages;
    FileUse use;
    use.reads(page_assets());
    std::vector<std::string> written = site_names();
    for (const std::string& name : names) {
        auto world = open_anything(name, overrides);
        if (!world) return tl::unexpected(world.error());
        auto page = page_of(*world, name, *shipped);
        if (!page) return tl::unexpected(page.error());
        if (std::ranges::find(pages, page->name, &SitePage::name) != pages.end())
            return unusable(
                fmt::format("{}: another page of the site is already called {}", name, page->name));
        use.reads(world->scene.files).reads(page->picture);
        written.push_back(page->name + ".html");
        worlds.push_back(std::move(*world));
        pages.push_back(std::move(*page));
    }
    use.writes_into("--out", options.folder, written);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    if (auto made = make_folder(options.folder); !made) return tl::unexpected(made.error());

    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        SitePage& page = pages[i];
        print_line(stderr, "couloir: {} of {}: {}", i + 1, worlds.size(), one_line(page.title));
        const auto report =
            write_page_of_loaded(worlds[i], options.folder / (page.name + ".html"), {.site_name = page.name});
        if (!report) return tl::unexpected(report.error());
        for (const std::string& notice : report->notices) print_line(stderr, "couloir: {}", notice);
        page.bytes = report->bytes;
        if (page.words.empty()) page.words = report->about;
        bytes += report->bytes;
    }
    if (auto done = write_site(options.folder, pages); !done) return tl::unexpected(done.error());
    print_line(stdout, "{}: {} pages, {:.0f} MB; any web server may serve this folder",
               (options.folder / "index.html").string(), pages.size(), static_cast<double>(bytes) / 1e6);
    return 0;
}

}  // namespace game
