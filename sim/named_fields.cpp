#include "sim/named_fields.h"

#include <algorithm>

#include "sim/scratch.h"
#include "sim/world/state.h"

namespace sim {

std::vector<NamedField> fields_of(const State& s) {
    std::vector<NamedField> fields{{"bedrock", &s.bedrock},          {"depth", &s.depth},
                                   {"rolling", &s.rolling},          {"velocity_x", &s.velocity_x},
                                   {"velocity_y", &s.velocity_y},    {"first_depth", &s.first_depth},
                                   {"smooth_depth", &s.smooth_depth}};
    if (s.mixture) {
        fields.push_back({"mixture.rolling", &s.mixture->rolling});
        fields.push_back({"mixture.settled", &s.mixture->settled});
        fields.push_back({"mixture.untouched", &s.mixture->untouched});
    }
    if (s.things) fields.push_back({"water", &s.things->water});
    if (s.weather) {
        fields.push_back({"weather.base", &s.weather->base});
        fields.push_back({"weather.strength", &s.weather->strength});
        fields.push_back({"weather.water", &s.weather->water});
        fields.push_back({"weather.surface", &s.weather->surface});
        fields.push_back({"weather.undisturbed", &s.weather->undisturbed});
    }
    return fields;
}

std::vector<NamedField> fields_of(const Scratch<float>& s) {
    std::vector<NamedField> fields;
    const auto add = [&](FieldName name, const Field<float>& values) {
        fields.push_back({name.text(), &values});
    };
    std::visit([&](const auto& of_model) { each_field(add, of_model); }, s.fields);
    if (const auto& mixing = s.context.mixing) {
        add("mixing.depth", mixing->depth);
        add("mixing.rolling", mixing->rolling);
        add("mixing.lower_x", mixing->lower_x);
        add("mixing.lower_y", mixing->lower_y);
    }
    return fields;
}

}  // namespace sim
