// What is heard: each wave, how loud it is at the ear, and what OpenAL makes of it in memory.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "game/recording/command_source.h"
#include "game/scene/scene.h"
#include "game/session/session.h"
#include "game/sound/hearing.h"
#include "game/sound/mixer.h"
#include "game/sound/speaker.h"
#include "game/sound/waves.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

using sound::Wave;

double root_mean_square(std::span<const float> samples) {
    double sum = 0;
    for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(samples.size(), 1)));
}

float greatest(std::span<const float> samples) {
    float most = 0;
    for (const float sample : samples) most = std::max(most, std::abs(sample));
    return most;
}

float greatest_step(std::span<const float> samples) {
    float most = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        most = std::max(most, std::abs(samples[i] - samples[i - 1]));
    return most;
}

// Fourier transform in place; the size is a power of two.
void transform(std::vector<std::complex<double>>& values) {
    const std::size_t size = values.size();
    if (size == 1) return;
    std::vector<std::complex<double>> even, odd;
    for (std::size_t i = 0; i < size; i += 2) even.push_back(values[i]), odd.push_back(values[i + 1]);
    transform(even);
    transform(odd);
    for (std::size_t i = 0; i < size / 2; ++i) {
        const auto turned =
            std::polar(1., -2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size)) *
            odd[i];
        values[i] = even[i] + turned, values[i + size / 2] = even[i] - turned;
    }
}

// Share of the power between two frequencies, Hz, of the first one and a half seconds.
double share_between(std::span<const float> samples, double least_hz, double most_hz) {
    constexpr std::size_t kLooked = 1 << 16;
    samples = samples.first(std::min(samples.size(), kLooked));
    std::size_t size = 1;
    while (size < samples.size()) size *= 2;
    std::vector<std::complex<double>> values(size);
    std::ranges::copy(samples, values.begin());
    transform(values);
    double inside = 0, all = 0;
    for (std::size_t i = 0; i < size / 2; ++i) {
        const double hz = static_cast<double>(i) * sound::kRate / static_cast<double>(size),
                     power = std::norm(values[i]);
        all += power;
        if (hz >= least_hz && hz <= most_hz) inside += power;
    }
    return inside / all;
}

TEST(Waves, have_the_band_and_level_of_the_table_and_no_click) {
    for (const sound::WaveInfo& info : sound::wave_infos()) {
        SCOPED_TRACE(std::string(info.name));
        const auto samples = sound::samples_of(info.wave);
        EXPECT_EQ(samples.size(), static_cast<std::size_t>(info.seconds * sound::kRate));
        EXPECT_GT(share_between(samples, info.least_hz, info.most_hz), 0.9);
        EXPECT_LE(greatest(samples), sound::kPeak + 1e-6f);
        if (info.loops) {
            EXPECT_NEAR(root_mean_square(samples), sound::kLoopLevel, 0.35 * sound::kLoopLevel);
            EXPECT_LE(std::abs(samples.front() - samples.back()), greatest_step(samples));
        } else {
            EXPECT_GT(greatest(samples), 0.8f * sound::kPeak);
            EXPECT_LT(std::abs(samples.front()), 0.02f);
            EXPECT_LT(greatest(std::span(samples).last(40)), 0.02f);
        }
        EXPECT_EQ(samples, sound::samples_of(info.wave)) << "another time another sound";
    }
}

TEST(Loudness, falls_by_6_dB_per_doubling_of_distance_and_by_what_air_takes) {
    EXPECT_NEAR(sound::level_at(1, 100, 0), 120 - 10 * std::log10(4 * std::numbers::pi * 1e4), 1e-9);
    EXPECT_NEAR(sound::level_at(1, 200, 0) - sound::level_at(1, 100, 0), -20 * std::log10(2), 1e-9);
    EXPECT_NEAR(sound::level_at(1, 1000, 33) - sound::level_at(1, 1000, 0), -33, 1e-9);
    EXPECT_EQ(sound::gain_of(sound::level_at(0, 100, 0)), 0);
    EXPECT_EQ(sound::gain_of(sound::Mixer::kQuietest), 0);
    EXPECT_EQ(sound::gain_of(sound::Mixer::kLoudest), 1);
    EXPECT_LT(sound::gain_of(sound::Mixer::kQuietest + 0.1), 1e-3) << "nothing begins with a step";
    double before = 0;
    for (double level = 26; level < 95; ++level) {
        EXPECT_GT(sound::gain_of(level), before);
        before = sound::gain_of(level);
    }
}

Scene coarse(const std::string& scene, int squares) {
    Overrides overrides;
    overrides.squares = squares;
    return load_scene(scene, overrides).value();
}

