#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "game/base/print.h"
#include "game/commands/commands.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"
#include "game/scene/viewpoint.h"
#include "game/session/loaded_world.h"
#include "game/share/beside_page.h"
#include "game/share/share_recording.h"

namespace game {
namespace {

// Seen as the options want it.
Outcome<LoadedWorld> seen(Outcome<LoadedWorld> opened, const ShareOptions& options) {
    if (opened && options.view)
        if (auto looked = look_from(*options.view, opened->scene.scenario); !looked)
            return tl::unexpected(looked.error());
    return opened;
}

PageOptions page_of(const ShareOptions& options, const LoadedWorld& world, bool plays) {
    return {.most_bytes = options.most_bytes, .camera = world.scene.scenario.camera, .plays = plays};
}

void print_written(const ShareOptions& options, std::uint64_t bytes, const char* how) {
    print_line(stdout, "{}: {:.1f} MB; {}", options.out.string(), static_cast<double>(bytes) / 1e6, how);
}

Outcome<void> check_files(const ShareOptions& options, const std::vector<std::filesystem::path>& reads) {
    FileUse use;
    use.reads(reads).reads(page_assets()).writes("--out", options.out);
    if (auto sound = use.check(); !sound) return sound;
    return make_place_for(options.out);
}

// Two worlds in one page, which nobody can take over.
Outcome<int> share_beside(const ShareOptions& options, const LoadedWorld& world, const Overrides& overrides) {
    const auto other = seen(open_anything(*options.beside, overrides), options);
    if (!other) return tl::unexpected(other.error());
    auto reads = world.scene.files;
    reads.insert(reads.end(), other->scene.files.begin(), other->scene.files.end());
    if (auto sound = check_files(options, reads); !sound) return tl::unexpected(sound.error());
    std::array<BesideSlide, 2> slides;
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const LoadedWorld& each = i == 0 ? world : *other;
        auto made = make_page_of_loaded(each, page_of(options, each, false));
        if (!made) return tl::unexpected(made.error());
        for (const std::string& notice : made->report.notices) print_line(stderr, "couloir: {}", notice);
        slides[i] = {each.scene.scenario.title, std::move(made->text)};
    }
    const auto page = beside_page(slides);
    if (!page) return tl::unexpected(page.error());
    if (auto written = write_text(options.out, *page); !written) return tl::unexpected(written.error());
    print_written(options, page->size(), "opens in any browser");
    return 0;
}

}  // namespace

Outcome<int> share(const ShareOptions& options) {
    Overrides overrides;
    overrides.memory = options.memory;
    overrides.memory.use.page = true;
    if (options.lesson.has_value() != options.world.empty())
        return unusable(
            "share takes either a world or --lesson, which has its own recording: couloir share --lesson "
            "NAME --out page.html");
    if (options.lesson && options.beside) return unusable("--beside needs a world, and --lesson is none");
    const auto opened = seen(
        options.lesson ? open_lesson(*options.lesson, overrides) : open_anything(options.world, overrides),
        options);
    if (!opened) return tl::unexpected(opened.error());
    if (options.beside) return share_beside(options, *opened, overrides);
    if (auto sound = check_files(options, opened->scene.files); !sound) return tl::unexpected(sound.error());
    const auto written =
        write_page_of_loaded(*opened, options.out, page_of(options, *opened, !options.watch_only));
    if (!written) return tl::unexpected(written.error());
    for (const std::string& notice : written->notices) print_line(stderr, "couloir: {}", notice);
    print_written(options, written->bytes,
                  options.watch_only ? "opens in any browser"
                                     : "opens in any browser, and whoever opens it can take over");
    return 0;
}

}  // namespace game
