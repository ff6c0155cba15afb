#include "game/live/live_world.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "game/analysis/advice.h"
#include "game/controls/tools.h"
#include "game/recording/reader.h"
#include "game/scene/surface.h"

namespace game {
namespace {

constexpr std::array kGroups{"snow", "ground", "things"};                                // of ToolGroup
constexpr std::array kActs{"always", "distance", "press", "turn", "pieces", "release"};  // of Acts

std::string_view name_of(Tool tool) {
    return sim::info_of(info_of(tool).plain->kind).name;
}

// A tool by the name of its command; null if there is none.
const ToolInfo* tool_called(std::string_view name) {
    const auto infos = tool_infos();
    const auto found =
        std::ranges::find_if(infos, [&](const ToolInfo& info) { return name_of(info.tool) == name; });
    return found == infos.end() ? nullptr : &*found;
}

// ["line",-1,0,1,0]: as the numbers of an IconPart.
Json json_of(const IconPart& part) {
    constexpr std::array<std::pair<const char*, std::size_t>, 6> kShapes{
        {{"line", 4}, {"triangle", 6}, {"box", 4}, {"dot", 3}, {"ring", 3}, {"rays", 3}}};
    const auto& [name, count] = kShapes.at(static_cast<std::size_t>(part.shape));
    Json json{name};
    for (std::size_t i = 0; i < count; ++i) json.push_back(values::as_recorded(part.numbers[i]));
    return json;
}

Json json_of(const Deed& deed) {
    const sim::CommandInfo& info = sim::info_of(deed.kind);
    Json icon = Json::array();
    for (const IconPart& part : deed.icon) icon.push_back(json_of(part));
    return {{"kind", info.name},
            {"label", deed.label},
            {"purpose", deed.purpose},
            {"acts", kActs.at(static_cast<std::size_t>(deed.acts))},
            {"ring", {deed.ring.r, deed.ring.g, deed.ring.b}},
            {"radius", takes(deed.kind, &sim::Command::radius)},
            {"line", takes(deed.kind, &sim::Command::to_x)},
            {"slope", info.has_slope},
            {"icon", std::move(icon)}};
}

// With the limits of a challenge, if it limits this tool: a number that the rules fix is left out.
Json json_of(const ToolInfo& tool, const Goal::Tool* limited, const RadiusRange& radii) {
    const auto range_of = [&](double sim::Command::*member, double least, double most) {
        const Goal::Limit* const limit = limited ? limit_of(*limited, member) : nullptr;
        return limit ? RadiusRange{limit->least, limit->most} : RadiusRange{least, most};
    };
    Json numbers = Json::array();
    for (const ToolNumber& each : tool.numbers) {
        const bool as_it_is = tool.plain->amount == Amount::kAsItIs;
        const bool fixed = limited && limit_of(*limited, each.member) && !as_it_is;
        const RadiusRange range =
            as_it_is ? range_of(each.member, each.least, each.most) : RadiusRange{each.least, each.most};
        numbers.push_back({{"label", each.label},
                           {"format", each.format},
                           {"tooltip", each.tooltip},
                           {"least", range.least},
                           {"most", range.most},
                           {"scale", each.scale},
                           {"usual", std::clamp(each.usual, range.least, range.most)},
                           {"fixed", fixed || range.least == range.most}});
    }
    const RadiusRange radius = range_of(&sim::Command::radius, radii.least, radii.most);
    return {{"name", name_of(tool.tool)},
            {"group", kGroups.at(static_cast<std::size_t>(tool.group))},
            {"key", std::string(1, static_cast<char>(tool.key))},
            {"tooltip", tool.tooltip},
            {"radius", {radius.least, radius.most}},
            {"layer", sim::info_of(tool.plain->kind).has_layer && !(limited && limited->layer)},
            {"plain", json_of(*tool.plain)},
            {"control", json_of(*tool.control)},
            {"shift", json_of(*tool.shift)},
            {"numbers", std::move(numbers)}};
}

// "a number from 1 to 5", or nothing if it is one.
std::optional<double> number_in(const Json& json, double least, double most) {
    if (!json.is_number()) return std::nullopt;
    const auto number = json.get<double>();
    return number >= least && number <= most ? std::optional(number) : std::nullopt;
}

}  // namespace

Outcome<LiveWorld> LiveWorld::open(const std::string& recording, std::string name) {
    LoadedWorld loaded;
    // A world keeps moments to go back to, and is played beside them.
    loaded.memory.use = {.sessions = 1, .goes_back = true};
    std::istringstream stream(recording);
    auto read = read_recording(stream, name, loaded.memory);
    if (!read) return tl::unexpected(read.error());
    if (read->header.scenario.flow)
        return unusable(fmt::format("{}: a flow demo has no slide to take over", name));
    loaded.name = name;
    loaded.scene.scenario = read->header.scenario;
    const std::optional<render::FlowLook> look = std::exchange(loaded.scene.scenario.look.flow, std::nullopt);
    loaded.scene.commands = read->commands;
    loaded.watched = std::move(*read);
    auto sandbox = Sandbox::begin(std::move(loaded), {}, std::nullopt);
    if (!sandbox) return tl::unexpected(sandbox.error());
    return LiveWorld(std::move(*sandbox), std::move(name), look);
}

LiveWorld::LiveWorld(Sandbox sandbox, std::string name, std::optional<render::FlowLook> look)
    : sandbox_(std::move(sandbox)), name_(std::move(name)), look_(look) {
    if (state().things) first_forest_ = state().things->forest;
    hand_.suit(sandbox_.scenario().grid);
    fit_hand();
}

// A challenge has its own tools and limits.
void LiveWorld::fit_hand() {
    const auto& goal = sandbox_.scenario().goal;
    if (goal && !hand_.stroke()) hand_.fit(*goal);
}

LiveWorld::Advanced LiveWorld::advance(int ticks) {
    Advanced done;
    const auto tick_s = static_cast<double>(state().params.tick_s);
    while (done.ticks < ticks && !sandbox_.watched_to_end()) {
        const auto commands = hand_.commands_of(done.ticks, ticks, tick_s, !sandbox_.looks_back());
        const std::int64_t before = state().tick;
        if (auto ticked = sandbox_.tick(commands); !ticked) {
            hand_.drop();  // else it would be refused in every tick
            done.told = ticked.error();
        }
        if (state().tick == before) break;
        ++done.ticks;
        judge();
        if (done.told && done.told->status == Failure::kBadAnswer) break;
    }
    if (done.ticks > 0) hand_.arrive(static_cast<double>(done.ticks) / ticks);
    return done;
}

// Scores a try at the moment at which it ends; one whose end was taken back is forgotten.
void LiveWorld::judge() {
    if (score_ && sandbox_.known_until() < score_->tick) score_.reset();
    const Session& session = sandbox_.session();
    if (score_ || session.try_ended_at() != session.state().tick) return;
    score_ = score_now(sandbox_.scenario(), session, sandbox_.commands_so_far());
    static_cast<void>(sandbox_.claim(score_->claim()));  // memory can always be written
}

Outcome<bool> LiveWorld::seek(std::int64_t tick, int most_ticks) {
    hand_.drop();
    int left = most_ticks;
    return sandbox_.go_toward(tick, [&] { return left-- > 0; });
}

Outcome<void> LiveWorld::take_over() {
    if (const auto verdict = sandbox_.verdict(); verdict && sandbox_.watches()) {
        if (verdict->parted)
            return unusable(fmt::format("This browser computes another slide: {}. It can be watched only",
                                        *verdict->parted));
        if (!verdict->comparable)
            return unusable(
                "This slide was recorded with another version of the physics, so it can be watched only");
    }
    score_.reset();
    auto taken = sandbox_.take_over(in_memory(name_));
    if (look_) sandbox_.follow_fronts(*std::exchange(look_, std::nullopt));
    fit_hand();
    return taken;
}

void LiveWorld::press(Modifiers with, glm::dvec2 at) {
    fit_hand();
    const sim::View world = sandbox_.session().view();
    const double bedrock = between(square_under(world.grid, at), world.bedrock);
    hand_.press(with, at, bedrock + world.datum, static_cast<double>(world.grid.dx));
    sandbox_.begin_action(std::string(sim::info_of(hand_.stroke()->deed().kind).name));
}

bool LiveWorld::would_act() {
    const bool acts = !sandbox_.looks_back() && hand_.would_act(static_cast<double>(state().params.tick_s));
    if (!acts) hand_.arrive(1);  // its way until now, and its end
    return acts;
}

Outcome<void> LiveWorld::set_brush(const Json& json) {
    Brush brush = hand_.brush();
    const auto wrong = [](const char* what) {
        return unusable(fmt::format("{} is not what this tool can be set to", what));
    };
    if (!json.is_object()) return wrong("that");
    if (const auto tool = json.find("tool"); tool != json.end()) {
        const ToolInfo* const info =
            tool->is_string() ? tool_called(tool->get_ref<const std::string&>()) : nullptr;
        if (!info) return wrong("tool");
        brush.tool = info->tool;
    }
    if (const auto radius = json.find("radius"); radius != json.end()) {
        const RadiusRange range = radius_range(state().grid);
        const auto number = number_in(*radius, range.least, range.most);
        if (!number) return wrong("radius");
        brush.radius = *number;
    }
    if (const auto numbers = json.find("numbers"); numbers != json.end()) {
        const auto rows = info_of(brush.tool).numbers;
        if (!numbers->is_array() || numbers->size() != rows.size()) return wrong("numbers");
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto number = number_in((*numbers)[i], rows[i].least, rows[i].most);
            if (!number) return wrong(rows[i].label);
            brush.own()[i] = *number;
        }
    }
    if (const auto standing = json.find("standing"); standing != json.end()) {
        if (!standing->is_boolean()) return wrong("standing");
        brush.standing = standing->get<bool>();
    }
    if (const auto slope = json.find("slope"); slope != json.end()) {
        if (!slope->is_array() || slope->size() != 2) return wrong("slope");
        const auto least = number_in((*slope)[0], sim::Command::kNoLeast, sim::Command::kNoMost),
                   most = number_in((*slope)[1], sim::Command::kNoLeast, sim::Command::kNoMost);
        if (!least || !most || *least > *most) return wrong("slope");
        brush.least_slope = *least, brush.most_slope = *most;
    }
    hand_.set(brush);
    fit_hand();
    return {};
}

