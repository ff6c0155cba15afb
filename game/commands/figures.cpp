#include <algorithm>

#include <fmt/format.h>

#include "game/base/print.h"
#include "game/base/process.h"
#include "game/base/progress.h"
#include "game/base/version.h"
#include "game/commands/commands.h"
#include "game/figures/field_figure.h"
#include "game/figures/flow_figure.h"
#include "game/figures/mosaic.h"
#include "game/figures/numbers.h"
#include "game/figures/page.h"
#include "game/figures/world_figure.h"
#include "game/files/assets.h"
#include "game/files/file_use.h"
#include "game/files/text_file.h"

namespace game {
namespace {

constexpr int kFieldsFigure = 6;
constexpr int kMostQuickSquares = 30;

bool is_wanted(const FiguresOptions& options, const std::string& part) {
    return options.only.empty() ||
           std::find(options.only.begin(), options.only.end(), part) != options.only.end();
}

Outcome<PageFigure> draw_fields(const FiguresOptions& options) {
    constexpr double kTime = 1;  // s
    std::vector<render::Picture> pictures;
    for (const auto& flow : {sim::fields::opposed(0.05, 0.5), sim::fields::swinging(45),
                             sim::fields::pinwheel(), sim::fields::disc()})
        pictures.push_back(field_picture(flow, kTime, options.pixels));
    const char* file = "figure-06.png";
    if (auto written = render::write_png(mosaic(pictures, 4), options.folder / file); !written)
        return machine_fails(written.error());
    return PageFigure{
        kFieldsFigure,
        "the four test flows",
        "Velocities after 1 s, with the fronts dashed. From the left: a line at rest; a line that oscillates "
        "along its normal; two lines that rotate about their intersection; a circle that orbits in a flow "
        "straight down.",
        {{file, "(i), (ii), (iii), (iv)"}}};
}

// Draws the wanted figures and returns them sorted by number. Flow figures are drawn first, because they
// share a renderer.
Outcome<std::vector<PageFigure>> draw_all(const FiguresOptions& options, int threads, std::string& made_by) {
    std::vector<PageFigure> shown;
    const auto keep = [&](Outcome<PageFigure>&& figure) -> Outcome<void> {
        if (!figure) return tl::unexpected(figure.error());
        shown.push_back(std::move(*figure));
        return {};
    };
    if (is_wanted(options, fmt::to_string(kFieldsFigure)))
        if (auto drawn = keep(draw_fields(options)); !drawn) return tl::unexpected(drawn.error());
    std::optional<Studio> studio;
    sim::Workers workers(threads);
    for (const FlowFigure& figure : flow_figures()) {
        if (!is_wanted(options, fmt::to_string(figure.number))) continue;
        if (!studio) {
            auto opened = Studio::open(options.gl);
            if (!opened) return tl::unexpected(opened.error());
            studio = std::move(*opened);
            made_by += ", drawn by " + studio->renderer_name();
        }
        Progress progress("drawing");
        progress.show(-1, fmt::format("figure {}", figure.number));
        if (auto drawn = keep(studio->draw(figure, options.folder, options.pixels, workers)); !drawn)
            return tl::unexpected(drawn.error());
    }
    studio.reset();
    sim::StepOptions step_options;
    step_options.threads = threads;
    for (const WorldFigure& figure : world_figures()) {
        if (!is_wanted(options, fmt::to_string(figure.number))) continue;
        const PictureSize size{3 * options.pixels / 2, options.pixels};
        if (auto drawn = keep(draw_world(figure, options.folder, size, options.gl, step_options)); !drawn)
            return tl::unexpected(drawn.error());
    }
    std::sort(shown.begin(), shown.end(),
              [](const PageFigure& a, const PageFigure& b) { return a.number < b.number; });
    return shown;
}

std::vector<int> squares_of(const FiguresOptions& options) {
    std::vector<int> squares{10, 20, 30, 80, 160};
    if (options.quick) std::erase_if(squares, [](int n) { return n > kMostQuickSquares; });
    return squares;
}

}  // namespace

const std::vector<std::string>& parts_of_figures() {
    static const std::vector<std::string> kParts = [] {
        std::vector<int> figures{kFieldsFigure};
        for (const FlowFigure& figure : flow_figures()) figures.push_back(figure.number);
        for (const WorldFigure& figure : world_figures()) figures.push_back(figure.number);
        std::sort(figures.begin(), figures.end());
        std::vector<std::string> parts;
        parts.reserve(figures.size() + 1);
        for (const int number : figures) parts.push_back(fmt::to_string(number));
        parts.emplace_back("numbers");
        return parts;
    }();
    return kParts;
}

Outcome<int> figures(const FiguresOptions& options) {
    FileUse use;
    use.reads(drawing_assets());
    use.writes_into("--out", options.folder, {"figure-*.png", "index.html", "numbers.csv"});
    for (const WorldFigure& figure : world_figures())
        if (const auto path = find_asset(AssetKind::kRecording, figure.recording)) use.reads(*path);
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    if (auto made = make_folder(options.folder); !made) return tl::unexpected(made.error());
    const int threads = options.threads > 0 ? options.threads : processors();
    std::string made_by = fmt::format("{}, commit {}", kProgram, kCommit);
    const auto shown = draw_all(options, threads, made_by);
    if (!shown) return tl::unexpected(shown.error());
    const auto page = options.folder / "index.html";
    // The numbers take minutes, so the page is written now without them.
    if (auto written = write_text(page, page_of(*shown, {}, made_by)); !written)
        return tl::unexpected(written.error());
    std::optional<std::string> miss;
    if (is_wanted(options, "numbers")) {
        const auto numbers = measure_flows(squares_of(options), threads);
        const auto tables = tables_of(numbers);
        auto written = write_text(options.folder / "numbers.csv", csv_of(numbers));
        if (written) written = write_text(page, page_of(*shown, tables, made_by));
        if (!written) return tl::unexpected(written.error());
        for (const Table& table : tables) print_text(as_text(table) + "\n");
        miss = first_miss(numbers);
    }
    print_line(stdout, "{}", page.string());
    if (miss) return tl::unexpected(Failure{Failure::kBadAnswer, *miss});
    return 0;
}

}  // namespace game
