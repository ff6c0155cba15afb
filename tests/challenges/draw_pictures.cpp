// Draws the pictures of the shipped scenes at the moment at which most is in motion: of a challenge, in the recording that
// wins it; later if nothing ever moves. assets/scenes/NAME.jpg is for the menu and for the index of a site.
// Run it after a change of a scene or of its looks, for those scenes or for all.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "game/analysis/gallery.h"
#include "game/controls/catalogue.h"
#include "game/files/assets.h"
#include "game/recording/recording_file.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "render/pictures/picture.h"
#include "render/pictures/png.h"
#include "tests/support/places.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLongest = 90 * 60;   // ticks
constexpr std::int64_t kFlowDemo = 10 * 60;  // ticks: the moment of a scene that cannot go back

constexpr int kJpegQuality = 86;

Outcome<void> write_jpeg(const render::Texels& texels, const fs::path& file) {
    const auto output = OIIO::ImageOutput::create("jpeg");
    OIIO::ImageSpec spec(texels.width, texels.height, texels.channels, OIIO::TypeDesc::UINT8);
    spec.attribute("CompressionQuality", kJpegQuality);
    const auto row = static_cast<OIIO::stride_t>(texels.width) * texels.channels;
    if (!output || !output->open(file.string(), spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, texels.values.data() + row * (texels.height - 1),
                             texels.channels, -row) ||
        !output->close())
        return machine_fails(
            fmt::format("{}: {}", file.string(), output ? output->geterror() : OIIO::geterror()));
    return {};
}

Outcome<std::vector<TimedCommand>> commands_of(const std::string& name, const Scene& scene) {
    const fs::path winner = support::source_dir() / "tests/challenges" / (name + "_won.couloir");
    if (!scene.scenario.goal) return scene.commands;
    auto recording = read_recording(winner);
    if (!recording) return tl::unexpected(recording.error());
    return std::move(recording->commands);
}

Outcome<void> play_to_its_moment(Session& session, const std::vector<TimedCommand>& commands,
                                 bool goes_back) {
    Session::Checkpoint best = session.moment();
    std::int64_t most = 0;
    std::vector<sim::Command> due;
    while (session.state().tick < (goes_back ? kLongest : kFlowDemo)) {
        due.clear();
        for (const TimedCommand& each : commands_at(commands, session.state().tick))
            due.push_back(each.command);
        if (auto advanced = session.advance(due); !advanced) return advanced;
        if (!goes_back || session.state().ledger.rolling <= most) continue;
        most = session.state().ledger.rolling;
        best = session.moment();
    }
    return most > 0 ? session.go_to(best) : Outcome<void>();
}

Outcome<void> draw(const std::string& name) {
    const support::TemporaryFolder folder;
    const auto scene = load_scene(name, {});
    if (!scene) return tl::unexpected(scene.error());
    const auto commands = commands_of(name, *scene);
    if (!commands) return tl::unexpected(commands.error());
    auto session = Session::begin(scene->scenario, {}, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    session->follow_fronts(scene->scenario);
    session->follow_powder(scene->scenario);
    session->follow_carried(scene->scenario);
    if (auto played = play_to_its_moment(*session, *commands, !scene->scenario.flow); !played) return played;
    auto gallery = Gallery::open(folder.path(), {Catalogue::kPictureWidth, Catalogue::kPictureHeight}, "auto",
                                 scene->scenario);
    if (!gallery) return tl::unexpected(gallery.error());
    gallery->draw(*session, "large");
    if (auto closed = gallery->close(); !closed) return closed;
    const auto large = render::read_png(folder.path() / "large.png", 3);
    if (!large) return machine_fails(large.error());
    const fs::path jpeg = support::source_dir() / "assets/scenes" / (name + ".jpg");
    if (auto written = write_jpeg(*large, jpeg); !written) return written;
    fmt::print("{}: at {:.1f} s\n", name, session->seconds());
    return {};
}

// A harder challenge has the picture of the other one.
std::vector<std::string> scenes_with_a_picture() {
    const Catalogue catalogue = read_catalogue().value();
    std::vector<std::string> names;
    for (const Catalogue::Entry& scene : catalogue.scenes)
        if (scene.harder_than.empty()) names.push_back(scene.name);
    return names;
}

}  // namespace
}  // namespace game

int main(int count, char** words) {
    std::vector<std::string> names(words + 1, words + count);
    if (names.empty()) names = game::scenes_with_a_picture();
    for (const std::string& name : names)
        if (const auto drawn = game::draw(name); !drawn) {
            fmt::print(stderr, "{}: {}\n", name, drawn.error().sentence);
            return drawn.error().status;
        }
    return 0;
}
