// Powder, over the frame: smooth between coarse pixels, and hidden where the ground is nearer.
layout(binding = SLOT_POWDER_LIT) uniform sampler2D lit;
layout(binding = SLOT_POWDER_DISTANCE) uniform sampler2D distances;
layout(binding = SLOT_SCENE_DEPTH) uniform sampler2D scene_depth;

in vec2 ndc;
out vec4 colour;

void main() {
    vec2 coarse = ceil(vec2(textureSize(scene_depth, 0)) / float(powder.divisor.x)) - 0.5;  // its last texel
    vec2 at = min(gl_FragCoord.xy / float(powder.divisor.x), coarse) / vec2(textureSize(lit, 0));
    colour = textureLod(lit, at, 0.0);
    if (colour.a < 0.002) discard;
    float distance_m = textureLod(distances, at, 0.0).r / colour.a;
    float scene = frame.ray_forward.w / max(texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r, 1e-9);
    colour *= clamp((scene - distance_m) / (2.0 * powder.colour.w) + 1.6, 0.0, 1.0);
}
