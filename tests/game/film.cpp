// Films: what ffmpeg is asked for and given, and what is left when it fails. A script plays ffmpeg where that matters.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>

#include <gtest/gtest.h>

#include "game/app/filming.h"
#include "game/controls/film_camera.h"
#include "game/files/assets.h"
#include "game/files/film.h"
#include "game/scene/camera_keys.h"
#include "game/scene/mountains.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "render/mountain/overview.h"
#include "tests/game/full_disk.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

constexpr Film::Format kSmall{160, 90, 30};
constexpr std::size_t kBytes = 160 * 90 * 3;  // of an image

render::Picture picture(int i = 0) {
    return {kSmall.width, kSmall.height, std::vector<std::uint8_t>(kBytes, static_cast<std::uint8_t>(20 * i)),
            3};
}

// Programs are looked for there first while it lives, or there alone.
class SearchPath {
  public:
    explicit SearchPath(const fs::path& folder, bool alone = false) : before_(std::getenv("PATH")) {
        setenv("PATH", alone ? folder.c_str() : (folder.string() + ":" + before_).c_str(), 1);
    }
    ~SearchPath() { setenv("PATH", before_.c_str(), 1); }
    SearchPath(const SearchPath&) = delete;
    SearchPath& operator=(const SearchPath&) = delete;

  private:
    std::string before_;
};

// A folder with an ffmpeg that knows these encoders, writes its arguments and what it is given to files there, and ends
// with `then`, a line of shell in which "$into" is the file that it should write.
class FakeFfmpeg {
  public:
    explicit FakeFfmpeg(const std::string& then,
                        const std::string& encoders = "libx264 aac libvpx-vp9 libopus libsvtav1 libaom-av1") {
        fs::create_directory(programs());
        std::string script = "#!/bin/sh\nhere='" + folder_.path().string() + "'\n";
        script += "case \"$*\" in *-encoders*) for each in " + encoders +
                  "; do echo \" V..... $each it\"; done; exit 0;; esac\n";
        script += "printf '%s\\n' \"$@\" >> \"$here/arguments\"\n";
        script += "for into in \"$@\"; do :; done\ninto=${into#file:}\n";
        script += then + "\n";
        write_bytes(programs() / "ffmpeg", script);
        chmod((programs() / "ffmpeg").c_str(), 0755);
        fs::create_directory(films());
    }
    fs::path programs() const { return folder_.path() / "programs"; }
    fs::path films() const { return folder_.path() / "films"; }
    std::string arguments() const { return read_bytes(folder_.path() / "arguments"); }
    // Whether these words follow each other.
    bool was_given(std::string words) const {
        std::replace(words.begin(), words.end(), ' ', '\n');
        return ("\n" + arguments()).find("\n" + words + "\n") != std::string::npos;
    }

  private:
    support::TemporaryFolder folder_;
};

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Makes a film of so many images. It ends early at an error.
Outcome<void> film(const fs::path& path, int images, const std::optional<fs::path>& wav = std::nullopt) {
    auto film = Film::open(path, kSmall);
    if (!film) return tl::unexpected(film.error());
    for (int i = 0; i < images; ++i)
        if (auto added = film->add(picture(i)); !added) return added;
    EXPECT_EQ(film->frames(), images);
    return film->close(wav);
}

constexpr const char* kKeeps = "cat > \"$into\"";

TEST(Film, gives_ffmpeg_every_byte_of_every_image_in_order_and_its_size_and_rate) {
    const FakeFfmpeg fake(kKeeps);
    const SearchPath path(fake.programs());
    const fs::path file = fake.films() / "a 'b\"$(c).mp4";
    ASSERT_TRUE(film(file, 10));
    const std::string bytes = read_bytes(file);
    ASSERT_EQ(bytes.size(), 10 * kBytes);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(bytes[i * kBytes], static_cast<char>(20 * i));
        EXPECT_EQ(bytes[(i + 1) * kBytes - 1], static_cast<char>(20 * i));
    }
    EXPECT_TRUE(fake.was_given("-f rawvideo -pixel_format rgb24 -video_size 160x90 -framerate 30 -i pipe:0"))
        << fake.arguments();
    EXPECT_EQ(files_in(fake.films()), 1u);
}

