#include "game/pages/html.h"

#include <fmt/format.h>

#include "game/pages/table.h"

namespace game {
namespace {

constexpr const char* kPageStyle =
    R"(:root { color-scheme: light dark; --paper: #fff; --ink: #222; --soft: #555; --line: #ddd; }
@media (prefers-color-scheme: dark) { :root { --paper: #16181b; --ink: #e4e4e4; --soft: #a8adb3; --line: #3a3e44; } a { color: #8ab8ff; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 1320px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.6em; } h2 { font-size: 1.25em; margin: 2.2em 0 .2em; } h3 { font-size: 1em; margin: 1.6em 0 .4em; }
p { max-width: 46em; margin: .3em 0 .8em; }
.row { display: flex; flex-wrap: wrap; gap: 12px; align-items: flex-start; }
figure { margin: 0; flex: 1 1 300px; } figure.large { flex-basis: 100%; } img { max-width: 100%; display: block; }
figcaption, .small { font-size: .87em; color: var(--soft); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .87em; font-variant-numeric: tabular-nums; }
th, td { padding: .18em .7em; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--line); }
th.left, td.left { text-align: left; }
.swatch { display: inline-block; width: 1.1em; height: 1.1em; vertical-align: -.2em; margin: 0 .3em 0 .9em; border: 1px solid #999; }
)";

}  // namespace

std::string begin_page(const std::string& title, const std::string& style, std::optional<int> reload_s) {
    const std::string reload =
        reload_s ? fmt::format("<meta http-equiv=\"refresh\" content=\"{}\">\n", *reload_s) : "";
    return fmt::format(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
{3}<title>{0}</title>
<style>
{1}{2}</style>
</head>
<body>
<h1>{0}</h1>
)",
                       html_text(title), kPageStyle, style, reload);
}

std::string end_page(const std::string& made_by) {
    return fmt::format("<p class=\"small\">Made by {}.</p>\n</body>\n</html>\n", html_text(made_by));
}

}  // namespace game
