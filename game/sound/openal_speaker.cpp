// The module of Speaker (speaker_door.cpp loads it).
#include <dlfcn.h>

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "game/sound/speaker.h"

namespace game::sound {
namespace {

using Device = std::unique_ptr<ALCdevice, decltype(&alcCloseDevice)>;
struct EndContext {
    void operator()(ALCcontext* context) const {
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context);
    }
};

ALfloat as_al(double value) {
    return static_cast<ALfloat>(value);
}

class OpenAlSpeaker final : public Speaker {
  public:
    OpenAlSpeaker(Device device, std::unique_ptr<ALCcontext, EndContext> context,
                  LPALCRENDERSAMPLESSOFT render)
        : device_(std::move(device)), context_(std::move(context)), render_(render) {}
    ~OpenAlSpeaker() override {
        take_calls();
        alDeleteSources(static_cast<ALsizei>(loops_.size()), loops_.data());
        alDeleteSources(static_cast<ALsizei>(shots_.size()), shots_.data());
        alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    }

    // False if it has no room for them.
    bool prepare(const SamplesOfWaves& samples) {
        alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
        alGenSources(static_cast<ALsizei>(loops_.size()), loops_.data());
        alGenSources(static_cast<ALsizei>(shots_.size()), shots_.data());
        alDistanceModel(AL_NONE);  // the mixer has seen to it
        std::vector<std::int16_t> sixteen;
        for (std::size_t i = 0; i < buffers_.size(); ++i) {
            sixteen.clear();
            for (const float sample : samples.at(i))
                sixteen.push_back(static_cast<std::int16_t>(32767 * sample));
            alBufferData(buffers_[i], AL_FORMAT_MONO16, sixteen.data(),
                         static_cast<ALsizei>(sixteen.size() * sizeof(std::int16_t)), kRate);
        }
        return alGetError() == AL_NO_ERROR;
    }

    void play(std::span<const Voice> loops, std::span<const Shot> shots, const glm::dvec3& ahead,
              const glm::dvec3& up) override {
        take_calls();
        alcSuspendContext(context_.get());  // until all is set
        const std::array facing{as_al(ahead.x), as_al(ahead.y), as_al(ahead.z),
                                as_al(up.x),    as_al(up.y),    as_al(up.z)};
        alListenerfv(AL_ORIENTATION, facing.data());
        for (std::size_t i = 0; i < std::min(loops.size(), loops_.size()); ++i) go_on(i, loops[i]);
        for (const Shot& shot : shots) {
            const ALuint source = shots_[next_shot_];
            next_shot_ = (next_shot_ + 1) % shots_.size();
            alSourceStop(source);
            begin(source, shot, false);
        }
        alcProcessContext(context_.get());
    }

    bool lives() override {
        ALCint connected = ALC_TRUE;
        alcGetIntegerv(device_.get(), ALC_CONNECTED, 1, &connected);
        return connected == ALC_TRUE;
    }

    void render(std::span<float> left_right) override {
        render_(device_.get(), left_right.data(), static_cast<ALCsizei>(left_right.size() / 2));
    }

  private:
    // There may be another one, to which calls of OpenAL went.
    void take_calls() const { alcMakeContextCurrent(context_.get()); }
    static void set(ALuint source, const Voice& voice) {
        alSource3f(source, AL_POSITION, as_al(voice.from.x), as_al(voice.from.y), as_al(voice.from.z));
        alSourcef(source, AL_GAIN, voice.gain);
        alSourcef(source, AL_PITCH, voice.pitch);
        alSourcef(source, AL_SOURCE_RADIUS, voice.spread);
    }
    void begin(ALuint source, const Voice& voice, bool loops) {
        alSourcei(source, AL_BUFFER, static_cast<ALint>(buffers_.at(static_cast<std::size_t>(voice.wave))));
        alSourcei(source, AL_LOOPING, loops ? AL_TRUE : AL_FALSE);
        set(source, voice);
        alSourcePlay(source);
    }
    // A loop that is not heard costs nothing. It ends once it has been silent for a while.
    void go_on(std::size_t i, const Voice& voice) {
        constexpr int kSilentCalls = 30;
        const ALuint source = loops_[i];
        silent_[i] = voice.gain > 0 ? 0 : silent_[i] + 1;
        ALint state = AL_STOPPED;
        alGetSourcei(source, AL_SOURCE_STATE, &state);
        if (state == AL_PLAYING) {
            set(source, voice);
            if (silent_[i] > kSilentCalls) alSourceStop(source);
        } else if (voice.gain > 0) {
            begin(source, voice, true);
            // Those of the same wave must not go together.
            alSourcef(source, AL_SEC_OFFSET, as_al(0.37 * static_cast<double>(i)));
        }
    }

    Device device_;
    std::unique_ptr<ALCcontext, EndContext> context_;
    LPALCRENDERSAMPLESSOFT render_;  // null with a device
    std::array<ALuint, kWaves> buffers_{};
    std::array<ALuint, Mixer::kLoops> loops_{};
    std::array<int, Mixer::kLoops> silent_{};
    std::array<ALuint, Mixer::kMostShots> shots_{};
    std::size_t next_shot_ = 0;
};

// Without a sound card the library of ALSA, which OpenAL loads if it is there, prints a page of complaints.
void say_nothing(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                 const char* /*format*/, ...) {}
void quieten_alsa() {
    void* const alsa = dlopen("libasound.so.2", RTLD_NOW);
    if (!alsa) return;
    if (void* const set = dlsym(alsa, "snd_lib_error_set_handler"))
        reinterpret_cast<int (*)(decltype(&say_nothing))>(set)(&say_nothing);
}

tl::expected<std::unique_ptr<Speaker>, std::string> opened(Speaker::Output output, MakeSamples samples) {
    setenv("ALSOFT_LOGLEVEL", "0", 0);  // what is wrong is told in a sentence
    quieten_alsa();
    const bool to_memory = output == Speaker::Output::kMemory;
    const auto open_memory = reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(
        alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
    const auto render =
        reinterpret_cast<LPALCRENDERSAMPLESSOFT>(alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
    if (to_memory && (!open_memory || !render))
        return tl::unexpected(std::string("OpenAL here is not OpenAL Soft, so sound cannot be written"));
    Device device(to_memory ? open_memory(nullptr) : alcOpenDevice(nullptr), alcCloseDevice);
    if (!device) return tl::unexpected(std::string("there is no sound device"));
    std::vector<ALCint> wishes{ALC_MONO_SOURCES, Mixer::kLoops + Mixer::kMostShots, ALC_OUTPUT_LIMITER_SOFT,
                               ALC_TRUE};
    if (to_memory)
        wishes.insert(wishes.end(), {ALC_FREQUENCY, kRate, ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT,
                                     ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT, ALC_HRTF_SOFT, ALC_FALSE});
    wishes.push_back(0);
    std::unique_ptr<ALCcontext, EndContext> context(alcCreateContext(device.get(), wishes.data()));
    if (!context || !alcMakeContextCurrent(context.get()))
        return tl::unexpected(std::string("the sound device takes no sound"));
    auto speaker =
        std::make_unique<OpenAlSpeaker>(std::move(device), std::move(context), to_memory ? render : nullptr);
    if (!speaker->prepare(samples()))
        return tl::unexpected(std::string("the sound device has no room for sound"));
    return speaker;
}

}  // namespace
}  // namespace game::sound

extern "C" const game::sound::SpeakerDoor couloir_speaker;
const game::sound::SpeakerDoor couloir_speaker{game::sound::opened};