TEST(Film, is_encoded_as_its_ending_says) {
    struct Case {
        const char *ending, *encoder, *format, *sound;
    };
    for (const Case& each : {Case{".mp4", "libx264", "mp4", "aac"},
                             {".webm", "libvpx-vp9", "webm", "libopus"},
                             {".mkv", "libsvtav1", "matroska", "libopus"}}) {
        SCOPED_TRACE(each.ending);
        const FakeFfmpeg fake(kKeeps);
        const SearchPath path(fake.programs());
        const fs::path wav = fake.programs() / "a.wav";
        write_bytes(wav, "sound");
        ASSERT_TRUE(film(fake.films() / (std::string("a") + each.ending), 1, wav));
        EXPECT_TRUE(fake.was_given(std::string("-c:v ") + each.encoder)) << fake.arguments();
        EXPECT_TRUE(fake.was_given(std::string("-f ") + each.format)) << fake.arguments();
        EXPECT_TRUE(fake.was_given(std::string("-c:v copy -c:a ") + each.sound)) << fake.arguments();
        EXPECT_TRUE(fake.was_given("-f wav -i file:" + wav.string())) << fake.arguments();
        EXPECT_EQ(fake.was_given("-movflags +faststart"), std::string(each.ending) == ".mp4");
        EXPECT_EQ(files_in(fake.films()), 1u);
    }
    const FakeFfmpeg fake(kKeeps, "libaom-av1 libopus");
    const SearchPath path(fake.programs());
    ASSERT_TRUE(film(fake.films() / "a.mkv", 1));
    EXPECT_TRUE(fake.was_given("-c:v libaom-av1")) << "the other encoder of AV1 is missing";
    const auto lacking = film(fake.films() / "a.mp4", 1);
    ASSERT_FALSE(lacking);
    EXPECT_EQ(lacking.error().status, Failure::kMachine);
    EXPECT_NE(lacking.error().sentence.find("libx264"), std::string::npos) << lacking.error().sentence;
}

TEST(Film, is_refused_with_another_ending_an_odd_side_or_without_images) {
    const FakeFfmpeg fake(kKeeps);
    const SearchPath path(fake.programs());
    for (const char* name : {"a.avi", "a", "a.MP4", ".mp4", "mp4"}) {
        const auto open = Film::open(fake.films() / name, kSmall);
        ASSERT_FALSE(open) << name;
        EXPECT_EQ(open.error().status, Failure::kUnusable);
    }
    for (const Film::Format odd : {Film::Format{161, 90, 30}, Film::Format{160, 91, 30}})
        EXPECT_EQ(Film::check("a.mp4", odd).error().status, Failure::kUnusable);
    EXPECT_EQ(film(fake.films() / "a.mp4", 0).error().status, Failure::kUnusable);
    EXPECT_EQ(files_in(fake.films()), 0u);
}

TEST(Film, of_which_ffmpeg_dies_is_the_machines_failure_with_its_reason_and_leaves_nothing) {
    const fs::path wav = "/dev/null";
    const std::string first_only = "case \"$*\" in *copy*) echo no room >&2; exit 1;; esac; cat > \"$into\"";
    struct Case {
        std::string then, reason;
    };
    for (const Case& each :
         {Case{"echo started > \"$into\"; echo one >&2; echo No space left >&2; exit 1", "No space left"},
          {"cat > \"$into\"; echo Late >&2; echo 'Conversion failed!' >&2; exit 187", "Late"},
          {"exit 7", "status 7"},
          {"kill -9 $$", "signal 9"},
          {"head -c 100 > \"$into\"; exit 0", "before the film"},
          {first_only, "no room"}}) {
        SCOPED_TRACE(each.then);
        const FakeFfmpeg fake(each.then);
        const SearchPath path(fake.programs());
        const fs::path file = fake.films() / "a.mp4";
        write_bytes(file, "the film before");
        const auto made = film(file, 40, each.then == first_only ? std::optional(wav) : std::nullopt);
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().status, Failure::kMachine);
        EXPECT_EQ(made.error().sentence.rfind(file.string() + ": ", 0), 0u);
        EXPECT_NE(made.error().sentence.find(each.reason), std::string::npos) << made.error().sentence;
        EXPECT_EQ(read_bytes(file), "the film before");
        EXPECT_EQ(files_in(fake.films()), 1u);
    }
}

