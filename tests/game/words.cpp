#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "game/analysis/score.h"
#include "game/app/languages.h"
#include "game/controls/catalogue.h"
#include "game/controls/frame_times.h"
#include "game/controls/gamepad.h"
#include "game/controls/key_map.h"
#include "game/controls/tier.h"
#include "game/controls/tools.h"
#include "game/files/assets.h"
#include "game/files/toml_table.h"
#include "game/scene/goal.h"
#include "game/scene/lesson.h"
#include "game/sound/waves.h"
#include "game/words/language.h"
#include "game/words/names.h"
#include "game/words/plain.h"
#include "game/words/words.h"
#include "sim/world/params.h"
#include "sim/world/things.h"
#include "tests/support/literals.h"
#include "tests/support/places.h"

namespace game::test {
namespace {

namespace fs = std::filesystem;

// Messages, and a place each where they are used.
using Messages = std::map<std::string, std::string>;

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// Whether it has a word, beside what printf and fmt put in and beside units.
bool has_words(std::string_view text) {
    static const std::set<std::string, std::less<>> kUnits{"m",  "ms", "kPa", "ha", "m³", "s",
                                                           "km", "MB", "em",  "mm", "EV"};
    std::string word;
    const auto is_word = [&] { return word.size() > 1 && !kUnits.contains(word); };
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const char c = i < text.size() ? text[i] : ' ';
        if (c == '%' && word.empty()) {
            i = std::min(text.find_first_of("%diufgcsxz", i + 1), text.size());
            if (i < text.size() && text[i] == 'z') ++i;
        } else if (c == '{' && word.empty()) {
            i = std::min(text.find('}', i), text.size());
        } else if (std::isalpha(static_cast<unsigned char>(c))) {
            word += c;
        } else if (static_cast<unsigned char>(c) < 0x80) {
            if (is_word()) return true;
            word.clear();
        }
    }
    return false;
}

// Texts of game/ui that nobody reads: names of windows and of places that tests look for, and formats of ImGui.
bool is_no_message(const support::Literal& literal) {
    static const std::set<std::string, std::less<>> kCallers{"note",
                                                             "Begin",
                                                             "BeginChild",
                                                             "keep_window_clear",
                                                             "Columns",
                                                             "InvisibleButton",
                                                             "PushID",
                                                             "GetID",
                                                             "ImGui_ImplOpenGL3_Init",
                                                             "InputText",
                                                             "SliderScalar",
                                                             "AddFontFromFileTTF"};
    static const std::set<std::string, std::less<>> kTexts{"key %s",
                                                           "key of %.*s",
                                                           "Close %s",
                                                           "Panel %s",
                                                           "%s: default",
                                                           "_slope",
                                                           "_s",
                                                           "Couloir",
                                                           ".png",
                                                           ".jpg",
                                                           "start_slope",
                                                           "#version 450",
                                                           "%4d-%2d-%2d_%2d-%2d-%2d_%n"};
    return kCallers.contains(literal.caller) || kTexts.contains(literal.text) ||
           literal.text.starts_with("##");
}

void add(Messages& messages, std::string_view text, const std::string& place) {
    const bool is_name = text.find('_') != text.npos && text.find(' ') == text.npos;
    if (has_words(text) && !is_name) messages.emplace(text, place);
}

// In game/ui every text is read by a person, but for those above. Elsewhere those given to tr(), said() and message().
Messages messages_in_sources() {
    Messages messages;
    const fs::path top = support::source_dir() / "game";
    for (const auto& entry : fs::recursive_directory_iterator(top)) {
        const fs::path& path = entry.path();
        if (path.extension() != ".cpp" && path.extension() != ".h") continue;
        const bool is_ui = path.parent_path().filename() == "ui";
        for (const support::Literal& literal : support::literals_in(text_of(path))) {
            const std::string place = path.filename().string() + ":" + std::to_string(literal.line);
            if (literal.caller == "tr" || literal.caller == "said" || literal.caller == "message") {
                if (!literal.text.empty()) messages.emplace(literal.text, place);
            } else if (is_ui && !is_no_message(literal))
                add(messages, literal.text, place);
        }
    }
    return messages;
}

void add_tables(Messages& messages) {
    for (const ToolInfo& tool : tool_infos()) {
        add(messages, tool.tooltip, "tools");
        for (const Deed* deed : {tool.plain, tool.control, tool.shift})
            add(messages, deed->label, "tools"), add(messages, deed->purpose, "tools");
        for (const ToolNumber& number : tool.numbers)
            for (const char* text : {number.label, number.format, number.tooltip})
                add(messages, text, "tools");
    }
    for (std::size_t row = 0; row < KeyMap::usual().size(); ++row)
        add(messages, KeyMap::usual().meaning(row), "keys");
    for (const GestureBinding& binding : gesture_bindings())
        add(messages, binding.hand, "gestures"), add(messages, binding.meaning, "gestures");
    for (const PadPart& part : pad_parts())
        add(messages, part.name, "gamepad"), add(messages, part.meaning, "gamepad");
    for (const PadBinding& binding : pad_bindings())
        add(messages, binding.name, "gamepad"), add(messages, binding.meaning, "gamepad");
    for (const PadWheel wheel : {PadWheel::kTools, PadWheel::kTime})
        for (const PadChoice& choice : choices_of(wheel)) add(messages, choice.label, "gamepad");
    for (const char* stage : kStageNames) add(messages, stage, "stages");
    for (const TierInfo& tier : kTiers)
        add(messages, tier.name, "tiers"), add(messages, tier.tooltip, "tiers");
    for (std::size_t i = 0; i < sound::kGroups; ++i) {
        const sound::GroupInfo& group = sound::info_of(static_cast<sound::Group>(i));
        add(messages, group.name, "sound"), add(messages, group.meaning, "sound");
    }
    for (const MeasureInfo& measure : measure_infos())
        add(messages, measure.words, "measures"), add(messages, measure.unit, "measures");
    for (const PlainWords& words : plain_words()) messages.emplace(words.plain, "plain words");
    for (int medal = 0; medal <= 3; ++medal) add(messages, medal_name(medal), "medals");
    for (const sim::CommandInfo& command : sim::kCommands) add(messages, command.name, "commands");
    for (std::size_t i = 0; i < sim::kThingKinds; ++i) {
        std::string kind(sim::to_string(static_cast<sim::ThingKind>(i)));
        kind.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(kind.front())));
        add(messages, kind, "things");
    }
    for (const sim::ParamInfo& param : sim::kParams) {
        add(messages, param.meaning, "parameters");
        std::string label(param.name);
        if (label.ends_with("_s")) label.resize(label.size() - 2);
        std::ranges::replace(label, '_', ' ');
        add(messages, label, "parameters");
    }
}

