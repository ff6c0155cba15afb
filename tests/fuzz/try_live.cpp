#include "tests/fuzz/try_reader.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <fmt/format.h>

#include "game/controls/tools.h"
#include "game/live/live_world.h"
#include "game/live/picture.h"
#include "tests/fuzz/try_recording.h"

namespace game::test {
namespace {

constexpr int kAsked = 40;  // questions to a world

// What a page asks next, as the bytes of the file decide.
class LiveQuestions {
  public:
    LiveQuestions(LiveWorld& world, std::string_view bytes)
        : world_(world), bits_(static_cast<unsigned>(std::hash<std::string_view>{}(bytes))) {}

    void ask() {
        switch (below(10)) {
            case 0:
                return ignore(world_.take_over());
            case 1:
                return ignore(world_.undo());
            case 2:
                return ignore(world_.redo());
            case 3:
                return ignore(world_.seek(below(200) - 20, below(60)));
            case 4:
                return world_.release();
            case 5:
                return world_.move_to(below(4) == 0 ? std::nullopt : std::optional(somewhere()));
            case 6: {
                const auto tools = tool_infos();
                const auto which = static_cast<std::size_t>(below(static_cast<int>(tools.size())));
                const auto& info = sim::info_of(tools[which].plain->kind);
                return ignore(world_.set_brush({{"tool", info.name}, {"radius", below(40)}}));
            }
            case 7:
                return ignore(world_.would_act());
            case 8:
                return world_.press({.shift = below(4) == 0, .control = below(4) == 0}, somewhere());
            default:
                return ignore(world_.advance(below(12)));
        }
    }

  private:
    template <class T>
    static void ignore(const T& /*answer*/) {}
    int below(int n) { return static_cast<int>(bits_() % static_cast<unsigned>(n)); }
    // On the ground of a small world, beside it, or nowhere.
    glm::dvec2 somewhere() {
        constexpr std::array kFar{-1e30, 1e30, -0.0, 1e-310, 1e5};
        const auto along = [&] {
            return below(16) == 0 ? kFar[static_cast<std::size_t>(below(5))] : below(4000) * 0.1;
        };
        return {along(), along()};
    }

    LiveWorld& world_;
    std::minstd_rand bits_;
};

// What was done is a recording that opens again.
Outcome<void> check_recorded(const LiveWorld& world, const std::string& name) {
    const auto text = world.recorded();
    if (!text) return {};  // nobody took over
    if (!text->starts_with(world.recorded_in_place())) return broken("what remains is not what was recorded");
    const auto again = LiveWorld::open(*text, name);
    return again ? Outcome<void>() : broken("what was done is refused: " + again.error().sentence);
}

Outcome<void> try_live(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    auto world = LiveWorld::open(chained_anew(bytes), file.filename().string());
    if (!world) return tl::unexpected(world.error());
    if (world->state().grid.nx > 4 * kTriedSquares || world->state().grid.ny > 4 * kTriedSquares)
        return {};  // a try is fast
    LivePicture picture;
    picture.cover().assign(world->state().grid.nx * world->state().grid.ny, glm::vec2(0));
    LiveQuestions questions(*world, bytes);
    for (int i = 0; i < kAsked; ++i) {
        questions.ask();
        world->status().dump(-1, ' ', false, Json::error_handler_t::replace);
        if (i % 8 != 0) continue;
        const auto* const flow = picture.flow(*world);
        for (const std::uint32_t index : flow ? flow->indices() : std::span<const std::uint32_t>())
            if (index >= flow->vertices().size()) return broken(fmt::format("a corner {}", index));
        picture.build(*world, {0, 0, 1});
        picture.plant(*world);
        picture.mixture(*world);
        picture.stands(*world);
    }
    return check_recorded(*world, file.filename().string());
}

}  // namespace

const TriedReader kTriedLive{"live", "x.couloir", try_live};

}  // namespace game::test
