// Surface: computes the inputs of the drawing passes from the fields, one fragment per vertex.
layout(binding = SLOT_VELOCITY_X) uniform sampler2D speed;  // R32F, m/s, in plan
layout(binding = SLOT_OPENNESS) uniform sampler2D openness;

layout(location = 0) out vec4 relief;    // RGBA32F, for heights
layout(location = 1) out vec4 filtered;  // RGBA16F, the same for slopes and openness: it can be filtered everywhere
layout(location = 2) out vec4 layers;

void main() {
    ivec2 v = ivec2(gl_FragCoord.xy);
    float here = height(v);
    vec2 rise = is_ground(v) ? vec2(slope(v, ivec2(1, 0), here), slope(v, ivec2(0, 1), here)) : vec2(0);
    relief = vec4(here, rise, texelFetch(openness, v, 0).r);
    filtered = vec4(0.0, relief.yzw);
    layers = layers_at(v, rise, texelFetch(speed, v, 0).r);
}