// Titles, sentences, tasks and lessons of what ships.
void add_assets(Messages& messages) {
    const auto assets = assets_folder();
    ASSERT_TRUE(assets);
    for (const char* folder : {"scenes", "materials"})
        for (const auto& entry : fs::directory_iterator(*assets / folder)) {
            if (entry.path().extension() != ".toml") continue;
            const auto file = parse_toml(entry.path());
            ASSERT_TRUE(file) << entry.path();
            for (const char* key : {"title", "about"})
                add(messages, (*file)[key].value_or(std::string()), entry.path().filename());
            for (const char* key : {"say", "learn"})
                add(messages, (*file)["goal"][key].value_or(std::string()), entry.path().filename());
        }
    const auto lessons = asset_names(AssetKind::kLesson);
    ASSERT_TRUE(lessons);
    for (const std::string& name : *lessons) {
        const Lesson lesson = read_lesson(find_asset(AssetKind::kLesson, name).value()).value();
        add(messages, lesson.title, name), add(messages, lesson.about, name);
        for (const Lesson::Stop& stop : lesson.stops) {
            add(messages, stop.heading, name), add(messages, stop.text, name);
            if (!stop.question) continue;
            add(messages, stop.question->asks, name), add(messages, stop.question->why, name);
            for (const std::string& answer : stop.question->answers) add(messages, answer, name);
        }
    }
    const auto catalogue = read_catalogue();
    ASSERT_TRUE(catalogue);
    for (const Catalogue::Entry& recording : catalogue->recordings)
        add(messages, recording.title, "recordings");
}

