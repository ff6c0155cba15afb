#include "game/share/site.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "game/base/one_line.h"
#include "game/base/version.h"
#include "game/files/assets.h"
#include "game/files/text_file.h"
#include "game/pages/table.h"
#include "game/recording/json_values.h"
#include "game/share/filled.h"
#include "game/share/sha256.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr const char *kIndex = "index.html", *kServiceWorker = "service_worker.js",
                     *kManifest = "manifest.webmanifest";
constexpr std::array kAsTheyAre{"site.css", "site.js", "icon.svg", "icon-192.png", "icon-512.png"};

struct ShelfWords {
    SitePage::Shelf shelf;
    const char *heading, *words;
};
constexpr std::array kShelves{
    ShelfWords{SitePage::Shelf::kChallenges, "Challenges", "A task, a few tools, and three medals."},
    ShelfWords{SitePage::Shelf::kSlides, "Slides",
               "Watch one from every side, and take it over whenever you like."},
    ShelfWords{SitePage::Shelf::kMountains, "Mountains", "Untouched. Nothing happens until you begin."}};

std::string text_of(const std::string& words) {
    return html_text(one_line(words));
}

// The link to a page, and where site.js writes what was scored there. `after`: the score follows the link.
std::string link(const SitePage& page, const std::string& words, bool after) {
    return fmt::format(
        R"(<a href="{0}.html" data-world="{0}" data-bytes="{1}">{2}</a>{3})", page.name, page.bytes, words,
        after ? fmt::format(R"(<span data-best="{}" data-after="yes"></span>)", page.name) : std::string());
}

// Its name in the site.
std::string picture_of(const SitePage& page) {
    return page.name + page.picture->extension().string();
}

std::string card(const SitePage& page, std::span<const SitePage> all) {
    std::string html = page.picture ? fmt::format(R"(<li>
<img src="{}" alt="" width="576" height="324" loading="lazy">
)",
                                                  picture_of(page))
                                    : "<li>\n<div class=\"blank\"></div>\n";
    html += fmt::format("<div class=\"words\">\n<h3>{}</h3>\n<p>{}</p>\n",
                        link(page, text_of(page.title), false), with_signs(text_of(page.words)));
    if (page.shelf == SitePage::Shelf::kChallenges) {
        html += "<ul class=\"medals\">";
        constexpr std::array kNames{"bronze", "silver", "gold"};
        for (std::size_t i = 0; i < kNames.size(); ++i)
            html += fmt::format(R"(<li class="{0}"><span class="hidden">{0} from </span>{1}</li>)", kNames[i],
                                grouped(static_cast<double>(page.medals[i])));
        html += fmt::format("</ul>\n<p class=\"best\" data-best=\"{}\" hidden></p>\n", page.name);
    }
    for (const SitePage& harder : all)
        if (harder.harder_than == page.name)
            html += fmt::format("<p class=\"harder\">{}</p>\n",
                                link(harder, "Harder: " + text_of(harder.title), true));
    return html + "</div>\n</li>\n";
}

// Whether a page stands on the card of another one.
bool stands_below(const SitePage& page, std::span<const SitePage> all) {
    return std::ranges::any_of(all, [&](const SitePage& other) { return other.name == page.harder_than; });
}

std::string shelves_of(std::span<const SitePage> pages) {
    std::string html;
    for (const ShelfWords& shelf : kShelves) {
        std::string cards;
        for (const SitePage& page : pages)
            if (page.shelf == shelf.shelf && !stands_below(page, pages)) cards += card(page, pages);
        if (cards.empty()) continue;
        html += fmt::format("<h2>{}</h2>\n<p>{}</p>\n<ul class=\"shelf\">\n{}</ul>\n", shelf.heading,
                            shelf.words, cards);
    }
    return html;
}

std::string manifest() {
    const auto icon = [](const char* file, const char* sizes, const char* type, const char* purpose) {
        return Json{{"src", file}, {"sizes", sizes}, {"type", type}, {"purpose", purpose}};
    };
    return Json{{"name", "Couloir"},
                {"short_name", "Couloir"},
                {"description", "Avalanches and landslides to play with"},
                {"start_url", "./"},
                {"scope", "./"},
                {"display", "standalone"},
                {"background_color", "#10151b"},
                {"theme_color", "#10151b"},
                {"icons",
                 {icon("icon.svg", "any", "image/svg+xml", "any"),
                  icon("icon-192.png", "192x192", "image/png", "any maskable"),
                  icon("icon-512.png", "512x512", "image/png", "any maskable")}}}
               .dump(1) +
           "\n";
}

std::string digest_of(std::string_view bytes) {
    std::string digits;
    for (const std::uint8_t byte : sha256(bytes)) digits += fmt::format("{:02x}", byte);
    return digits;
}

}  // namespace

bool names_a_site_page(const std::string& name) {
    return !name.empty() && name != fs::path(kIndex).stem() && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

std::vector<std::string> site_names() {
    std::vector<std::string> names{kIndex, kServiceWorker, kManifest, "*.jpg", "*.png"};
    names.insert(names.end(), kAsTheyAre.begin(), kAsTheyAre.end());
    return names;
}

Outcome<void> write_site(const fs::path& folder, std::span<const SitePage> pages) {
    const auto assets = assets_folder();
    if (!assets) return tl::unexpected(assets.error());
    const fs::path from = *assets / "web" / "site";

    Json digests = Json::object();  // of every file but the worker, which has them
    const auto write = [&](const std::string& name, std::string_view text) {
        digests[name] = digest_of(text);
        return write_text(folder / name, text);
    };
    const auto copy = [&](const fs::path& file, const std::string& name) {
        return read_text(file).and_then([&](const std::string& text) { return write(name, text); });
    };
    for (const char* name : kAsTheyAre)
        if (auto copied = copy(from / name, name); !copied) return copied;
    for (const SitePage& page : pages) {
        const std::string name = page.name + ".html";
        const auto text = read_text(folder / name);
        if (!text) return tl::unexpected(text.error());
        digests[name] = digest_of(*text);
        if (page.picture && !stands_below(page, pages))
            if (auto copied = copy(*page.picture, picture_of(page)); !copied) return copied;
    }
    if (auto written = write(kManifest, manifest()); !written) return written;

    const auto index = read_text(from / kIndex), worker = read_text(from / kServiceWorker);
    if (!index) return tl::unexpected(index.error());
    if (!worker) return tl::unexpected(worker.error());
    const std::string shelves = shelves_of(pages), program = html_text(kProgram);
    if (auto written = write(kIndex, filled(*index, {{"@SHELVES@", shelves}, {"@PROGRAM@", program}}));
        !written)
        return written;
    const std::string all = digests.dump(1);
    return write_text(folder / kServiceWorker, filled(*worker, {{"@FILES@", all}}));
}

}  // namespace game
