// Powder: a square for each puff, turned to the eye.
layout(location = 0) in vec4 at;    // its middle; radius, m
layout(location = 1) in vec4 look;  // opacity; light from the sun and from the sky; turn, 0 to 1
layout(location = 2) in vec4 life;  // age, s; age by life; share of the lower material

layout(binding = SLOT_DETAIL) uniform sampler2DArray detail_texture;

out vec2 place;             // in radii
flat out vec4 shown;        // opacity, light from sun and sky, 1 / radius
flat out vec4 turned;       // cosine and sine of its turn; where in the tile
flat out vec3 to_sun;       // in the axes of the view: right, up, back
flat out vec3 to_glow;      // to where the sky is brightest, in those axes, times by how much
flat out vec4 looks;        // softness of its edge; how much noise eats from it; level of the detail; share of the lower material
flat out float distance_m;  // along the view

void main() {
    bool right = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
    bool top = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
    place = vec2(right ? 1.0 : -1.0, top ? 1.0 : -1.0);
    vec3 axis_right = normalize(frame.ray_right.xyz), axis_up = normalize(frame.ray_up.xyz);
    distance_m = dot(at.xyz - frame.eye.xyz, frame.ray_forward.xyz);
    shown = vec4(look.x, look.y * sunlit(at.xyz + vec3(0.0, 0.0, 0.4 * at.w)), look.z, 1.0 / at.w);
    // It rolls, each at its own pace and way.
    float angle = 6.2832 * fract(7.31 * look.w) + (fract(29.3 * look.w) - 0.5) * life.x;
    turned = vec4(cos(angle), sin(angle), fract(look.w * 53.7), fract(look.w * 91.3));
    to_sun = vec3(dot(axis_right, frame.sun.xyz), dot(axis_up, frame.sun.xyz), -dot(frame.ray_forward.xyz, frame.sun.xyz));
    vec3 glow = vec3(frame.toward.w, frame.away.w, 0.0);
    to_glow = frame.zenith.w * vec3(dot(axis_right, glow), dot(axis_up, glow), -dot(frame.ray_forward.xyz, glow));
    float texels = POWDER_TILE * float(textureSize(detail_texture, 0).x) * length(frame.ray_up.xyz) * distance_m /
                   (at.w * 0.5 * powder.coarse.y);  // in a coarse pixel
    looks = vec4(mix(0.25, 1.0, smoothstep(0.0, 0.8, life.y)), mix(1.9, 2.6, life.y), max(log2(texels), 0.0), life.z);
    gl_Position = frame.clip_from_world * vec4(at.xyz + at.w * (place.x * axis_right + place.y * axis_up), 1.0);
}
