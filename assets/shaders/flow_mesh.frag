// Flow mesh as lines: all its edges, or only the front segments. An edge that merely ends at a front is not
// one.
layout(location = 0) uniform bool fronts_alone;

in float front;
out vec4 colour;

void main() {
    if (fronts_alone && front < 0.995) discard;
    colour = fronts_alone ? vec4(0.86, 0.10, 0.02, 1.0) : vec4(0.01, 0.02, 0.05, 0.55);
}