Messages all_messages() {
    Messages messages = messages_in_sources();
    add_tables(messages);
    add_assets(messages);
    return messages;
}

std::vector<fs::path> shipped_languages() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(support::source_dir() / "assets/languages"))
        if (entry.path().extension() == ".po") files.push_back(entry.path());
    return files;
}

class Catalogues : public testing::Test {
  protected:
    // Reads one with these lines after its header.
    Outcome<Language> read(const std::string& lines) const { return read_whole(kHeader + lines); }
    Outcome<Language> read_whole(const std::string& text) const {
        const fs::path file = folder_.path() / "xx.po";
        std::ofstream(file) << text;
        return read_language(file);
    }
    // What is wrong, without the name of the file.
    std::string fault(const std::string& lines) const {
        const auto language = read(lines);
        if (language) return "nothing";
        EXPECT_EQ(language.error().status, Failure::kUnusable);
        const std::string& sentence = language.error().sentence;
        return sentence.substr(std::min(sentence.find("xx.po:"), sentence.size()));
    }

    // Four lines.
    static constexpr const char* kHeader =
        "msgid \"\"\nmsgstr \"\"\n"
        "\"Language: xx\\nX-Language-Name: Xish\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n";
    support::TemporaryFolder folder_;
};

TEST_F(Catalogues, give_words_to_messages) {
    const auto language = read(
        "\n# by hand\n#: panel.cpp\nmsgid \"Dig\"\nmsgstr \"Gra\"\n\"ben\"\n"
        "#, fuzzy\nmsgid \"Pour\"\nmsgstr \"Gie\u00dfen\"\n\nmsgid \"Blast\"\nmsgstr \"\"\n"
        "#~ msgid \"Gone\"\n#~ msgstr \"Weg\"\n\nmsgid \"a \\\"b\\\"\\n\"\nmsgstr \"c\\\\\"\r\n");
    ASSERT_TRUE(language) << language.error().sentence;
    EXPECT_EQ(language->code(), "xx");
    EXPECT_EQ(language->name(), "Xish");
    ASSERT_TRUE(language->find("Dig"));
    EXPECT_EQ(*language->find("Dig"), "Graben");
    ASSERT_TRUE(language->find("a \"b\"\n"));
    EXPECT_EQ(*language->find("a \"b\"\n"), "c\\");
    for (const char* none : {"Pour", "Blast", "Gone", ""}) EXPECT_FALSE(language->find(none)) << none;
}

