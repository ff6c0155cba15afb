#include "game/app/settings.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "game/files/text_file.h"
#include "tests/game/program.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

class KeptSettings : public testing::Test {
  protected:
    KeptSettings() { setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1); }
    ~KeptSettings() override { unsetenv("XDG_CONFIG_HOME"); }
    fs::path file() const { return folder_.path() / "couloir/settings.toml"; }
    // Writes these, and reads them as the next start does.
    static Settings kept(const Settings& settings) {
        EXPECT_TRUE(SettingsFile::of_user().finish(settings));
        const SettingsFile read = SettingsFile::of_user();
        EXPECT_EQ(read.told(), "");
        return read.begun();
    }

    support::TemporaryFolder folder_;
};

// All of them other than usual.
Settings changed() {
    Settings settings;
    Display& display = settings.display;
    display.contours = display.labels = true;
    display.language = "de";
    display.field_words = true;
    display.contrast = true;
    display.trees = display.ghost = display.ends = false;
    display.slow_release = display.fast_creep = display.shows_shared = false;
    display.detail = 0.25f;
    display.powder = 0.1f;
    display.letters = 1.35;
    display.frame_ms = 50;
    display.most_scale = 0.375;
    display.volumes = {.all = 0.3, .of = {0.1, 0.2, 0, 0.7}, .muted = true};
    settings.tier = Tier::kBalanced;
    settings.width = 1600, settings.height = 900;
    settings.fullscreen = true;
    const auto bind = [&](std::string_view name, Chord chord) {
        for (std::size_t row = 0; row < settings.keys.size(); ++row)
            if (settings.keys.name(row) == name) settings.keys.bind(row, chord);
    };
    bind("pause", {key('P'), {}});
    bind("undo", {key('\\'), {true, true, false}});
    bind("forward", {Key::kSpace, {}});
    bind("rewind", {});
    return settings;
}

TEST_F(KeptSettings, are_those_of_the_last_time) {
    EXPECT_EQ(SettingsFile::of_user().begun(), Settings());
    EXPECT_EQ(kept(changed()), changed());
    EXPECT_EQ(kept(Settings()), Settings()) << "and back";
    // What belongs to a scene is none of them.
    Settings scene = changed();
    scene.display.light.elevation_deg = 3;
    scene.display.overlay = render::Overlay::kSpeed;
    scene.display.surroundings = false;
    EXPECT_EQ(kept(scene), changed());
}

TEST_F(KeptSettings, are_written_a_second_after_the_last_change_and_only_if_there_is_one) {
    SettingsFile settings = SettingsFile::of_user();
    ASSERT_TRUE(settings.see(Settings(), 5));
    EXPECT_FALSE(fs::exists(file())) << "the usual ones need no file";
    Settings now;
    for (int i = 0; i < 30; ++i) {  // a slider is dragged
        now.display.letters = 1 + 0.01 * i;
        ASSERT_TRUE(settings.see(now, 6 + 0.1 * i));
    }
    EXPECT_FALSE(fs::exists(file()));
    ASSERT_TRUE(settings.see(now, 11));
    EXPECT_EQ(SettingsFile::of_user().begun(), now);
    const std::string text = read_text(file()).value();
    EXPECT_NE(text.find("text_size = 1.29\n"), std::string::npos) << text;
    fs::remove(file());
    ASSERT_TRUE(settings.see(now, 20));
    ASSERT_TRUE(settings.finish(now));
    EXPECT_FALSE(fs::exists(file())) << "nothing has changed";
}

