// Conifers: what their vertex shaders share. One instance for each tree; render/trees_in_view.h has what it holds.
layout(location = 0) in vec4 foot;    // m; height, m
layout(location = 1) in vec4 axis;    // unit vector from foot to top; the tree's own number, 0 to 1
layout(location = 2) in vec4 look;    // sunlit 0 to 1; snow around it, m; share of the lower material there; half its width, m
layout(location = 3) in vec4 shadow;  // m, where the shadow of its top meets the ground; strength of the shadow, 0 to 1

// Colours of needles, and of snow on the branches if snow lies around the tree.
vec3 needles() {
    vec3 green = mix(vec3(0.014, 0.028, 0.017), vec3(0.029, 0.044, 0.022), axis.w);
    return mix(vec3(0.050, 0.042, 0.024), green, clamp(2.0 * axis.z, 0.0, 1.0));  // brown where it lies
}
vec4 snow() {
    vec3 lies = mix(frame.standing.rgb, frame.lower_standing.rgb, look.z);
    return vec4(lies, smoothstep(0.02, 0.30, look.y) * smoothstep(0.55, 0.75, lies.g));
}

// Light that white branches reflect toward the eye, and the air before them. `up`: 0 at the foot, 1 at the top.
void light_branches(vec3 normal, vec3 at, float up, out vec3 light, out vec3 air) {
    air = through_air(vec3(0.0), at);
    vec3 kept = through_air(vec3(1.0), at) - air;
    light = kept * lit(vec3(1.0), normal, look.x * (0.55 + 0.45 * up), 0.45 + 0.55 * up);
}
