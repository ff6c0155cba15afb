// The shadow of a structure on the ground around it, or the light from its windows there.
layout(location = 0) in vec4 place;  // m; strength, 0 to 1
layout(location = 1) in vec4 foot;   // m, of what casts it; 1: light
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

out vec3 left;  // of the light, as a factor; more than 1 where lamps add to it

const vec3 kLamp = vec3(0.62, 0.27, 0.075);  // what reaches the ground beside a lit wall

void main() {
    vec3 at = vec3(place.xy, height_at(relief, place.xy) + 0.5);
    if (foot.w > 0.5) {
        vec3 light = frame.above.rgb + frame.lamp.rgb * max(frame.sun.z, 0.15);
        left = vec3(1.0) + kLamp * (place.w * frame.cloud.w) / light;
    } else {
        // Where a mountain shades the ground there is no sun to take.
        float strength = place.w * sunlit(foot.xyz + vec3(0.0, 0.0, 4.0)) * sunlit(at);
        left = mix(vec3(1.0), left_by_shadow(), strength);
    }
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