Outcome<std::string> LiveWorld::undo() {
    hand_.drop();
    auto undone = sandbox_.undo();
    judge();
    return undone;
}

Outcome<std::string> LiveWorld::redo() {
    hand_.drop();
    return sandbox_.redo();
}

Json LiveWorld::facts() const {
    const Scenario& scenario = sandbox_.scenario();
    const RadiusRange radius = radius_range(scenario.grid);
    Json tools = Json::array();
    for (const ToolInfo& info : tool_infos()) {
        const auto allowed = [&](const Deed& deed) {
            return !scenario.goal || tool_of(*scenario.goal, deed.kind);
        };
        if (!is_offered(info, scenario, state())) continue;
        Json tool =
            json_of(info, scenario.goal ? tool_of(*scenario.goal, info.plain->kind) : nullptr, radius);
        for (const auto& [key, deed] : {std::pair("control", info.control), std::pair("shift", info.shift)})
            if (!allowed(*deed)) tool[key] = tool["plain"];
        tools.push_back(std::move(tool));
    }
    Json facts{{"tools", std::move(tools)},
               {"slope", {sim::Command::kNoLeast, sim::Command::kNoMost}},
               {"tick_s", shortest(scenario.params.tick_s)},
               {"brush", {{"radius", hand_.brush().radius}, {"standing", hand_.brush().standing}}},
               {"last", sandbox_.known_until()}};
    if (!scenario.goal) return facts;
    const Goal& goal = *scenario.goal;
    facts["goal"] = {{"say", goal.say}, {"learn", goal.learn}, {"medals", goal.medals}};
    return facts;
}

