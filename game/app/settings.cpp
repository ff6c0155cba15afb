#include "game/app/settings.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "files/input.h"
#include "game/files/text_file.h"
#include "game/files/toml_table.h"
#include "game/files/user_folders.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr double kStays = 1;  // s, until a change is written

// Every setting that is kept, once: read and written by its line here.
template <class Each>
void each_setting(Settings& s, Each& each) {
    Display& d = s.display;
    each.table("display");
    each.language("language", d.language);
    each.flag("field_words", d.field_words);
    each.flag("high_contrast", d.contrast);
    each.flag("contours", d.contours);
    each.flag("labels", d.labels);
    each.flag("trees", d.trees);
    each.flag("ghost", d.ghost);
    each.flag("end_points", d.ends);
    each.number("fine_relief", d.detail, 0, 1);
    each.number("powder", d.powder, 0, 1);
    each.number("text_size", d.letters, 0.5, 3);
    each.number("frame_time_ms", d.frame_ms, Display::kLeastFrameMs, Display::kMostFrameMs);
    each.number("resolution_limit", d.most_scale, 0.25, 1);
    each.tier("quality", s.tier);
    each.flag("slow_release", d.slow_release);
    each.flag("fast_creep", d.fast_creep);
    each.flag("shows_shared", d.shows_shared);
    each.table("sound");
    bool on = !d.volumes.muted;
    each.flag("on", on);
    d.volumes.muted = !on;
    each.number("volume", d.volumes.all, 0, 1);
    constexpr std::array<const char*, sound::kGroups> kNames{"flow", "events", "wind", "notes"};
    for (std::size_t i = 0; i < sound::kGroups; ++i) each.number(kNames[i], d.volumes.of[i], 0, 1);
    each.table("window");
    each.side("width", s.width);
    each.side("height", s.height);
    each.flag("full_screen", s.fullscreen);
    each.table("keys");
    each.keys(s.keys);
    each.end();
}

// A key that is missing leaves its setting as it is.
class Reads {
  public:
    Reads(TomlTable& file, TomlFault& fault) : file_(file), fault_(fault) {}

    void table(const char* name) {
        end();
        if (auto table = file_.table(name)) table_ = std::make_unique<TomlTable>(std::move(*table));
    }
    void flag(const char* key, bool& value) {
        const auto read = table_ ? table_->truth(key) : std::nullopt;
        if (read) value = *read;
    }
    template <class Number>
    void number(const char* key, Number& value, double least, double most) {
        const auto read = table_ ? table_->number(key, least, most) : std::nullopt;
        if (read) value = static_cast<Number>(*read);
    }
    void side(const char* key, int& value) {
        const auto read =
            table_ ? table_->whole(key, Settings::kLeastSide, Settings::kMostSide) : std::nullopt;
        if (read) value = static_cast<int>(*read);
    }
    // One that is not there any more is kept, and English is spoken.
    void language(const char* key, std::string& value) {
        const auto code = table_ ? table_->text(key) : std::nullopt;
        if (!code) return;
        value = *code;
        const bool is_code =
            !code->empty() && code->size() < 16 && std::ranges::all_of(*code, [](unsigned char c) {
                return std::isalnum(c) || c == '_' || c == '-' || c == '@';
            });
        if (!is_code) table_->blame(key, "must be the code of a language, such as de");
    }
    void tier(const char* key, std::optional<Tier>& value) {
        const auto name = table_ ? table_->text(key) : std::nullopt;
        if (!name) return;
        value = tier_from(*name);
        if (!value) table_->blame(key, "must be fast, balanced or full");
    }

    void keys(KeyMap& map) {
        for (std::size_t row = 0; table_ && row < map.size(); ++row) {
            const auto text = table_->text(map.name(row));
            if (!text) continue;
            const auto chord = chord_of(*text);
            if (!chord || !map.accepts(row, *chord) || !map.may_change(row))
                table_->blame(map.name(row), fmt::format("cannot be \"{}\"", *text));
            else
                changed_.emplace_back(row, *chord);
        }
        // Two keys may have changed places.
        for (const auto& [row, chord] : changed_) map.bind(row, {});
        for (const auto& [row, chord] : changed_) {
            if (const auto other = map.conflict(row, chord))
                table_->blame(map.name(row), fmt::format("is the same key as {}", map.name(*other)));
            map.bind(row, chord);
        }
    }

    void end() {
        if (table_ && !fault_) table_->finish();
        table_.reset();
    }

  private:
    TomlTable& file_;
    TomlFault& fault_;
    std::unique_ptr<TomlTable> table_;
    std::vector<std::pair<std::size_t, Chord>> changed_;
};

