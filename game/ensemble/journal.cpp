#include "game/ensemble/journal.h"

#include <utility>

#include <fmt/format.h>

#include "game/base/limits.h"
#include "game/files/text_file.h"
#include "game/recording/format.h"

namespace game {
namespace {

std::string header_of(const EnsembleSpec& spec) {
    Json names = Json::array();
    for (const Variable& each : spec.variables) names.push_back(each.name());
    return Json{{"couloir", "ensemble"}, {"format", 1}, {"ensemble", spec.identity}, {"variables", names}}
        .dump();
}

}  // namespace

Outcome<JournalText> read_journal(const std::string& text, const std::string& name,
                                  const EnsembleSpec& spec) {
    const std::string header = header_of(spec);
    const auto wrong = [&](std::size_t line, const std::string& fact) {
        return unusable(fmt::format("{}:{}: {}", name, line, fact));
    };
    JournalText read;
    std::size_t begin = 0, number = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        const std::string line = text.substr(begin, end - begin);
        ++number;
        begin = end + 1;
        if (number == 1) {
            if (line != header)
                return wrong(
                    1,
                    "is the journal of another ensemble, ground or version of the physics; give another "
                    "--out, or delete it");
            continue;
        }
        auto member = member_of(line);
        if (!member) return wrong(number, fmt::format("is no member of an ensemble: {}", member.error()));
        if (member->sample.size() != spec.variables.size())
            return wrong(number, "has another number of variables");
        const std::int64_t of = member->number;
        if (!read.members.emplace(of, std::move(*member)).second)
            return wrong(number, fmt::format("has member {} a second time", of));
    }
    read.torn = text.size() - begin;
    read.has_begun = number > 0;
    if (read.torn > 0 && !read.has_begun && !header.starts_with(text))
        return wrong(1, "is not the journal of an ensemble");
    return read;
}

Outcome<Journal> Journal::open(const std::filesystem::path& path, const EnsembleSpec& spec) {
    if (auto placed = make_folder(path.parent_path()); !placed) return tl::unexpected(placed.error());
    std::string text;
    auto file = files::AppendedFile::open(path, kMostJournalBytes, text);
    if (!file) return machine_fails(file.error());
    auto read = read_journal(text, path.string(), spec);
    if (!read) return tl::unexpected(read.error());
    Journal journal(path, std::move(*file), std::move(*read));
    if (auto cut = journal.file_.cut(text.size() - journal.read_.torn); !cut)
        return machine_fails(cut.error());
    if (journal.read_.has_begun) return journal;
    if (auto written = journal.file_.add(header_of(spec) + '\n'); !written)
        return machine_fails(written.error());
    return journal;
}

Outcome<void> Journal::add(const Member& member) {
    if (const auto earlier = read_.members.find(member.number); earlier != read_.members.end()) {
        if (line_of(earlier->second) == line_of(member)) return {};
        return tl::unexpected(
            Failure{Failure::kBadAnswer,
                    fmt::format("{}: member {} came to {} before, and now to {}: the same member on another "
                                "machine or program must come to the same bits",
                                path_.string(), member.number, earlier->second.hash, member.hash)});
    }
    if (auto written = file_.add(line_of(member) + '\n'); !written) return machine_fails(written.error());
    read_.members.emplace(member.number, member);
    return {};
}

}  // namespace game
