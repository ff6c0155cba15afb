#include "game/sound/sound_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "game/files/text_file.h"

namespace game::sound {
namespace {

constexpr int kFrameBytes = 4;  // of two samples
constexpr std::int64_t kMostBytes = std::numeric_limits<std::uint32_t>::max() - 36;

std::int64_t samples_until(std::int64_t tick, const Session& session) {
    return std::llround(static_cast<double>(tick) * static_cast<double>(session.state().params.tick_s) *
                        kRate);
}

template <class Number>
void put(std::string& into, Number number) {
    for (std::size_t i = 0; i < sizeof(Number); ++i) into += static_cast<char>(number >> (8 * i) & 0xff);
}

// Its 44 bytes; a library would bring six codecs along.
std::string wav_header(std::uint32_t data_bytes) {
    std::string header = "RIFF";
    put(header, data_bytes + 36);
    header += "WAVEfmt ";
    put(header, std::uint32_t{16});
    put(header, std::uint16_t{1});  // whole numbers
    put(header, std::uint16_t{2});  // channels
    put(header, std::uint32_t{kRate});
    put(header, std::uint32_t{kRate * kFrameBytes});
    put(header, std::uint16_t{kFrameBytes});
    put(header, std::uint16_t{16});  // bits
    header += "data";
    put(header, data_bytes);
    return header;
}

tl::unexpected<Failure> too_long(const std::filesystem::path& path, std::int64_t bytes) {
    return unusable(fmt::format("{}: a WAV file has at most 4 GiB, and this sound has {:.1f}; end it earlier",
                                path.string(), static_cast<double>(bytes) / (std::int64_t{1} << 30)));
}

}  // namespace

SoundFile::SoundFile(files::WholeFile file, std::unique_ptr<Speaker> speaker, const Session& session,
                     const render::Camera& camera)
    : file_(std::move(file)),
      speaker_(std::move(speaker)),
      hearing_(session),
      camera_(camera),
      first_(session.state().tick) {}

Outcome<SoundFile> SoundFile::open(const std::filesystem::path& path, const Session& session,
                                   std::optional<std::int64_t> ticks, const render::Camera& camera) {
    const std::int64_t bytes = ticks ? kFrameBytes * samples_until(*ticks, session) : 0;
    if (bytes > kMostBytes) return too_long(path, bytes);
    if (auto placed = make_place_for(path); !placed) return tl::unexpected(placed.error());
    auto speaker = open_speaker(Speaker::Output::kMemory, samples_of_waves);
    if (!speaker) return machine_fails(speaker.error());
    auto file = files::WholeFile::open(path);
    if (!file) return machine_fails(file.error());
    if (auto written = file->write(wav_header(static_cast<std::uint32_t>(bytes))); !written)
        return machine_fails(written.error());
    SoundFile sound(std::move(*file), std::move(*speaker), session, camera);
    if (!ticks) sound.endless_ = path;
    return sound;
}

Outcome<void> SoundFile::see(const Session& session, std::span<const sim::Command> commands) {
    const std::int64_t until = samples_until(session.state().tick - first_, session);
    hearing_.see(session, commands);
    const Ear ear = ear_of(camera_, session.view());
    mixer_.mix(hearing_.look(session), hearing_.happened(), session.view(), ear, {},
               static_cast<double>(session.state().params.tick_s));
    hearing_.forget();
    speaker_->play(mixer_.loops(), mixer_.shots(), ear.ahead, ear.up);
    left_right_.resize(static_cast<std::size_t>(2 * (until - written_)));
    speaker_->render(left_right_);
    written_ = until;
    std::string bytes;
    for (const float sample : left_right_)
        put(bytes, static_cast<std::uint16_t>(std::lround(32767 * std::clamp(sample, -1.f, 1.f))));
    if (auto done = file_.write(bytes); !done) return machine_fails(done.error());
    return {};
}

Outcome<void> SoundFile::close() {
    if (auto done = file_.finish(); !done) return machine_fails(done.error());
    if (!endless_) return {};
    const std::int64_t bytes = kFrameBytes * written_;
    if (bytes > kMostBytes) return too_long(*endless_, bytes);
    std::fstream file(*endless_, std::ios::in | std::ios::out | std::ios::binary);
    file << wav_header(static_cast<std::uint32_t>(bytes)) << std::flush;
    if (!file) return machine_fails(fmt::format("{}: its length cannot be written", endless_->string()));
    return {};
}

}  // namespace game::sound