TEST_F(Catalogues, are_refused_with_their_line_if_they_are_damaged) {
    EXPECT_EQ(fault("msgid \"a\"\n"), "xx.po:5: msgid without msgstr");
    EXPECT_EQ(fault("msgstr \"a\"\n"), "xx.po:5: msgstr without msgid");
    EXPECT_EQ(fault("msgid \"a\nmsgstr \"b\"\n"), "xx.po:5: a text whose quotation mark does not close");
    EXPECT_EQ(fault("msgid \"a\" b\"\nmsgstr \"b\"\n"),
              "xx.po:5: something follows the text in quotation marks");
    EXPECT_EQ(fault("msgid a\n"), "xx.po:5: no text in quotation marks");
    EXPECT_EQ(fault("msgid \"\\x\"\nmsgstr \"b\"\n"), "xx.po:5: \\x is no escape that is used here");
    EXPECT_EQ(fault("<html>\n"), "xx.po:5: begins with neither #, \", msgid nor msgstr");
    EXPECT_EQ(fault("msgctxt \"a\"\n"), "xx.po:5: msgctxt: contexts and plurals are not used here");
    EXPECT_EQ(fault("msgid \"a\"\nmsgid_plural \"b\"\n"),
              "xx.po:6: msgid_plural: contexts and plurals are not used here");
    EXPECT_EQ(fault("msgid \"a\"\nmsgstr \"b\"\nmsgid \"a\"\nmsgstr \"c\"\n"),
              "xx.po:7: \"a\" is there twice");
    EXPECT_EQ(fault("msgid \"\"\nmsgstr \"b\"\n"), "xx.po:5: a second header");
    EXPECT_EQ(fault("msgid \"a\"\nmsgstr \"\xe4\"\n"),
              "xx.po:5: \"a\": not UTF-8, or has signs that cannot be seen");
    EXPECT_EQ(fault("msgid \"a\"\nmsgstr \"\u202e\"\n"),
              "xx.po:5: \"a\": not UTF-8, or has signs that cannot be seen");
    EXPECT_FALSE(read_whole("msgid \"a\"\nmsgstr \"b\"\n"));
    EXPECT_FALSE(read_whole(""));
    EXPECT_FALSE(read("msgid \"" + std::string(5000, 'a') + "\"\nmsgstr \"b\"\n"));
    EXPECT_FALSE(read(std::string(2 << 20, '#')));
}

TEST_F(Catalogues, of_a_person_come_first_and_damaged_ones_are_told) {
    const fs::path own = folder_.path() / "couloir/languages";
    fs::create_directories(own);
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(own / name) << text;
    };
    write("de.po", std::string(kHeader).replace(std::string(kHeader).find("xx"), 2, "de"));
    write("broken.po", "msgid\n");
    write("notes.txt", "no language");
    setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    const Languages some = Languages::of_user();
    for (int i = 0; i < 70; ++i) write("many" + std::to_string(i) + ".po", kHeader);
    const Languages many = Languages::of_user();
    unsetenv("XDG_DATA_HOME");
    ASSERT_EQ(some.choices().size(), 2u);
    EXPECT_EQ(some.choices()[0].name, "English");
    EXPECT_EQ(some.choices()[1].code, "de");
    EXPECT_EQ(some.choices()[1].name, "Xish");
    ASSERT_EQ(some.told().size(), 1u);
    EXPECT_NE(some.told()[0].find("broken.po:1:"), std::string::npos) << some.told()[0];
    ASSERT_EQ(many.told().size(), 2u);
    EXPECT_NE(many.told()[0].find("more than 64 languages"), std::string::npos) << many.told()[0];
}

TEST(Words, name_directions_and_months) {
    EXPECT_STREQ(compass_point(0), "N");
    EXPECT_STREQ(compass_point(360), "N");
    EXPECT_STREQ(compass_point(-90), "W");
    EXPECT_STREQ(compass_point(-360), "N");
    EXPECT_STREQ(compass_point(112), "E");
    EXPECT_STREQ(compass_point(113), "SE");
    EXPECT_STREQ(month_name(1), "Jan");
    EXPECT_STREQ(month_name(12), "Dec");
}