// A scene that is played by its own commands.
class HeardWorld {
  public:
    explicit HeardWorld(const std::string& scene, int squares = 48)
        : scene_(coarse(scene, squares)),
          session_(Session::begin(scene_.scenario, {}, std::nullopt).value()),
          hearing_(session_) {
        session_.follow_powder(scene_.scenario);
    }
    void tick(std::span<const sim::Command> more = {}) {
        source_.begin(session_.state());
        source_.add_known(scene_.commands);
        source_.add_new(more);
        EXPECT_TRUE(session_.advance(source_.commands()));
        hearing_.see(session_, source_.commands());
    }
    void ticks(int n) {
        while (n-- > 0) tick();
    }
    double watts() {
        double sum = 0;
        for (const sound::Emitter& flow : hearing_.look(session_).flow) sum += flow.watts;
        return sum;
    }
    Session& session() { return session_; }
    sound::Hearing& hearing() { return hearing_; }
    const Scene& scene() const { return scene_; }

  private:
    Scene scene_;
    Session session_;
    sound::Hearing hearing_;
    CommandSource source_;
};

TEST(Hearing, hears_blasts_slabs_and_the_power_of_what_flows_where_it_is) {
    HeardWorld world("winter-avalanche");
    EXPECT_EQ(world.watts(), 0) << "nothing moves yet";
    EXPECT_TRUE(world.hearing().happened().empty());
    const auto blasts = std::ranges::count(world.scene().commands, sim::CommandKind::kBlast,
                                           [](const TimedCommand& each) { return each.command.kind; });
    ASSERT_GT(blasts, 0);
    world.ticks(240);
    const auto& happened = world.hearing().happened();
    EXPECT_EQ(std::ranges::count(happened, Wave::kBlast, &sound::Happened::wave), blasts);
    EXPECT_GT(std::ranges::count(happened, Wave::kCrack, &sound::Happened::wave), 0);
    const double slow = world.watts();
    EXPECT_GT(slow, 0);
    world.ticks(600);
    EXPECT_GT(world.watts(), 2 * slow) << "it has grown and is faster";
    // The emitters are where it flows, on the ground.
    const sim::View now = world.session().view();
    for (const sound::Emitter& flow : world.hearing().look(world.session()).flow) {
        if (flow.watts < 1) continue;
        double nearest = 1e9;
        for (int y = 0; y < now.grid.ny; ++y)
            for (int x = 0; x < now.grid.nx; ++x)
                if (now.rolling(x, y) > 0.01f)
                    nearest =
                        std::min(nearest, glm::distance(glm::dvec2(flow.at),
                                                        static_cast<double>(now.grid.dx) * glm::dvec2(x, y)));
        EXPECT_LT(nearest, 120);
        EXPECT_GT(flow.at.z, now.datum - 1);
        EXPECT_GT(flow.speed, 1);
    }
    EXPECT_GT(world.hearing().look(world.session()).powder.watts, 0);
}

TEST(Hearing, hears_the_same_in_each_replay_and_nothing_of_a_jump) {
    const auto heard = [] {
        HeardWorld world("landslide");
        std::vector<double> all;
        for (int i = 0; i < 200; ++i) world.tick(), all.push_back(world.watts());
        return all;
    };
    EXPECT_EQ(heard(), heard());
    HeardWorld world("winter-avalanche");
    const auto first = world.session().moment();
    world.ticks(200);
    world.hearing().forget();
    ASSERT_TRUE(world.session().go_to(first));
    EXPECT_EQ(world.watts(), 0) << "as the next frame looks";
    EXPECT_TRUE(world.hearing().happened().empty());
    world.ticks(200);
    EXPECT_FALSE(world.hearing().happened().empty()) << "the blasts of the first ticks are heard again";
}

TEST(Hearing, hears_what_breaks) {
    HeardWorld world("protection", 80);
    world.ticks(1500);
    const sim::View now = world.session().view();
    int broken = 0;
    std::int64_t lying = 0;
    for (const sim::Thing& thing : now.things->list) broken += thing.damaged() + thing.destroyed();
    for (const std::int32_t vertex : now.things->wooded)
        lying += now.things->forest(vertex % now.grid.nx, vertex / now.grid.nx).lying > 0;
    const auto count = [&](auto... waves) {
        return std::ranges::count_if(world.hearing().happened(), [&](const sound::Happened& each) {
            return ((each.wave == waves) || ...);
        });
    };
    EXPECT_GT(broken + lying, 0) << "the scene breaks nothing any more";
    EXPECT_EQ(count(Wave::kWood, Wave::kWall, Wave::kMetal) > 0, broken > 0);
    EXPECT_EQ(count(Wave::kTree) > 0, lying > 0);
}