TEST(Film, that_is_dropped_ends_ffmpeg_at_once_and_leaves_nothing) {
    const FakeFfmpeg fake("exec sleep 60");  // which reads nothing
    const SearchPath path(fake.programs());
    const auto began = std::chrono::steady_clock::now();
    {
        auto film = Film::open(fake.films() / "a.mp4", {640, 480, 30});
        ASSERT_TRUE(film);
        ASSERT_TRUE(film->add({640, 480, std::vector<std::uint8_t>(640 * 480 * 3), 3}));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
    EXPECT_EQ(files_in(fake.films()), 0u);
}

TEST(Film, without_ffmpeg_or_a_place_for_it_names_what_is_missing) {
    const support::TemporaryFolder folder;
    {
        const SearchPath path(folder.path(), true);
        const auto open = Film::open(folder.path() / "a.mp4", kSmall);
        ASSERT_FALSE(open);
        EXPECT_EQ(open.error().status, Failure::kMachine);
        EXPECT_NE(open.error().sentence.find("apt install ffmpeg"), std::string::npos)
            << open.error().sentence;
        EXPECT_EQ(files_in(folder.path()), 0u);
    }
    const FakeFfmpeg fake(kKeeps);
    const SearchPath path(fake.programs());
    write_bytes(folder.path() / "file", "");
    fs::create_directory(folder.path() / "folder.mp4");
    for (const fs::path& nowhere : {folder.path() / "file" / "a.mp4", folder.path() / "folder.mp4"}) {
        const auto open = Film::open(nowhere, kSmall);
        ASSERT_FALSE(open);
        EXPECT_EQ(open.error().status, Failure::kMachine);
        EXPECT_NE(open.error().sentence.find((folder.path() / "f").string()), std::string::npos)
            << open.error().sentence;
    }
}

bool has_real_ffmpeg() {
    return std::system("ffmpeg -version > /dev/null 2>&1 && ffprobe -version > /dev/null 2>&1") == 0;
}

std::string probed(const fs::path& file) {
    const support::TemporaryFolder folder;
    const fs::path out = folder.path() / "out";
    EXPECT_EQ(
        std::system(("ffprobe -v error -count_frames -show_entries "
                     "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames -of compact '" +
                     file.string() + "' > '" + out.string() + "'")
                        .c_str()),
        0);
    return read_bytes(out);
}

TEST(Film, of_the_real_ffmpeg_has_all_images_and_a_full_disk_leaves_nothing) {
    if (!has_real_ffmpeg()) GTEST_SKIP() << "ffmpeg and ffprobe are not installed";
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "a.mp4";
    const auto made = film(file, 10);
    ASSERT_TRUE(made) << made.error().sentence;
    const std::string streams = probed(file);
    for (const char* fact : {"codec_name=h264", "width=160", "height=90", "pix_fmt=yuv420p",
                             "r_frame_rate=30/1", "nb_read_frames=10"})
        EXPECT_NE(streams.find(fact), std::string::npos) << fact << " is not in " << streams;
    const fs::path second = folder.path() / "b.mp4";
    const FullDisk full(1000);
    const auto cut = film(second, 10);
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().status, Failure::kMachine);
    EXPECT_NE(cut.error().sentence.find("too large"), std::string::npos) << cut.error().sentence;
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(FilmCamera, stands_or_follows_the_front) {
    Overrides overrides;
    overrides.squares = 40;
    const Scene scene = load_scene("winter-avalanche", overrides).value();
    auto session = Session::begin(scene.scenario, {}, std::nullopt).value();
    const render::Surroundings none;
    const render::Camera home = render::overview(session.view());
    FilmCamera stands(FilmView::kScene, home, session.view(), none);
    FilmCamera follows(FilmView::kChase, home, session.view(), none);
    EXPECT_EQ(stands.camera().target, home.target);
    for (int tick = 0; tick < 300; ++tick) {
        std::vector<sim::Command> due;
        for (const TimedCommand& each : commands_at(scene.commands, tick)) due.push_back(each.command);
        ASSERT_TRUE(session.advance(due));
        for (FilmCamera* each : {&stands, &follows})
            each->move(session.view(), none, 16. / 9, {1. / 60, session.seconds()});
    }
    EXPECT_EQ(stands.camera().target, home.target);
    EXPECT_LT(follows.camera().distance_m, home.distance_m);
    EXPECT_NE(follows.camera().target, home.target);
}

// One run of the whole program, with a script for ffmpeg: ten images of twenty ticks, and their sound.
TEST(FilmOfReplay, has_the_images_of_its_time_and_refuses_what_it_cannot_film) {
    const FakeFfmpeg fake("case \"$*\" in *copy*) cp \"${into%.*.part}.2.part\" \"$here/wav\";; esac; " +
                          std::string(kKeeps) + "; wc -c < \"$into\" >> \"$here/counts\"");
    const SearchPath path(fake.programs());
    const std::string file = (fake.films() / "a.mp4").string();
    const auto replay = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"replay", "landslide", "--until", "20", "--size", "32x18"});
        return couloir(more);
    };
    const Finished done = replay({"--video", file, "--fps", "30", "--camera", "chase"});
    ASSERT_EQ(done.status, 0) << done.err;
    std::istringstream counts(read_bytes(fake.programs().parent_path() / "counts"));
    std::size_t bytes = 0;
    counts >> bytes;
    EXPECT_EQ(bytes, 10u * 32 * 18 * 3);
    EXPECT_EQ(files_in(fake.films()), 1u);
    const std::string keys = (fake.programs() / "keys.toml").string();
    write_bytes(keys, camera_path_text(std::vector<CameraKey>{{0, {}}, {0.3, {.azimuth_deg = 20}}}));
    const Finished along = replay({"--video", file, "--camera-path", keys, "--silent"});
    EXPECT_EQ(along.status, 0) << along.err;
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--video", file + ".avi"},
                                                  {"--video", file, "--fps", "0"},
                                                  {"--video", file, "--size", "33x18"},
                                                  {"--fps", "30"},
                                                  {"--camera", "chase"},
                                                  {"--camera-path", keys},
                                                  {"--video", file, "--camera", "path"},
                                                  {"--video", file, "--camera-path", file},
                                                  {"--video", file, "--camera", "top", "--camera-path", keys},
                                                  {"--video", keys + ".mp4", "--camera-path", keys + ".mp4"},
                                                  {"--silent"},
                                                  {"--video", file, "--until", "0"},
                                                  {"--video", file, "--audio", file}}) {
        const Finished refused = replay(wrong);
        EXPECT_EQ(refused.status, 2) << wrong.back() << ": " << refused.err;
    }
}

