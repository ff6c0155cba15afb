#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "files/whole_file.h"
#include "game/base/print.h"
#include "game/base/progress.h"
#include "game/commands/commands.h"
#include "game/files/array_file.h"
#include "game/files/file_use.h"
#include "game/files/mesh_file.h"
#include "game/files/text_file.h"
#include "render/pictures/front_picture.h"
#include "sim/core/workers.h"

namespace game {
namespace {

using sim::front::Mesh;
using sim::front::Tracker;

// Opens an array of frames × vertices × `numbers`, or of frames × vertices if `numbers` is 1.
Outcome<ArrayFile> open_frames(const std::filesystem::path& path, const Mesh& mesh, std::int64_t numbers) {
    auto array = ArrayFile::open(path);
    if (!array) return array;
    const auto& shape = array->shape();
    const bool fits = shape.size() == (numbers == 1 ? 2 : 3) && shape[0] > 0 && shape[1] == mesh.vertices() &&
                      (numbers == 1 || shape[2] == numbers);
    if (fits) return array;
    return unusable(fmt::format("{}: its shape is {}; expected frames × {} vertices{}", path.string(),
                                array->shape_text(), mesh.vertices(),
                                numbers == 1 ? "" : fmt::format(" × {}", numbers)));
}

// Errors: those of front_point(), with the frame.
Outcome<void> add_lines(std::string& csv, const Tracker& tracker, std::int64_t frame, double time) {
    for (const auto& point : tracker.points()) {
        const auto told = front_point(tracker, point);
        if (!told) return unusable(fmt::format("frame {}: {}", frame, told.error().sentence));
        fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{}\n", frame, time, told->i, told->j,
                       told->f, told->x, told->y, told->w);
    }
    return {};
}

// Writes to standard output, or to a file that appears only when it is complete.
class Output {
  public:
    static Outcome<Output> open(const std::optional<std::filesystem::path>& path) {
        Output output;
        if (!path) return output;
        if (auto placed = make_place_for(*path); !placed) return tl::unexpected(placed.error());
        auto file = files::WholeFile::open(*path);
        if (!file) return machine_fails(file.error());
        output.file_.emplace(std::move(*file));
        return output;
    }
    Outcome<void> write(std::string_view text) {
        if (file_) return of_machine(file_->write(text));
        if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size()) return {};
        return machine_fails(fmt::format("standard output: cannot be written: {}", std::strerror(errno)));
    }
    Outcome<void> finish() { return file_ ? of_machine(file_->finish()) : Outcome<void>(); }

  private:
    static Outcome<void> of_machine(files::Written written) {
        if (!written) return machine_fails(written.error());
        return {};
    }
    std::optional<files::WholeFile> file_;
};

// Reads the arrays of one flow frame by frame.
class Frames {
  public:
    static Outcome<Frames> open(const TrackOptions& options, const Mesh& mesh) {
        auto velocities = open_frames(options.velocities, mesh, 2);
        if (!velocities) return tl::unexpected(velocities.error());
        Frames frames(std::move(*velocities), mesh);
        if (!options.scalar) return frames;
        auto scalars = open_frames(*options.scalar, mesh, 1);
        if (!scalars) return tl::unexpected(scalars.error());
        if (scalars->shape()[0] != frames.count())
            return unusable(fmt::format("{} has {} frames and {} has {}", options.velocities.string(),
                                        frames.count(), options.scalar->string(), scalars->shape()[0]));
        frames.scalars_ = std::move(*scalars);
        frames.scalar_.resize(frames.velocity_.size());
        return frames;
    }
    std::int64_t count() const { return velocities_.shape()[0]; }
    // Valid until the next call.
    Outcome<sim::front::Flow> next() {
        static_assert(sizeof(glm::vec2) == 2 * sizeof(float));
        auto read = velocities_.read_frame({&velocity_[0].x, 2 * velocity_.size()});
        if (read && scalars_) read = scalars_->read_frame(scalar_);
        if (!read) return tl::unexpected(read.error());
        return sim::front::Flow{velocity_, scalar_};
    }

