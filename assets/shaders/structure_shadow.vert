// The shadow of a structure on the ground around it.
layout(location = 0) in vec4 place;  // m; strength, 0 to 1
layout(location = 1) in vec4 foot;   // m, of what casts it
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

flat out vec3 left;  // of the light, as a factor

void main() {
    float strength = place.w * sunlit(foot.xyz + vec3(0.0, 0.0, 4.0));
    left = mix(vec3(1.0), left_by_shadow(), strength);
    vec3 at = vec3(place.xy, height_at(relief, place.xy) + 0.5);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