// As TOML; the text is short and has no more than one kind of mark.
std::string quoted(const std::string& text) {
    const char mark = text.find('\\') == std::string::npos ? '"' : '\'';
    return mark + text + mark;
}

class Writes {
  public:
    void table(const char* name) { text_ += fmt::format("\n[{}]\n", name); }
    void flag(const char* key, bool value) { text_ += fmt::format("{} = {}\n", key, value); }
    template <class Number>
    void number(const char* key, Number value, double /*least*/, double /*most*/) {
        text_ += fmt::format("{} = {}\n", key, value);
    }
    void side(const char* key, int value) {
        if (value > 0) text_ += fmt::format("{} = {}\n", key, value);
    }
    void language(const char* key, const std::string& code) {
        if (!code.empty()) text_ += fmt::format("{} = \"{}\"\n", key, code);
    }
    void tier(const char* key, std::optional<Tier> value) {
        if (value) text_ += fmt::format("{} = \"{}\"\n", key, info_of(*value).name);
    }
    // Those that a person has changed, so that a later program may have other usual ones.
    void keys(const KeyMap& map) {
        const KeyMap& usual = KeyMap::usual();
        for (std::size_t row = 0; row < map.size(); ++row)
            if (map.at(row) != usual.at(row))
                text_ += fmt::format("{} = {}\n", map.name(row), quoted(text_of(map.at(row))));
    }
    void end() {}
    std::string text() && { return std::move(text_); }

  private:
    std::string text_ =
        fmt::format("# Settings of Couloir; the window writes them anew when one changes.\nversion = {}\n",
                    SettingsFile::kVersion);
};

// The display as the file can have it.
Settings only_kept(const Settings& all) {
    Settings kept = all;
    const Display usual;
    kept.display.overlay = usual.overlay;
    kept.display.flow_mesh = usual.flow_mesh;
    kept.display.flow = usual.flow;
    kept.display.surroundings = usual.surroundings;  // the scene says
    kept.display.light = usual.light;
    kept.display.date = usual.date;
    kept.display.probability = usual.probability;
    kept.display.tier = usual.tier;
    return kept;
}

}  // namespace

SettingsFile SettingsFile::of_user() {
    SettingsFile file;
    const auto path = config_folder("settings.toml");
    std::error_code error;
    if (!path) return file;
    file.path_ = *path;
    if (!fs::exists(fs::symlink_status(*path, error))) return file;
    const auto stays = [&](const std::string& why) {
        file.path_.reset();
        file.told_ = fmt::format("{}. The usual settings are used, and changes are not kept", why);
    };
    if (const auto stream = files::open_input(*path); !stream) {
        stays(stream.error());
        return file;
    }
    const auto document = parse_toml(*path);
    TomlFault fault;
    Settings read;
    if (document) {
        TomlTable top(*document, "", path->string(), fault);
        const auto version = top.whole("version", 1, INT32_MAX);
        if (!version && !fault) fault = fmt::format("{}: has no version", path->string());
        if (version && *version > kVersion) {
            stays(fmt::format("{}: written by a newer Couloir, version {}; this one reads {}", path->string(),
                              *version, kVersion));
            return file;
        }
        Reads reads(top, fault);
        each_setting(read, reads);
        if (!fault) top.finish();
    } else {
        fault = document.error().sentence;
    }
    if (!fault) {
        file.begun_ = file.kept_ = file.seen_ = read;
        return file;
    }
    const auto aside = set_aside(*path);
    file.told_ = fmt::format("{}. The usual settings are used{}", *fault,
                             aside ? fmt::format("; the file is kept as {}", aside->string()) : "");
    return file;
}

Outcome<void> SettingsFile::see(const Settings& now, double now_s) {
    if (!path_) return {};
    const Settings kept = only_kept(now);
    if (!(kept == seen_)) seen_ = kept, since_s_ = now_s;
    if (seen_ == kept_ || now_s - since_s_ < kStays) return {};
    return write(seen_);
}

Outcome<void> SettingsFile::finish(const Settings& now) {
    const Settings kept = only_kept(now);
    return !path_ || kept == kept_ ? Outcome<void>() : write(kept);
}

Outcome<void> SettingsFile::write(const Settings& now) {
    Writes writes;
    Settings all = now;
    each_setting(all, writes);
    auto written = write_text(*path_, std::move(writes).text());
    kept_ = now;
    if (written) return {};
    path_.reset();
    return tl::unexpected(Failure{
        written.error().status, fmt::format("{}. Changed settings are not kept", written.error().sentence)});
}

}  // namespace game