  private:
    Frames(ArrayFile velocities, const Mesh& mesh)
        : velocities_(std::move(velocities)), velocity_(mesh.position.size()) {}

    ArrayFile velocities_;
    std::optional<ArrayFile> scalars_;
    std::vector<glm::vec2> velocity_;
    std::vector<float> scalar_;
};

Outcome<void> write_picture(const TrackOptions& options, const Tracker& tracker, std::int64_t frame) {
    if (!options.pictures || frame % options.every != 0) return {};
    const auto picture = render::front_picture(tracker, options.size.width, options.size.height);
    const auto written =
        render::write_png(picture, *options.pictures / fmt::format("front_{:06}.png", frame));
    if (!written) return machine_fails(written.error());
    return {};
}

// The counts printed at the end.
struct Tally {
    std::int64_t points = 0, hasty_frames = 0, outrun = 0;

    void add(const Tracker& tracker) {
        points += static_cast<std::int64_t>(tracker.points().size());
        outrun += tracker.outrun(), hasty_frames += tracker.outrun() > 0;
    }
    void tell(std::int64_t frames, const Tracker& tracker) const {
        print_line(stderr, "{} {} of {} vertices, {:.1f} points in each, by {}", frames,
                   frames == 1 ? "frame" : "frames", tracker.mesh().vertices(),
                   static_cast<double>(points) / static_cast<double>(frames), to_string(tracker.source()));
        if (outrun > 0)
            print_line(
                stderr,
                "warning: in {} {} fronts crossed more than half a cell per step, at {} {} in total; points "
                "there are unreliable: use frames closer in time",
                hasty_frames, hasty_frames == 1 ? "frame" : "frames", outrun,
                outrun == 1 ? "vertex" : "vertices");
    }
};

}  // namespace

Outcome<int> track(const TrackOptions& options) {
    const auto mesh = read_obj(options.mesh);
    if (!mesh) return tl::unexpected(mesh.error());
    auto frames = Frames::open(options, *mesh);
    if (!frames) return tl::unexpected(frames.error());
    FileUse use;
    use.reads(options.mesh).reads(options.velocities).reads(options.scalar);
    use.writes("--out", options.out).writes_into("--frames", options.pictures, {"front_*.png"});
    if (options.out) use.leaves_standard_output();
    if (auto sound = use.check(); !sound) return tl::unexpected(sound.error());
    if (options.pictures) {
        if (auto made = make_folder(*options.pictures); !made) return tl::unexpected(made.error());
    }
    auto output = Output::open(options.out);
    if (!output) return tl::unexpected(output.error());

    Tracker tracker(*mesh, rule_of(options.rule, *mesh), *options.rule.source, options.rule.hold);
    sim::Workers workers(options.threads);
    Progress progress("tracking");
    Tally tally;
    std::string csv = "frame,time_s,i,j,f,x,y,w\n";
    for (std::int64_t frame = 0; frame < frames->count(); ++frame) {
        const auto flow = frames->next();
        if (!flow) return tl::unexpected(flow.error());
        tracker.advance(*flow, options.dt, workers);
        tally.add(tracker);
        const auto added = add_lines(csv, tracker, frame, static_cast<double>(frame) * options.dt);
        if (!added) return unusable(options.velocities.string() + ": " + added.error().sentence);
        if (auto written = output->write(csv); !written) return tl::unexpected(written.error());
        csv.clear();
        if (auto written = write_picture(options, tracker, frame); !written)
            return tl::unexpected(written.error());
        progress.show(static_cast<double>(frame + 1) / static_cast<double>(frames->count()),
                      fmt::format("frame {}", frame));
    }
    if (auto finished = output->finish(); !finished) return tl::unexpected(finished.error());
    tally.tell(frames->count(), tracker);
    return 0;
}

}  // namespace game
