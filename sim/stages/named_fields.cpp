#include "sim/stages/named_fields.h"

#include <algorithm>

#include "sim/stages/scratch.h"
#include "sim/world/state.h"

namespace sim {

std::vector<NamedField> fields_of(const State& s) {
    std::vector<NamedField> fields{{"bedrock", &s.bedrock},       {"depth", &s.depth},
                                   {"rolling", &s.rolling},       {"velocity_x", &s.velocity_x},
                                   {"velocity_y", &s.velocity_y}, {"first_depth", &s.first_depth}};
    if (s.mixture) {
        fields.push_back({"mixture.rolling", &s.mixture->rolling});
        fields.push_back({"mixture.settled", &s.mixture->settled});
        fields.push_back({"mixture.untouched", &s.mixture->untouched});
    }
    return fields;
}

std::vector<NamedField> fields_of(const Scratch<float>& s) {
    std::vector<NamedField> fields;
    const auto add = [&](const std::string& of, const std::vector<NamedField>& named) {
        for (const NamedField& field : named)
            if (field.values->nx() > 0) fields.push_back({of + field.name, field.values});
    };
    for (auto* level : {&s.now, &s.then}) {
        const LevelFields<float>& f = *level;
        add(level == &s.now ? "now." : "then.", {{"depth", &f.depth},
                                                 {"rolling", &f.rolling},
                                                 {"drop_x", &f.drop_x},
                                                 {"drop_y", &f.drop_y},
                                                 {"bend_x", &f.curvature_x},
                                                 {"bend_y", &f.curvature_y},
                                                 {"fall", &f.slope_dx},
                                                 {"velocity_x", &f.velocity_x},
                                                 {"velocity_y", &f.velocity_y}});
    }
    for (auto* level : {&s.flow_now, &s.flow_then}) {
        const FlowFields<float>& f = *level;
        add(level == &s.flow_now ? "now." : "then.", {{"depth", &f.depth},
                                                      {"rolling", &f.rolling},
                                                      {"velocity_x", &f.velocity_x},
                                                      {"velocity_y", &f.velocity_y},
                                                      {"drop_x", &f.drop_x},
                                                      {"drop_y", &f.drop_y},
                                                      {"bend_x", &f.curvature_x},
                                                      {"bend_y", &f.curvature_y},
                                                      {"exchanged", &f.exchanged},
                                                      {"rolling_x", &f.rolling_x},
                                                      {"u_x", &f.u_x},
                                                      {"v_x", &f.v_x},
                                                      {"rolling_y", &f.rolling_y},
                                                      {"u_y", &f.u_y},
                                                      {"v_y", &f.v_y},
                                                      {"flux_x", &f.flux_x},
                                                      {"flux_y", &f.flux_y},
                                                      {"momentum_xu", &f.momentum_xu},
                                                      {"momentum_xv", &f.momentum_xv},
                                                      {"momentum_yu", &f.momentum_yu},
                                                      {"momentum_yv", &f.momentum_yv}});
    }
    add("", {{"given", &s.outflow},
             {"flux_x", &s.flux_x},
             {"flux_y", &s.flux_y},
             {"exchanged", &s.exchanged},
             {"share", &s.share}});
    if (s.mixing)
        add("mixing.", {{"depth", &s.mixing->depth},
                        {"rolling", &s.mixing->rolling},
                        {"lower_x", &s.mixing->lower_x},
                        {"lower_y", &s.mixing->lower_y}});
    return fields;
}

}  // namespace sim