Json LiveWorld::status() const {
    const Session& session = sandbox_.session();
    Json status{{"tick", state().tick},
                {"known", sandbox_.known_until()},
                {"watches", sandbox_.watches()},
                {"looks_back", sandbox_.looks_back()},
                {"rests", sim::at_rest(state())},
                {"moving_m3", session.cubic_metres(state().ledger.rolling)},
                {"undo", sandbox_.actions()},
                {"redo", sandbox_.undone()},
                {"hash", fmt::format("{:016x}", session.state_line().hash)}};
    const auto& goal = sandbox_.scenario().goal;
    if (!goal) return status;
    const GoalUse use = sandbox_.goal_use();
    const auto begun = goal->events.empty() ? sandbox_.first_action() : std::optional<std::int64_t>(0);
    status["try_ticks"] = begun ? state().tick - *begun : -1;  // as the window's ghost counts them
    status["left"] = Json::array();
    for (const Goal::Tool& tool : goal->tools)
        if (const auto left = use.left(tool))
            status["left"].push_back({{"kind", sim::info_of(tool.kind).name},
                                      {"left", *left},
                                      {"unit", tool.total ? unit_of(tool.kind) : std::string_view()}});
    if (!score_ || state().tick < score_->tick) return status;
    Json card{{"points", score_->points},
              {"medal", medal_name(score_->medal)},
              {"won", score_->won()},
              {"verdict", verdict_of(*score_)},
              {"reason", reason_of(*goal, *score_)},
              {"advice", advice_after(*goal, *score_, session.view(), session.peaks(), session.slab())},
              {"tick", score_->tick},
              {"needs", Json::array()}};
    for (std::size_t i = 0; i < goal->needs.size(); ++i) {
        const NeedText need = text_of(goal->needs[i], score_->needs[i]);
        card["needs"].push_back({{"what", need.what},
                                 {"value", need.value},
                                 {"bound", need.bound},
                                 {"met", score_->needs[i].met}});
    }
    status["card"] = std::move(card);
    return status;
}

}  // namespace game