struct Room {
    HeardWorld world{"winter-valley", 40};
    sound::Mixer mixer;
    sound::Ear ear;
    Room() { ear.at = {400, 400, 2500}; }
    sound::Volumes volumes;
    void mix(const sound::Heard& heard, std::span<const sound::Happened> happened = {},
             double elapsed_s = 1. / 60) {
        mixer.mix(heard, happened, world.session().view(), ear, volumes, elapsed_s);
    }
    double loudest() const {
        float most = 0;
        for (const sound::Voice& voice : mixer.loops()) most = std::max(most, voice.gain);
        return static_cast<double>(most);
    }
};

TEST(Mixer, swells_and_fades_and_is_silent_in_a_pause_and_when_muted) {
    Room room;
    sound::Heard heard;
    heard.flow[0] = {.at = {400, 900, 2500}, .watts = 100, .spread = 50, .speed = 20, .stony = 0};
    room.mix(heard);
    const double first = room.loudest();
    for (int i = 0; i < 120; ++i) room.mix(heard);
    const double full = room.loudest();
    EXPECT_LT(first, 0.3 * full) << "no step at the start";
    EXPECT_GT(full, 0.2);
    room.ear.looks = false;
    for (int i = 0; i < 240; ++i) room.mix(heard);
    EXPECT_NEAR(room.loudest(), 0.25 * full, 0.02) << "another window has the focus";
    room.ear.looks = true;
    for (bool* const silent : {&room.ear.passes, &room.volumes.muted}) {
        *silent = silent != &room.ear.passes;
        for (int i = 0; i < 600; ++i) room.mix(heard);
        EXPECT_EQ(room.loudest(), 0);
        *silent = !*silent;
        for (int i = 0; i < 120; ++i) room.mix(heard);
        EXPECT_NEAR(room.loudest(), full, 0.02);
    }
    room.volumes.of[static_cast<std::size_t>(sound::Group::kFlow)] = 0;
    for (int i = 0; i < 600; ++i) room.mix(heard);
    for (const sound::Voice& voice : room.mixer.loops())
        EXPECT_TRUE(voice.gain == 0 || sound::info_of(voice.wave).group != sound::Group::kFlow);
}

TEST(Mixer, gives_a_blast_echoes_that_come_later_and_quieter) {
    Room room;
    const sim::View view = room.world.session().view();
    const double middle = 0.5 * static_cast<double>(view.grid.dx) * view.grid.nx;
    sound::Happened blast{Wave::kBlast, {middle, middle, 0}, 300, 0};
    blast.at.z = view.datum + static_cast<double>(view.bedrock(view.grid.nx / 2, view.grid.ny / 2));
    room.ear.at = blast.at + glm::dvec3(100, 0, 50);
    float direct = 0;
    std::vector<std::pair<double, float>> echoes;
    for (int i = 0; i < 600; ++i) {
        room.mix({}, i == 0 ? std::span(&blast, 1) : std::span<const sound::Happened>());
        for (const sound::Shot& shot : room.mixer.shots()) {
            if (shot.wave == Wave::kBlast) direct = shot.gain;
            if (shot.wave == Wave::kEcho) echoes.emplace_back(i / 60., shot.gain);
        }
    }
    ASSERT_GT(direct, 0.3f);
    ASSERT_FALSE(echoes.empty()) << "a valley between mountains";
    EXPECT_LE(echoes.size(), 3u);
    for (const auto& [second, gain] : echoes) {
        EXPECT_GT(second, 0.2);
        EXPECT_LT(gain, direct);
    }
    room.ear.passes = false;
    room.mix({}, std::span(&blast, 1));
    EXPECT_TRUE(room.mixer.shots().empty());
    room.mixer.note(Wave::kRefusal);
    room.mix({});
    EXPECT_EQ(room.mixer.shots().size(), 1u) << "a note is heard in a pause too";
}

class LoopbackSpeaker : public testing::Test {
  protected:
    void SetUp() override {
        auto opened = sound::open_speaker(sound::Speaker::Output::kMemory, [] {
            static const auto samples = sound::samples_of_waves();
            return samples;
        });
        ASSERT_TRUE(opened) << opened.error();
        speaker_ = std::move(*opened);
    }
    // Left and right of so many seconds.
    std::array<std::vector<float>, 2> render(double seconds) {
        std::vector<float> both(2 * static_cast<std::size_t>(seconds * sound::kRate));
        speaker_->render(both);
        std::array<std::vector<float>, 2> sides;
        for (std::size_t i = 0; i < both.size(); ++i) sides[i % 2].push_back(both[i]);
        return sides;
    }
    void play(std::span<const sound::Voice> loops, std::span<const sound::Shot> shots = {}) {
        speaker_->play(loops, shots, {0, 1, 0}, {0, 0, 1});
    }
    std::unique_ptr<sound::Speaker> speaker_;
};

