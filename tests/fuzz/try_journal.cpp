#include "tests/fuzz/try_reader.h"

#include "game/ensemble/journal.h"
#include "sim/world/params.h"

namespace game::test {
namespace {

// Of no real ensemble, so that the identity in the seeds stays.
EnsembleSpec tried_spec() {
    EnsembleSpec spec;
    spec.file = "tried.toml";
    spec.members = 100;
    spec.identity = "0123456789abcdef";
    for (const char* name : {"friction", "drag"}) {
        Variable& variable = spec.variables.emplace_back();
        variable.param = &sim::kParams[static_cast<std::size_t>(sim::param_from(name).value())];
        variable.distribution = {Distribution::Kind::kUniform, {0, 1}};
    }
    return spec;
}

Outcome<void> try_journal(const std::filesystem::path& file) {
    static const EnsembleSpec spec = tried_spec();
    const auto journal = Journal::open(file, spec);
    if (!journal) return tl::unexpected(journal.error());
    for (const auto& [number, member] : journal->members())
        if (number != member.number || member.sample.size() != spec.variables.size())
            return broken("a member that is none");
    return {};
}

}  // namespace

const TriedReader kTriedJournal{"journal", "x.jsonl", try_journal};

}  // namespace game::test
