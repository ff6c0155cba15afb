#include "game/app/languages.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/files/user_folders.h"
#include "game/words/words.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "languages";
constexpr std::size_t kMostLanguages = 64;  // of a folder

// At most so many, the first by name; `told` if there are more.
std::vector<fs::path> catalogues_in(const fs::path& folder, std::vector<std::string>& told) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ".po") files.push_back(entry->path());
    std::ranges::sort(files);
    if (files.size() > kMostLanguages) {
        told.push_back(fmt::format("{}: more than {} languages; the last ones are left out", folder.string(),
                                   kMostLanguages));
        files.resize(kMostLanguages);
    }
    return files;
}

std::string_view variable(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

}  // namespace

Outcome<Language> read_language(const fs::path& file) {
    std::error_code error;
    if (fs::file_size(file, error) > kMostLanguageBytes && !error)  // before it is read
        return unusable(fmt::format("{}: more than {} bytes", file.string(), kMostLanguageBytes));
    const auto text = read_text(file);
    return text ? Language::from_text(*text, file.string()) : tl::unexpected(text.error());
}

Languages Languages::of_user() {
    Languages all;
    std::vector<fs::path> files;
    if (const auto own = data_folder(kFolder)) files = catalogues_in(*own, all.told_);
    if (const auto assets = assets_folder())
        std::ranges::copy(catalogues_in(*assets / kFolder, all.told_), std::back_inserter(files));
    std::vector<std::shared_ptr<const Language>> read;
    for (const fs::path& file : files) {
        auto language = read_language(file);
        if (!language) {
            all.told_.push_back(language.error().sentence);
            continue;
        }
        const auto same = [&](const auto& other) { return other->code() == language->code(); };
        if (language->code() != "en" && std::ranges::none_of(read, same))
            read.push_back(std::make_shared<const Language>(std::move(*language)));
    }
    std::ranges::sort(read, {}, [](const auto& language) { return language->name(); });
    for (auto& language : read) {
        all.choices_.push_back({language->code(), language->name()});
        all.read_.push_back(std::move(language));
    }
    return all;
}

void Languages::choose(std::string_view code) {
    const std::string wanted = code.empty() ? language_of_system(choices_) : std::string(code);
    const auto found = std::ranges::find(choices_, wanted, &LanguageChoice::code);
    speak(found == choices_.end() ? nullptr : read_[static_cast<std::size_t>(found - choices_.begin())]);
}

std::string language_of_system(const std::vector<LanguageChoice>& choices) {
    std::string_view locale;
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (locale.empty()) locale = variable(name);
    const bool plain = locale.empty() || locale == "C" || locale == "POSIX" || locale.starts_with("C.");
    if (plain) return "en";
    // "de_AT:de:fr" before "de_AT.UTF-8".
    std::string_view wishes = variable("LANGUAGE");
    if (wishes.empty()) wishes = locale;
    while (!wishes.empty()) {
        const std::string_view wish = wishes.substr(0, wishes.find(':'));
        wishes.remove_prefix(std::min(wish.size() + 1, wishes.size()));
        const std::string_view whole = wish.substr(0, wish.find_first_of(".@"));
        for (const std::string_view code : {whole, whole.substr(0, whole.find('_'))})
            if (std::ranges::find(choices, code, &LanguageChoice::code) != choices.end())
                return std::string(code);
    }
    return "en";
}

}  // namespace game