TEST_F(KeptSettings, that_are_damaged_are_set_aside_with_a_sentence) {
    const std::string whole = [&] {
        EXPECT_EQ(kept(changed()), changed());
        return read_text(file()).value();
    }();
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = whole;
        text.replace(text.find(what), what.size(), instead);
        return text;
    };
    for (const std::string& text : {with("version = 1", ""),
                                    with("version = 1", "version = \"one\""),
                                    with("version = 1", "version = 0"),
                                    with("volume = 0.3", "volume = 30"),
                                    with("volume = 0.3", "volume = nan"),
                                    with("contours = true", "contours = 1"),
                                    with("contours", "kontours"),
                                    with("[sound]", "[song]"),
                                    with("\"balanced\"", "\"best\""),
                                    with("width = 1600", "width = 1600.5"),
                                    with("width = 1600", "width = -1"),
                                    with("[window]", "[window"),
                                    with("pause = \"P\"", "pause = \"Hyper+P\""),
                                    with("pause = \"P\"", "pause = \"Space\""),
                                    with("\"Space\"", "\"Shift+Space\""),
                                    with("pause = \"P\"", "close = \"P\""),
                                    with("pause = \"P\"", "pauze = \"P\""),
                                    whole.substr(0, whole.size() / 2),
                                    std::string("\0\xff", 2),
                                    whole + whole,
                                    std::string(2000000, '#')}) {
        SCOPED_TRACE(text.substr(0, 40));
        ASSERT_TRUE(write_text(file(), text));
        SettingsFile read = SettingsFile::of_user();
        EXPECT_EQ(read.begun(), Settings());
        const std::string aside = file().string() + ".damaged";
        EXPECT_EQ(read.told().find(file().string()), 0u) << read.told();
        EXPECT_NE(read.told().find("The usual settings are used; the file is kept as " + aside),
                  std::string::npos)
            << read.told();
        EXPECT_EQ(read.told().find('\n'), std::string::npos);
        EXPECT_FALSE(fs::exists(file()));
        EXPECT_EQ(read_text(aside).value(), text);
        EXPECT_TRUE(read.finish(changed()));
        EXPECT_TRUE(fs::exists(file())) << "new ones are kept";
    }
}

TEST_F(KeptSettings, of_a_newer_program_or_that_cannot_be_read_stay_as_they_are) {
    const std::string newer = "version = 2\n[colours]\npalette = \"safe\"\n";
    ASSERT_TRUE(write_text(file(), newer));
    SettingsFile read = SettingsFile::of_user();
    EXPECT_EQ(
        read.told(),
        file().string() +
            ": written by a newer Couloir, version 2; this one reads 1. The usual settings are used, and "
            "changes are not kept");
    EXPECT_TRUE(read.finish(changed()));
    EXPECT_EQ(read_text(file()).value(), newer);

    fs::remove(file());
    fs::create_directory(file());
    SettingsFile folder = SettingsFile::of_user();
    EXPECT_NE(folder.told().find("changes are not kept"), std::string::npos) << folder.told();
    EXPECT_TRUE(folder.finish(changed()));
    EXPECT_TRUE(fs::is_directory(file()));
}

TEST_F(KeptSettings, that_cannot_be_written_are_told_once) {
    ASSERT_TRUE(write_text(folder_.path() / "couloir", "a file where a folder should be"));
    SettingsFile settings = SettingsFile::of_user();
    EXPECT_EQ(settings.told(), "");
    ASSERT_TRUE(settings.see(changed(), 1));
    const auto told = settings.see(changed(), 3);
    ASSERT_FALSE(told);
    EXPECT_NE(told.error().sentence.find("Changed settings are not kept"), std::string::npos)
        << told.error().sentence;
    EXPECT_TRUE(settings.see(Settings(), 5));
    EXPECT_TRUE(settings.finish(Settings()));
}

// A program that writes all the time is killed at a hundred moments: what is read is always whole.
TEST_F(KeptSettings, survive_kill_9_at_a_hundred_moments) {
    ASSERT_TRUE(SettingsFile::of_user().finish(changed()));
    std::mt19937 random(5);
    for (int i = 0; i < 100; ++i) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            SettingsFile settings = SettingsFile::of_user();
            for (int k = 0;; ++k) {
                Settings now = changed();
                now.width = Settings::kLeastSide + k % 4000;
                if (!settings.finish(now)) _exit(1);
            }
        }
        usleep(500 + random() % 6000);
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it could not write";
        const SettingsFile read = SettingsFile::of_user();
        ASSERT_EQ(read.told(), "") << i;
        Settings other = read.begun();
        other.width = changed().width;
        ASSERT_EQ(other, changed());
    }
}

}  // namespace
}  // namespace game::test