TEST(Languages, are_asked_for_by_the_system_as_gettext_reads_it) {
    const std::vector<LanguageChoice> choices{{"en", "English"}, {"de", "Deutsch"}, {"pt_BR", "Português"}};
    const auto asked = [&](const char* all, const char* lang, const char* wishes) {
        std::map<std::string, std::string> before;
        const std::pair<const char*, const char*> given[]{
            {"LC_ALL", all}, {"LC_MESSAGES", ""}, {"LANG", lang}, {"LANGUAGE", wishes}};
        for (const auto& [name, value] : given) {
            if (const char* const was = std::getenv(name)) before[name] = was;
            setenv(name, value, 1);
        }
        const std::string code = language_of_system(choices);
        for (const auto& [name, value] : given) {
            unsetenv(name);
            if (before.contains(name)) setenv(name, before[name].c_str(), 1);
        }
        return code;
    };
    EXPECT_EQ(asked("", "de_AT.UTF-8", ""), "de");
    EXPECT_EQ(asked("", "pt_BR.UTF-8", ""), "pt_BR");
    EXPECT_EQ(asked("", "fr_FR.UTF-8", "fr:de"), "de");
    EXPECT_EQ(asked("", "fr_FR.UTF-8", ""), "en");
    EXPECT_EQ(asked("C.UTF-8", "de_DE.UTF-8", "de"), "en");
    EXPECT_EQ(asked("", "", "de"), "en");
}

// Each would be read as a number or a text that is not there.
TEST_F(Catalogues, are_refused_if_a_placeholder_differs) {
    for (const auto& [english, words] : {std::pair("%.1f m", "%s m"),
                                         {"%d of %d", "%d"},
                                         {"%s", "%s %s"},
                                         {"%d", "%ld"},
                                         {"%s", "%n"},
                                         {"%d %s", "%s %d"},
                                         {"100", "100 %"},
                                         {"%.0f %%", "%.0f %"},
                                         {"{}", "{} {}"},
                                         {"{:.1f}", "{}"},
                                         {"{}", "{"},
                                         {"{}", "}"},
                                         {"{} {:.0f}", "{:.0f} {}"},
                                         {"{} {}", "{1} {}"},
                                         {"%s %s", "%2$s %s"},
                                         {"%.*s %s", "%3$s %.*1$s"}}) {
        const std::string lines = std::string("msgid \"") + english + "\"\nmsgstr \"" + words + "\"\n";
        EXPECT_EQ(fault(lines),
                  std::string("xx.po:5: \"") + english + "\": the placeholders of \"" + words + "\" differ");
    }
    for (const auto& [english, words] : {std::pair("%d %s", "%2$s %1$d"),
                                         {"%.0f %%", "%% %.0f"},
                                         {"{} of {:.1f}", "{1:.1f} von {0}"},
                                         {"{}", "{0}"},
                                         {"%.*s", "%.*s!"}})
        EXPECT_TRUE(same_placeholders(english, words)) << words;
}

TEST(Words, that_are_plain_have_the_places_of_those_of_the_field) {
    const Messages messages = all_messages();
    EXPECT_TRUE(std::ranges::is_sorted(plain_words(), {}, &PlainWords::of_field));
    for (const PlainWords& words : plain_words()) {
        EXPECT_TRUE(same_placeholders(words.of_field, words.plain)) << words.plain;
        EXPECT_TRUE(messages.contains(std::string(words.of_field))) << "nobody says " << words.of_field;
    }
    EXPECT_STREQ(tr("Standing"), "Standing");
    speak_plainly(true);
    EXPECT_STREQ(tr("Standing"), "Cover");
    EXPECT_EQ(tr(std::string_view("rolling layer")), "flow");
    EXPECT_STREQ(tr("Pressure"), "Pressure");
    speak_plainly(false);
}

TEST(Words, of_every_language_are_complete) {
    const Messages messages = all_messages();
    EXPECT_GT(messages.size(), 500u);
    ASSERT_FALSE(shipped_languages().empty());
    for (const fs::path& file : shipped_languages()) {
        const auto language = read_language(file);
        ASSERT_TRUE(language) << language.error().sentence;
        for (const auto& [message, place] : messages)
            EXPECT_TRUE(language->find(message))
                << file.filename() << " has no words for \"" << message << "\" of " << place;
        for (const std::string_view message : language->messages())
            EXPECT_TRUE(messages.contains(std::string(message)))
                << file.filename() << ": nobody says \"" << message << '"';
    }
}

}  // namespace
}  // namespace game::test