// The same of a scene that is run, until a time or until it comes to rest, whenever that is.
TEST(FilmOfRun, has_the_images_of_its_time_however_it_ends) {
    const FakeFfmpeg fake("case \"$*\" in *copy*) echo joined >> \"$here/counts\";; esac; " +
                          std::string(kKeeps) + "; wc -c < \"$into\" >> \"$here/counts\"");
    const SearchPath path(fake.programs());
    const fs::path counts = fake.programs().parent_path() / "counts";
    const std::string file = (fake.films() / "a.mp4").string();
    const auto run = [&](std::vector<std::string> more) {
        fs::remove(counts);
        more.insert(more.begin(), {"run", "landslide", "--grid", "24", "--size", "32x18", "--fps", "30"});
        return couloir(more);
    };
    const auto images = [&] {
        std::istringstream text(read_bytes(counts));
        std::size_t bytes = 0;
        text >> bytes;
        return bytes / (32 * 18 * 3);
    };
    const Finished timed = run({"--seconds", "0.2", "--video", file, "--camera", "top", "--silent"});
    ASSERT_EQ(timed.status, 0) << timed.err;
    EXPECT_EQ(images(), 6u);
    const Finished resting = run({"--until-rest", "--seconds", "0.2", "--video", file});
    EXPECT_EQ(resting.status, 1) << resting.err;
    EXPECT_EQ(images(), 6u);
    EXPECT_EQ(files_in(fake.films()), 1u);
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--seconds", "1", "--silent"},
                                                  {"--seconds", "1", "--camera", "chase"},
                                                  {"--seconds", "1", "--video", file, "--camera", "path"},
                                                  {"--seconds", "1", "--video", file, "--size", "33x18"}}) {
        const Finished refused = run(wrong);
        EXPECT_EQ(refused.status, 2) << wrong.back() << ": " << refused.err;
    }
}

