// Powder, over the frame: smooth between coarse pixels, and hidden where the ground is nearer.
layout(binding = SLOT_POWDER_LIT) uniform sampler2D lit;
layout(binding = SLOT_POWDER_HIDDEN) uniform sampler2D hidden;

layout(location = 0, index = 0) out vec4 colour;
layout(location = 0, index = 1) out vec4 taken;  // of each colour of the frame

void main() {
    vec2 at = gl_FragCoord.xy * powder.coarse.z;
    vec4 by_depth = texelFetch(hidden, ivec2(at), 0);
    float scene = scene_depth_at(ivec2(gl_FragCoord.xy));
    float seen = clamp(by_depth.x - by_depth.y * scene, 0.0, 1.0);
    colour = seen * textureLod(lit, min(at * powder.lit.xy, powder.lit.zw), 0.0);
    // A shadow takes the light of the sun and leaves that of the sky, so that it is bluish on snow.
    taken = vec4(colour.aaa - seen * by_depth.z * powder.shadow.rgb, 0.0);
}
