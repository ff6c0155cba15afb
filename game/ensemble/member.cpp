#include "game/ensemble/member.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "game/analysis/headless.h"
#include "game/analysis/measures.h"
#include "game/base/limits.h"
#include "game/recording/format.h"
#include "game/recording/recording_file.h"
#include "terrains/json_reader.h"

namespace game {
namespace {

constexpr double kGreatest = 1e15;  // of any number of a journal

// The figures of a member as the journal names them, with their units in docs/ensembles.md.
struct Figure {
    const char* name;
    double Member::*value;
};
constexpr Figure kFigures[] = {{"seconds", &Member::seconds},     {"released", &Member::released},
                               {"run_out", &Member::run_out},     {"fall", &Member::fall},
                               {"extent", &Member::extent},       {"eroded", &Member::eroded},
                               {"top_speed", &Member::top_speed}, {"thickness", &Member::thickness},
                               {"toe_x", &Member::toe_x},         {"toe_y", &Member::toe_y}};

double released_by(const Session& session) {
    return session.cubic_metres(session.state().ledger.rolling);
}

Json to_json(const Member& member) {
    Json json{{"member", member.number}, {"sample", member.sample}};
    if (!member.fault.empty()) {
        json["fault"] = member.fault;
        return json;
    }
    json["ended"] = member.ended;
    for (const Figure& figure : kFigures) json[figure.name] = member.*figure.value;
    json["hash"] = member.hash;
    return json;
}

Member member_from(const Json& json) {
    Member member;
    member.number = values::whole(json, "member", 1, EnsembleSpec::kMostMembers);
    for (const Json& value : values::list(json, "sample", 64)) member.sample.push_back(value.get<double>());
    if (json.contains("fault")) {
        member.fault = values::text(json, "fault");
        return member;
    }
    member.ended = values::text(json, "ended");
    for (const Figure& figure : kFigures)
        member.*figure.value = values::number(json, figure.name, -kGreatest, kGreatest);
    member.hash = values::text(json, "hash");
    return member;
}

}  // namespace

std::string line_of(const Member& member) {
    return to_json(member).dump(-1, ' ', false, Json::error_handler_t::replace);
}

tl::expected<Member, std::string> member_of(const std::string& line) {
    const auto json = terrains::read_json<Json>(line, kLineLimits);
    if (!json) return tl::unexpected(json.error());
    try {
        return member_from(*json);
    } catch (const std::exception& thrown) {
        return tl::unexpected(std::string(thrown.what()));
    }
}

Outcome<PlayedMember> play_member(const EnsembleSpec& spec, std::int64_t number, const VertexCounts& counts,
                                  const std::function<bool()>& stop,
                                  const std::optional<std::filesystem::path>& record) {
    PlayedMember played;
    Member& member = played.member;
    member.number = number;
    member.sample = spec.sample(number);
    auto scenario = spec.scenario_of(number);
    if (!scenario) {
        member.fault = scenario.error().sentence;
        return played;
    }
    auto session = Session::begin(*scenario, {}, std::nullopt);
    if (!session) return tl::unexpected(session.error());
    if (record) {
        auto recorder = record_into(*record, *scenario);
        if (!recorder) return tl::unexpected(recorder.error());
        if (auto begun = session->record_from_start(std::move(*recorder)); !begun)
            return tl::unexpected(begun.error());
    }
    if (!record) session->hash_when_asked();
    member.released = released_by(*session);
    Until until;
    until.rest = Until::Rest::kEnergy;
    until.most_ticks = std::llrint(spec.seconds / static_cast<double>(scenario->params.tick_s));
    Watchers watchers;
    watchers.keep = [&](const Session&) -> Outcome<void> {
        if (stop()) return tl::unexpected(Failure{Failure::kBadAnswer, "interrupted"});
        return {};
    };
    const auto ended = play_headless(*session, spec.scene.commands, until, watchers, "");
    if (!ended) return tl::unexpected(ended.error());
    if (auto finished = session->finish(); !finished) return tl::unexpected(finished.error());

    const Measures measures = measure(*scenario, *session, release_area(*scenario, spec.scene.commands), {});
    member.ended = to_string(*ended);
    member.seconds = session->seconds();
    member.run_out = measures.run_out, member.fall = measures.fall;
    member.toe_x = measures.toe.x, member.toe_y = measures.toe.y;
    member.extent = measures.extent_area;
    member.eroded = measures.eroded;
    member.top_speed = measures.peak_speed_slope;
    member.thickness = measures.peak_thickness;
    member.hash = hex(session->hash_now());
    played.marks = counts.marks(session->peaks());
    return played;
}

}  // namespace game