TEST(FilmOfRun, that_is_interrupted_leaves_nothing) {
    const FakeFfmpeg fake(kKeeps);
    const SearchPath path(fake.programs());
    const pid_t child = start_couloir({"run", "landslide", "--grid", "24", "--size", "32x18", "--seconds",
                                       "3600", "--silent", "--video", (fake.films() / "a.mp4").string()});
    const auto is_filming = [&] {
        for (const auto& entry : fs::directory_iterator(fake.films()))
            if (fs::file_size(entry) > 0) return true;
        return false;
    };
    for (int wait = 0; wait < 60'000 && !is_filming(); ++wait)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_TRUE(is_filming());
    kill(child, SIGTERM);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == Failure::kMachine);
    EXPECT_EQ(files_in(fake.films()), 0u);
}

// The film of the window, which goes on meanwhile.
class FilmOfWindow : public testing::Test {
  protected:
    FilmOfWindow() : path_(fake_.programs()) { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }
    ~FilmOfWindow() override { unsetenv("XDG_DATA_HOME"); }

    static Filming::Subject subject(std::int64_t last) {
        const fs::path recording = find_asset(AssetKind::kRecording, "landslide").value();
        return {read_bytes(recording), "mine", last, {}, {}};
    }
    static Outcome<Filming::Made> wait_for(Filming& filming) {
        while (true)
            if (auto result = filming.result()) return std::move(*result);
    }
    fs::path films() const { return folder_.path() / "couloir/films"; }

    static constexpr FilmWish kWish{.width = 32, .height = 18, .silent = true};
    support::TemporaryFolder folder_;
    FakeFfmpeg fake_{"sleep 0.1; cat > \"$into\""};
    SearchPath path_;
};

TEST_F(FilmOfWindow, gets_a_new_name_and_has_the_images_of_its_time) {
    fs::create_directories(films());
    write_bytes(films() / "mine.mp4", "the film before");
    Filming filming;
    ASSERT_TRUE(filming.begin(subject(20), kWish));
    EXPECT_TRUE(filming.progress());
    const auto made = wait_for(filming);
    ASSERT_TRUE(made) << made.error().sentence;
    EXPECT_EQ(made->file, films() / "mine-2.mp4");
    EXPECT_EQ(fs::file_size(made->file), 10u * 32 * 18 * 3) << "20 ticks at 30 images per second";
    EXPECT_NEAR(made->seconds, 20. / 60, 1e-6);
    EXPECT_FALSE(filming.progress());
    EXPECT_EQ(files_in(films()), 2u);
}

TEST_F(FilmOfWindow, leaves_nothing_if_it_is_stopped_or_cannot_be_made) {
    Filming filming;
    ASSERT_TRUE(filming.begin(subject(100'000), kWish));
    while (*filming.progress() == 0) std::this_thread::yield();
    filming.stop();
    EXPECT_FALSE(filming.progress());
    EXPECT_FALSE(filming.result());
    EXPECT_EQ(files_in(films()), 0u);

    Filming::Subject damaged = subject(20);
    damaged.recording.resize(100);
    ASSERT_TRUE(filming.begin(std::move(damaged), kWish));
    EXPECT_FALSE(wait_for(filming));
    EXPECT_EQ(files_in(films()), 0u);
}

}  // namespace
}  // namespace game::test
