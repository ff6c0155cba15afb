#include "game/files/film.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "files/destination.h"
#include "game/files/ffmpeg.h"
#include "game/files/part_file.h"
#include "game/files/text_file.h"
#include "sim/core/check.h"

namespace game {
namespace {

using Words = std::vector<std::string>;

// An encoder of images and how it is used: quality by eye, and fast enough to keep up with drawing.
struct ImageEncoder {
    std::string name;
    Words options;
};

// A kind of file. Its ending says which.
struct Container {
    std::string ending, format;
    std::vector<ImageEncoder> images;  // in order of liking
    std::string sound;                 // encoder
    Words options = {};
};

const std::vector<Container>& containers() {
    static const std::vector<Container> kContainers{
        {".mp4",
         "mp4",
         {{"libx264", {"-preset", "veryfast", "-crf", "20"}}},
         "aac",
         {"-movflags", "+faststart"}},
        {".webm",
         "webm",
         {{"libvpx-vp9",
           {"-crf", "32", "-b:v", "0", "-deadline", "realtime", "-cpu-used", "6", "-row-mt", "1"}}},
         "libopus"},
        {".mkv",
         "matroska",
         {{"libsvtav1", {"-preset", "10", "-crf", "32"}},
          {"libaom-av1", {"-crf", "32", "-b:v", "0", "-cpu-used", "8", "-row-mt", "1"}}},
         "libopus"}};
    return kContainers;
}

const Container* container_of(const std::filesystem::path& path) {
    const auto found = std::ranges::find(containers(), path.extension().string(), &Container::ending);
    return found == containers().end() ? nullptr : &*found;
}

void append(Words& words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
}

Words beginning() {
    // With -xerror it fails too if only the last bytes cannot be written.
    return {"-hide_banner", "-nostdin", "-loglevel", "error", "-xerror", "-y"};
}

// The name of a file, which ffmpeg would else take for an address or an option.
std::string file_name(const std::filesystem::path& path) {
    return "file:" + std::filesystem::absolute(path).string();
}

// From images on standard input to a film without sound. Colours are those of BT.709, and the file says so, because
// players guess else, and guess BT.601 for small ones.
Words encoding(const Container& container, const ImageEncoder& encoder, const Film::Format& format,
               const std::filesystem::path& into) {
    Words words = beginning();
    append(words, {"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
                   fmt::format("{}x{}", format.width, format.height), "-framerate",
                   fmt::format("{}", format.fps), "-i", "pipe:0"});
    append(words, {"-vf", "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p", "-color_range", "tv",
                   "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"});
    append(words, {"-c:v", encoder.name});
    append(words, encoder.options);
    append(words, container.options);
    append(words, {"-f", container.format, file_name(into)});
    return words;
}

// From a film and a sound to a film with it.
Words joining(const Container& container, const std::filesystem::path& film, const std::filesystem::path& wav,
              const std::filesystem::path& into) {
    Words words = beginning();
    append(words, {"-f", container.format == "webm" ? "matroska" : container.format, "-i", file_name(film),
                   "-f", "wav", "-i", file_name(wav)});
    append(words, {"-map", "0:v", "-map", "1:a", "-c:v", "copy", "-c:a", container.sound, "-b:a", "160k"});
    append(words, container.options);
    append(words, {"-f", container.format, file_name(into)});
    return words;
}

// The one that this machine has. Errors (status 3): none, or none for the sound.
Outcome<ImageEncoder> encoder_for(const Container& container) {
    const auto there = encoders_of_ffmpeg();
    if (!there) return tl::unexpected(there.error());
    const auto has = [&](const std::string& name) { return std::ranges::find(*there, name) != there->end(); };
    const auto found = std::ranges::find_if(container.images, has, &ImageEncoder::name);
    const std::string& missing =
        found == container.images.end() ? container.images.back().name : container.sound;
    if (found == container.images.end() || !has(container.sound))
        return machine_fails(
            fmt::format("ffmpeg here has no encoder {}, which {} needs; choose another ending", missing,
                        container.ending));
    return *found;
}

}  // namespace

struct Film::Parts {
    Parts(std::filesystem::path name, std::filesystem::path target, const Container& container,
          const Format& format, PartFile part, Ffmpeg encoder)
        : path(std::move(name)),
          place(std::move(target)),
          kind(container),
          size(format),
          images(std::move(part)),
          ffmpeg(std::move(encoder)),
          writer([this] { write_all(); }) {}
    ~Parts() {
        ffmpeg.stop();
        end(true);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    std::filesystem::path path, place;  // as given; the file that it replaces
    const Container& kind;
    Format size;
    std::int64_t frames = 0;
    PartFile images;  // the film without sound
    Ffmpeg ffmpeg;

    std::mutex mutex;  // guards the next four members
    std::condition_variable changed;
    std::deque<render::Picture> waiting;
    bool closing = false, broken = false;  // no more come; ffmpeg takes no more
    std::thread writer;                    // last, because it uses the others

    void write_all() {
        std::unique_lock lock(mutex);
        while (true) {
            changed.wait(lock, [this] { return closing || !waiting.empty(); });
            if (waiting.empty()) return;
            const render::Picture picture = std::move(waiting.front());
            waiting.pop_front();
            changed.notify_all();
            lock.unlock();
            const bool written = ffmpeg.write(picture.pixels);
            lock.lock();
            if (written) continue;
            broken = true;
            waiting.clear();
            changed.notify_all();
            return;
        }
    }
    // Waits until all images are written, or drops those that are not.
    void end(bool drops) {
        {
            const std::scoped_lock lock(mutex);
            closing = true;
            if (drops) waiting.clear();
            changed.notify_all();
        }
        if (writer.joinable()) writer.join();
    }
    Failure named(const Failure& failure) const {
        return {failure.status, fmt::format("{}: cannot be written: {}", path.string(), failure.sentence)};
    }
    // Ends ffmpeg, once the writer has ended.
    Outcome<void> finish() {
        if (auto finished = ffmpeg.finish(); !finished) return tl::unexpected(named(finished.error()));
        if (!broken) return {};
        return tl::unexpected(named({Failure::kMachine, "ffmpeg ended before the film did"}));
    }
};

Outcome<void> Film::check(const std::filesystem::path& path, const Format& format) {
    if (!container_of(path))
        return unusable(fmt::format("{}: the name of a film ends in .mp4 (H.264), .webm (VP9) or .mkv (AV1)",
                                    path.string()));
    if (format.width % 2 != 0 || format.height % 2 != 0)
        return unusable(fmt::format("{}: a film has an even width and height, not {}x{}; use --size {}x{}",
                                    path.string(), format.width, format.height, format.width / 2 * 2,
                                    format.height / 2 * 2));
    CHECK(format.width > 0 && format.height > 0 && format.fps > 0);
    return {};
}

Outcome<Film> Film::open(const std::filesystem::path& path, const Format& format) {
    if (auto fits = check(path, format); !fits) return tl::unexpected(fits.error());
    const auto destination = files::destination_of(path);
    if (destination.kind != files::Destination::Kind::kFile)
        return machine_fails(fmt::format("{}: is no file, and a film needs one", path.string()));
    const Container& container = *container_of(path);
    const auto encoder = encoder_for(container);
    if (!encoder) return tl::unexpected(encoder.error());
    if (auto placed = make_place_for(path); !placed) return tl::unexpected(placed.error());
    auto images = PartFile::beside(destination.path);
    if (!images) return tl::unexpected(images.error());
    auto ffmpeg = Ffmpeg::start(encoding(container, *encoder, format, images->path()));
    if (!ffmpeg) return tl::unexpected(ffmpeg.error());
    return Film(std::make_unique<Parts>(path, destination.path, container, format, std::move(*images),
                                        std::move(*ffmpeg)));
}

Film::Film(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Film::~Film() = default;
Film::Film(Film&&) noexcept = default;
Film& Film::operator=(Film&&) noexcept = default;

Outcome<void> Film::add(render::Picture picture) {
    CHECK(picture.width == parts_->size.width && picture.height == parts_->size.height &&
          picture.channels == 3);
    {
        std::unique_lock lock(parts_->mutex);
        CHECK(!parts_->closing);
        parts_->changed.wait(lock, [this] { return parts_->waiting.size() < kWaiting || parts_->broken; });
        if (!parts_->broken) {
            parts_->waiting.push_back(std::move(picture));
            ++parts_->frames;
            parts_->changed.notify_all();
            return {};
        }
    }
    parts_->end(true);
    return parts_->finish();
}

std::int64_t Film::frames() const {
    return parts_->frames;
}

Outcome<void> Film::close(const std::optional<std::filesystem::path>& wav) {
    parts_->end(false);
    if (parts_->frames == 0)
        return unusable(fmt::format("{}: a film needs an image at least", parts_->path.string()));
    if (auto finished = parts_->finish(); !finished) return finished;
    if (!wav) return parts_->images.become(parts_->place);
    auto whole = PartFile::beside(parts_->place);
    if (!whole) return tl::unexpected(whole.error());
    auto ffmpeg = Ffmpeg::start(joining(parts_->kind, parts_->images.path(), *wav, whole->path()));
    if (!ffmpeg) return tl::unexpected(ffmpeg.error());
    if (auto joined = ffmpeg->finish(); !joined) return tl::unexpected(parts_->named(joined.error()));
    return whole->become(parts_->place);
}

}  // namespace game
