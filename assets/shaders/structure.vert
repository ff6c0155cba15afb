// Structures: what people have built. render/buildings/structure_mesh.h has what a vertex holds.
layout(location = 0) in vec4 place;
layout(location = 1) in vec4 facing;
layout(location = 2) in vec4 face;
layout(location = 3) in vec4 rests;
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

out vec2 ground;        // place in plan, m
out vec3 light;         // that white reflects toward the eye
out vec3 air;           // light of the air before it
flat out int material;
flat out vec2 numbers;  // of the structure, of the face; 0 to 1
out vec3 on_face;       // m across and up; size of a pixel, m
out float muddy;        // 0 to 1

void main() {
    vec3 at = place.xyz;
    muddy = 0.0;
    if (rests.w > 0.5) {
        float moved = height_at(relief, rests.xy) - rests.z;
        if (rests.w > 1.5) {
            at.z += min(moved, 0.0);
        } else {  // what is wrecked sinks into the deposit that buried it, and is muddy
            muddy = frame.season.w * smoothstep(0.0, 1.0, moved);
            at.z += moved - 0.45 * muddy;
        }
    }
    ground = at.xy;
    air = through_air(vec3(0.0), at);
    light = (through_air(vec3(1.0), at) - air) * lit(vec3(1.0), facing.xyz, sunlit(at + 1.5 * facing.xyz) * through_clouds(at.xy), face.z);
    material = int(place.w);
    numbers = vec2(facing.w, face.w);
    on_face = vec3(face.xy, length(at - frame.eye.xyz) * frame.material.y);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
