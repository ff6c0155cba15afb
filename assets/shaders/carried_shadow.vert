// The shadow of what a flow carries: a rectangle on the ground, from behind its foot to the shadow of its top.
layout(location = 0) in vec4 place;  // m in plan; place in the shadow, −1 to 1
layout(location = 1) in vec4 foot;   // m; strength, 0 to 1
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

out vec2 along;
flat out vec3 left;  // of the light, where the shadow is darkest
flat out float strength;

void main() {
    vec3 at = vec3(place.xy, height_at(relief, place.xy) + 0.12);
    along = place.zw;
    strength = foot.w;
    left = mix(vec3(0.62), left_by_shadow(), sunlit(foot.xyz));
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
