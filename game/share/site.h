#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/base/outcome.h"

namespace game {

// A page that stands in the folder of a site, and what the index says of it.
struct SitePage {
    enum class Shelf : std::uint8_t { kChallenges, kSlides, kMountains };
    Shelf shelf = Shelf::kMountains;
    std::string name;                      // of its files: NAME.html, NAME.jpg or NAME.png
    std::string title;                     // as anybody wrote it
    std::string words;                     // a sentence: the task, or what is to be seen
    std::array<std::int64_t, 3> medals{};  // of a challenge: least scores
    std::optional<std::filesystem::path> picture = std::nullopt;  // .jpg or .png
    std::string harder_than = {};  // name of another page, on whose card this one stands
    std::uint64_t bytes = 0;
};

// What a page of a challenge may be called within a site: letters, digits, '-' and '_', and not as what every site has.
bool names_a_site_page(const std::string& name);

// The names of what write_site() writes beside the pages themselves; "*.jpg" and "*.png" among them.
std::vector<std::string> site_names();

// Makes a site of the pages in `folder`: an index with their pictures, and what a browser needs to install it and to open it
// without a network. Equal pages give equal files. Errors: a file of assets/web/site, a picture or a page cannot be read, or
// one cannot be written (status 3).
Outcome<void> write_site(const std::filesystem::path& folder, std::span<const SitePage> pages);

}  // namespace game