TEST_F(LoopbackSpeaker, plays_each_wave_as_loud_as_it_is_and_from_where_it_is) {
    for (const sound::WaveInfo& info : sound::wave_infos()) {
        SCOPED_TRACE(std::string(info.name));
        SetUp();
        const sound::Voice east{info.wave, {100, 0, 0}, 0.5f, 1, 20};
        if (info.loops)
            play({&east, 1});
        else
            play({}, {&east, 1});
        const auto [left, right] = render(1);
        const double level = root_mean_square(right);
        EXPECT_GT(level, 2 * root_mean_square(left)) << "it is in the east, and one looks north";
        EXPECT_GT(level, 0.005);
        EXPECT_LE(greatest(right), 0.75f);
        EXPECT_GT(share_between(right, 0.7 * info.least_hz, 1.3 * info.most_hz), 0.85);
    }
}

TEST_F(LoopbackSpeaker, neither_clicks_nor_clips) {
    sound::Voice rumble{Wave::kRumble, {0, 100, 0}, 0, 1, 50};
    std::vector<float> all;
    for (int i = 0; i < 240; ++i) {
        rumble.gain = i < 60    ? 0.f
                      : i < 120 ? static_cast<float>(i - 60) / 60
                      : i < 180 ? 1.f
                                : std::max(0.f, 1 - static_cast<float>(i - 180) / 30);
        play({&rumble, 1});
        const auto left = render(1. / 60)[0];
        all.insert(all.end(), left.begin(), left.end());
    }
    const auto own = sound::samples_of(Wave::kRumble);
    EXPECT_LE(greatest_step(all), 2 * greatest_step(own)) << "a click";
    EXPECT_EQ(greatest(std::span(all).first(sound::kRate / 2)), 0);
    EXPECT_LT(greatest(std::span(all).last(sound::kRate / 8)), 1e-3f);

    // Everything at once, as loud as can be.
    std::vector<sound::Voice> loops;
    for (std::size_t i = 0; i < sound::Mixer::kLoops; ++i)
        loops.push_back({static_cast<Wave>(i % 6), {0, 10, 0}, 1, 1, 5});
    std::vector<sound::Shot> shots(40, {Wave::kBlast, {0, 10, 0}, 1, 1, 5});
    play(loops, shots);
    for (const auto& side : render(2)) {
        EXPECT_LE(greatest(side), 1.0001f) << "the limiter of OpenAL";
        EXPECT_GT(root_mean_square(side), 0.1);
    }
}

// The number of a size in a WAV file.
std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (int i = 3; i >= 0; --i)
        number = number << 8 | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
    return number;
}

TEST(Audio, is_as_long_as_the_replay_and_the_same_each_time) {
    const support::TemporaryFolder folder;
    const auto first = folder.path() / "a.wav", second = folder.path() / "b.wav";
    for (const auto& path : {first, second}) {
        const Finished done =
            couloir({"replay", "landslide", "--until", "90", "--audio", path.string(), "--verify"});
        EXPECT_EQ(done.status, 0) << done.err;
    }
    const std::string bytes = read_bytes(first);
    EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(8, 8), "RIFFWAVEfmt ");
    EXPECT_EQ(number_at(bytes, 4), bytes.size() - 8);
    EXPECT_EQ(number_at(bytes, 24), static_cast<std::uint32_t>(sound::kRate));
    EXPECT_EQ(number_at(bytes, 40), bytes.size() - 44);
    EXPECT_EQ(bytes.size() - 44, 4u * static_cast<std::size_t>(sound::kRate) * 90 / 60);
    EXPECT_TRUE(std::ranges::any_of(bytes.substr(44), [](char each) { return each != 0; }));
    EXPECT_EQ(bytes, read_bytes(second));
}

TEST(Audio, is_refused_in_a_sentence_where_it_cannot_be) {
    const support::TemporaryFolder folder;
    const Finished nowhere = couloir({"replay", "landslide", "--until", "6", "--audio", "/proc/none/a.wav"});
    EXPECT_EQ(nowhere.status, 3);
    EXPECT_NE(nowhere.err.find("/proc/none"), std::string::npos) << nowhere.err;
    write_bytes(folder.path() / "mine.couloir",
                read_bytes(support::source_dir() / "assets/recordings/landslide.couloir"));
    const std::string mine = (folder.path() / "mine.couloir").string();
    const Finished itself = couloir({"replay", mine, "--audio", mine});
    EXPECT_EQ(itself.status, 2) << itself.err;
}

}  // namespace
}  // namespace game::test
