#include "game/controls/tools.h"

#include <algorithm>

#include "game/scene/scenario.h"
#include "sim/world/thing_places.h"

namespace game {
namespace {

using sim::Command, sim::CommandKind;
using enum IconPart::Shape;

constexpr IconPart kPourIcon[] = {{kDot, {-0.35f, -0.75f, 0.16f}},
                                  {kDot, {0.3f, -0.6f, 0.16f}},
                                  {kDot, {-0.05f, -0.2f, 0.16f}},
                                  {kTriangle, {0, 0.1f, 0.95f, 0.9f, -0.95f, 0.9f}}};
constexpr IconPart kDigIcon[] = {{kLine, {-1, 0, -0.6f, 0}},
                                 {kLine, {-0.6f, 0, -0.4f, 0.8f}},
                                 {kLine, {-0.4f, 0.8f, 0.4f, 0.8f}},
                                 {kLine, {0.4f, 0.8f, 0.6f, 0}},
                                 {kLine, {0.6f, 0, 1, 0}},
                                 {kLine, {0, 0.4f, 0, -0.4f}},
                                 {kTriangle, {0, -0.95f, 0.4f, -0.35f, -0.4f, -0.35f}}};
constexpr IconPart kBlastIcon[] = {{kDot, {0, 0, 0.3f}}, {kRays, {0.5f, 1, 8}}};
constexpr IconPart kSettleIcon[] = {{kTriangle, {0, 0.1f, 0.4f, -0.5f, -0.4f, -0.5f}},
                                    {kLine, {0, -0.4f, 0, -1}},
                                    {kLine, {-0.9f, 0.4f, 0.9f, 0.4f}},
                                    {kLine, {-0.9f, 0.85f, 0.9f, 0.85f}}};
constexpr IconPart kRaiseIcon[] = {{kTriangle, {0, -1, 0.45f, -0.35f, -0.45f, -0.35f}},
                                   {kLine, {0, -0.4f, 0, 0.1f}},
                                   {kLine, {-1, 0.85f, -0.5f, 0.85f}},
                                   {kLine, {-0.5f, 0.85f, -0.25f, 0.35f}},
                                   {kLine, {-0.25f, 0.35f, 0.25f, 0.35f}},
                                   {kLine, {0.25f, 0.35f, 0.5f, 0.85f}},
                                   {kLine, {0.5f, 0.85f, 1, 0.85f}}};
constexpr IconPart kLowerIcon[] = {{kTriangle, {0, 0.1f, 0.45f, -0.55f, -0.45f, -0.55f}},
                                   {kLine, {0, -0.5f, 0, -1}},
                                   {kLine, {-1, 0.35f, -0.5f, 0.35f}},
                                   {kLine, {-0.5f, 0.35f, -0.25f, 0.85f}},
                                   {kLine, {-0.25f, 0.85f, 0.25f, 0.85f}},
                                   {kLine, {0.25f, 0.85f, 0.5f, 0.35f}},
                                   {kLine, {0.5f, 0.35f, 1, 0.35f}}};
constexpr IconPart kSmoothIcon[] = {{kLine, {-1, 0.3f, -0.5f, -0.25f}},
                                    {kLine, {-0.5f, -0.25f, 0, 0.1f}},
                                    {kLine, {0, 0.1f, 0.5f, -0.25f}},
                                    {kLine, {0.5f, -0.25f, 1, 0.3f}},
                                    {kLine, {-1, 0.8f, 1, 0.8f}}};
constexpr IconPart kLevelIcon[] = {
    {kBox, {-1, 0.3f, 1, 0.75f}}, {kLine, {-1, -0.15f, 1, -0.15f}}, {kDot, {0, -0.55f, 0.2f}}};
constexpr IconPart kWetIcon[] = {{kTriangle, {0, -1, 0.52f, 0.1f, -0.52f, 0.1f}}, {kDot, {0, 0.34f, 0.6f}}};
constexpr IconPart kDrainIcon[] = {{kTriangle, {0, -1, 0.3f, -0.4f, -0.3f, -0.4f}},
                                   {kDot, {0, -0.26f, 0.35f}},
                                   {kTriangle, {0, 1, 0.45f, 0.45f, -0.45f, 0.45f}}};
constexpr IconPart kPlantIcon[] = {{kTriangle, {0, -1, 0.55f, -0.1f, -0.55f, -0.1f}},
                                   {kTriangle, {0, -0.5f, 0.8f, 0.55f, -0.8f, 0.55f}},
                                   {kLine, {0, 0.5f, 0, 1}}};
constexpr IconPart kFellIcon[] = {{kTriangle, {-1, 0.35f, -0.1f, -0.05f, -0.1f, 0.75f}},
                                  {kLine, {-0.1f, 0.35f, 0.45f, 0.35f}},
                                  {kBox, {0.6f, 0.1f, 0.9f, 0.85f}},
                                  {kLine, {-1, 0.9f, 1, 0.9f}}};
constexpr IconPart kHouseIcon[] = {{kTriangle, {0, -0.95f, 1, 0, -1, 0}},
                                   {kBox, {-0.65f, 0.05f, 0.65f, 0.9f}}};
constexpr IconPart kRemoveIcon[] = {
    {kLine, {-0.7f, -0.7f, 0.7f, 0.7f}}, {kLine, {-0.7f, 0.7f, 0.7f, -0.7f}}, {kRing, {0, 0, 0.95f}}};
constexpr IconPart kNetIcon[] = {
    {kLine, {-0.8f, -0.8f, -0.8f, 0.9f}}, {kLine, {0, -0.8f, 0, 0.9f}}, {kLine, {0.8f, -0.8f, 0.8f, 0.9f}},
    {kLine, {-1, -0.5f, 1, -0.5f}},       {kLine, {-1, 0, 1, 0}},       {kLine, {-1, 0.5f, 1, 0.5f}}};
constexpr IconPart kRoadIcon[] = {{kLine, {-0.3f, -0.9f, -0.85f, 0.9f}},
                                  {kLine, {0.3f, -0.9f, 0.85f, 0.9f}},
                                  {kLine, {0, -0.7f, 0, -0.25f}},
                                  {kLine, {0, 0.15f, 0, 0.7f}}};
constexpr IconPart kLiftIcon[] = {{kLine, {-1, 0, 1, -0.9f}},
                                  {kLine, {0, -0.45f, 0, 0.2f}},
                                  {kLine, {-0.4f, 0.2f, 0.4f, 0.2f}},
                                  {kLine, {-0.4f, 0.2f, -0.4f, 0.75f}},
                                  {kLine, {-0.4f, 0.75f, 0.45f, 0.75f}}};

constexpr glm::vec3 kBlue{0.10f, 0.45f, 0.95f}, kOrange{0.95f, 0.45f, 0.05f}, kRed{0.90f, 0.08f, 0.10f},
    kLime{0.35f, 0.75f, 0.20f}, kEarth{0.75f, 0.42f, 0.12f}, kPit{0.55f, 0.20f, 0.60f},
    kSand{0.85f, 0.70f, 0.25f}, kForest{0.04f, 0.55f, 0.12f}, kWhite{0.90f, 0.90f, 0.85f},
    kCyan{0.05f, 0.55f, 0.75f};

constexpr Deed kPourDeed{CommandKind::kPour,       "Pour", "pour material", Acts::kAllTheTime,
                         Amount::kVolumePerSecond, kBlue,  kPourIcon};
constexpr Deed kDigDeed{CommandKind::kDig,  "Dig",   "dig",   Acts::kAllTheTime,
                        Amount::kPerSecond, kOrange, kDigIcon};
constexpr Deed kBlastDeed{CommandKind::kBlast, "Blast",         "blast the ground loose",
                          Acts::kByDistance,   Amount::kAsItIs, kRed,
                          kBlastIcon};
constexpr Deed kSettleDeed{CommandKind::kSettle, "Settle", "deposit the flow", Acts::kByDistance,
                           Amount::kAsItIs,      kLime,    kSettleIcon};
constexpr Deed kRaiseDeed{CommandKind::kSculpt, "Raise", "raise the ground", Acts::kAllTheTime,
                          Amount::kPerTick,     kEarth,  kRaiseIcon};
constexpr Deed kLowerDeed{CommandKind::kSculpt,  "Lower", "lower the ground", Acts::kAllTheTime,
                          Amount::kTakenPerTick, kPit,    kLowerIcon};
constexpr Deed kSmoothDeed{CommandKind::kSmooth, "Smooth", "smooth the ground", Acts::kAllTheTime,
                           Amount::kPerTick,     kSand,    kSmoothIcon};
constexpr Deed kLevelDeed{
    CommandKind::kLevel, "Level",          "level the ground at the height where you begin",
    Acts::kAllTheTime,   Amount::kPerTick, kSand,
    kLevelIcon};
constexpr Deed kWetDeed{CommandKind::kWet,  "Water", "wet the soil", Acts::kAllTheTime,
                        Amount::kPerSecond, kCyan,   kWetIcon};
constexpr Deed kDrainDeed{CommandKind::kDrain, "Drain", "drain the soil", Acts::kAllTheTime,
                          Amount::kPerSecond,  kOrange, kDrainIcon};
constexpr Deed kPlantDeed{CommandKind::kPlant, "Plant", "plant a forest", Acts::kByDistance,
                          Amount::kAsItIs,     kForest, kPlantIcon};
constexpr Deed kFellDeed{CommandKind::kFell, "Fell",  "fell the forest", Acts::kByDistance,
                         Amount::kAsItIs,    kOrange, kFellIcon};
constexpr Deed kHouseDeed{CommandKind::kHouse, "House",         "place a house, and drag to turn it",
                          Acts::kAndTurns,     Amount::kAsItIs, kWhite,
                          kHouseIcon};
constexpr Deed kNetDeed{
    CommandKind::kNet, "Net", "draw a row of snow nets", Acts::kByPieces, Amount::kAsItIs, kWhite, kNetIcon};
constexpr Deed kRoadDeed{CommandKind::kRoad, "Road", "draw a road", Acts::kByPieces,
                         Amount::kAsItIs,    kWhite, kRoadIcon};
constexpr Deed kLiftDeed{CommandKind::kLift, "Lift",          "draw a chairlift from its valley station",
                         Acts::kAtRelease,   Amount::kAsItIs, kWhite,
                         kLiftIcon};
constexpr Deed kRemoveDeed{CommandKind::kRemove, "Remove",        "remove what reaches into the ring",
                           Acts::kAtPress,       Amount::kAsItIs, kOrange,
                           kRemoveIcon};

constexpr ToolNumber kFlowRate[] = {
    {"Strength", "Rate %.2f m/s", "Depth added or removed per second.", &Command::rate, 0.05, 20, 2}};
constexpr ToolNumber kBlastDepth[] = {
    {"Strength", "Depth %.2f m", "Depth of ground that a blast releases.", &Command::depth, 0.05, 20, 1}};
constexpr ToolNumber kEarthRate[] = {
    {"Strength", "Rate %.2f m/s", "Greatest change of height per second.", &Command::rise, 0.05, 20, 2}};
// Soil 2.5 m deep holds 1 m of water (n d): 10 s of the most, some 13 s of the usual.
constexpr ToolNumber kWaterRate[] = {{"Strength", "Rate %.0f mm/s",
                                      "Depth of water per second. Soil 2.5 m deep holds 1000 mm.",
                                      &Command::rate, 0.005, sim::kMostRain, 0.08, 1000}};
constexpr ToolNumber kForestNumbers[] = {
    {"Strength", "%.0f stems/ha", "Stems per hectare; from 400 on a forest holds all of the snow.",
     &Command::stems, 25, 2000, sim::usual_of(CommandKind::kPlant, &Command::stems)},
    {"Diameter", "Stem %.2f m", "Diameter of a stem.", &Command::diameter, 0.1, 0.6,
     sim::usual_of(CommandKind::kPlant, &Command::diameter)},
    {"Height", "Height %.0f m", "Height of a tree.", &Command::height, 5, 35,
     sim::usual_of(CommandKind::kPlant, &Command::height)}};
constexpr ToolNumber kHouseNumbers[] = {
    {"Strength", "Strength %.0f kPa", "Load that destroys it: glass 1, wood 5, brick 10, concrete 30.",
     &Command::strength, 1, 100, sim::usual_of(CommandKind::kHouse, &Command::strength)},
    {"Length", "Length %.0f m", "Length along its front's direction.", &Command::length, 3, 100,
     sim::usual_of(CommandKind::kHouse, &Command::length)},
    {"Width", "Width %.0f m", "Width across it. From two cells on, a flow must go round it.", &Command::width,
     3, 100, sim::usual_of(CommandKind::kHouse, &Command::width)},
    {"Height", "Height %.0f m", "Height of its roof.", &Command::height, 2, 30,
     sim::usual_of(CommandKind::kHouse, &Command::height)}};
constexpr ToolNumber kNetNumbers[] = {
    {"Strength", "Strength %.0f kPa", "Load that destroys a piece of one cell.", &Command::strength, 1, 100,
     sim::usual_of(CommandKind::kNet, &Command::strength)},
    {"Height", "Height %.1f m", "Height of the nets, and the depth of snow that they hold.", &Command::height,
     2, 6, sim::usual_of(CommandKind::kNet, &Command::height)}};
constexpr ToolNumber kRoadNumbers[] = {{"Width", "Width %.0f m", "Width of the road.", &Command::width, 2, 30,
                                        sim::usual_of(CommandKind::kRoad, &Command::width)}};

constexpr std::array<ToolInfo, kTools> kInfos{{
    {Tool::kPour, ToolGroup::kSnow, key('1'),
     "Hold the left button on the terrain to add material; with Ctrl, to remove it.", &kPourDeed, &kDigDeed,
     &kPourDeed, kFlowRate},
    {Tool::kDig, ToolGroup::kSnow, key('2'),
     "Hold the left button on the terrain to remove material; with Ctrl, to add it.", &kDigDeed, &kPourDeed,
     &kDigDeed, kFlowRate},
    {Tool::kBlast, ToolGroup::kSnow, key('3'),
     "Click on the terrain to release the ground; with Ctrl, to deposit the flow.", &kBlastDeed, &kSettleDeed,
     &kBlastDeed, kBlastDepth},
    {Tool::kSculpt, ToolGroup::kGround, key('4'),
     "Hold the left button to raise the ground; with Ctrl, to lower it; with Shift, to smooth it.",
     &kRaiseDeed, &kLowerDeed, &kSmoothDeed, kEarthRate},
    {Tool::kSmooth, ToolGroup::kGround, key('5'), "Hold the left button to smooth the ground.", &kSmoothDeed,
     &kSmoothDeed, &kSmoothDeed, kEarthRate},
    {Tool::kLevel, ToolGroup::kGround, key('6'),
     "Hold the left button to level the ground at the height where you begin; with Shift, to smooth it.",
     &kLevelDeed, &kLevelDeed, &kSmoothDeed, kEarthRate},
    {Tool::kWater, ToolGroup::kGround, key('H'),
     "Hold the left button to wet the soil, which lets go when it is wet enough; with Ctrl, to drain it.",
     &kWetDeed, &kDrainDeed, &kWetDeed, kWaterRate},
    {Tool::kDrain, ToolGroup::kGround, key('J'),
     "Hold the left button to drain the soil, which holds better when it is dry; with Ctrl, to wet it.",
     &kDrainDeed, &kWetDeed, &kDrainDeed, kWaterRate},
    {Tool::kPlant, ToolGroup::kThings, key('7'),
     "Drag over the terrain to plant a forest; with Ctrl, to fell it.", &kPlantDeed, &kFellDeed, &kPlantDeed,
     kForestNumbers},
    {Tool::kHouse, ToolGroup::kThings, key('8'),
     "Press to place a house and drag to turn it; with Ctrl, removes what reaches into the ring.",
     &kHouseDeed, &kRemoveDeed, &kHouseDeed, kHouseNumbers},
    {Tool::kNet, ToolGroup::kThings, key('9'),
     "Drag along a slope to draw snow nets; with Ctrl, removes what reaches into the ring.", &kNetDeed,
     &kRemoveDeed, &kNetDeed, kNetNumbers},
    {Tool::kRoad, ToolGroup::kThings, key('R'),
     "Drag to draw a road; with Ctrl, removes what reaches into the ring.", &kRoadDeed, &kRemoveDeed,
     &kRoadDeed, kRoadNumbers},
    {Tool::kLift,
     ToolGroup::kThings,
     key('C'),
     "Drag from the valley station to the mountain station; with Ctrl, removes what reaches into the ring.",
     &kLiftDeed,
     &kRemoveDeed,
     &kLiftDeed,
     {}},
}};

constexpr bool in_order() {
    for (std::size_t i = 0; i < kTools; ++i)
        if (kInfos[i].tool != static_cast<Tool>(i) || kInfos[i].numbers.size() > kMostToolNumbers)
            return false;
    return true;
}
static_assert(in_order());

}  // namespace

std::span<const ToolInfo> tool_infos() {
    return kInfos;
}

const ToolInfo& info_of(Tool tool) {
    return kInfos[static_cast<std::size_t>(tool)];
}

const Deed& deed_of(Tool tool, Modifiers with) {
    const ToolInfo& info = info_of(tool);
    return with.control ? *info.control : with.shift ? *info.shift : *info.plain;
}

bool is_offered(const ToolInfo& info, const Scenario& scenario, const sim::State& state) {
    if (scenario.goal && !tool_of(*scenario.goal, info.plain->kind)) return false;
    return (info.tool != Tool::kWater && info.tool != Tool::kDrain) || sim::takes_water(state);
}

bool takes(CommandKind kind, double Command::*member) {
    const auto numbers = sim::info_of(kind).numbers;
    return std::any_of(numbers.begin(), numbers.end(),
                       [&](const sim::CommandNumber& number) { return number.value == member; });
}

}  // namespace game
