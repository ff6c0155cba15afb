// Structures: what people have built. render/structure_mesh.h has what a vertex holds.
layout(location = 0) in vec4 place;
layout(location = 1) in vec4 facing;
layout(location = 2) in vec4 face;
layout(location = 3) in vec4 rests;
layout(binding = SLOT_RELIEF) uniform sampler2D relief;

out vec3 at;
flat out vec3 normal;
flat out int material;
flat out vec2 numbers;  // of the structure, of the face; 0 to 1
out vec3 on_face;       // m across and up; light that reaches it

void main() {
    at = place.xyz;
    if (rests.w > 0.5) {
        float moved = height_at(relief, rests.xy) - rests.z;
        at.z += rests.w > 1.5 ? min(moved, 0.0) : moved;
    }
    normal = facing.xyz;
    material = int(place.w);
    numbers = vec2(facing.w, face.w);
    on_face = face.xyz;
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
