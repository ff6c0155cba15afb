// The place on the surface that a sample shows, from the depth of the scene.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

// It comes from the sample alone, so that it is the same whatever part of a frame is drawn.
Place find_place(float depth) {
    vec2 ndc = 2.0 * gl_FragCoord.xy / vec2(textureSize(scene_depth, 0)) - 1.0;
    vec3 ray = frame.ray_middle.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz;
    float forward = frame.ray_forward.w / depth;
    vec3 at = frame.eye.xyz + ray * forward;
    vec4 r = texture(relief, (at.xy / frame.ground.x + 0.5) / vec2(frame.size.xy));
    return place_at(at, ray, forward, r.yz, r.w);
}
