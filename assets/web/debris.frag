// Debris: colour and small relief of what flows and of deposits, in place of flow.frag, because a page does not know how
// far its texture was carried. Two sheets run down the slope with the flow, one while the other restarts; where it
// lies still, a third one lies.
layout(binding = SLOT_RELIEF) uniform sampler2D relief;
layout(binding = SLOT_LAYERS) uniform sampler2D layers;
uniform float seconds;

layout(location = 0) out vec4 skin_albedo;
layout(location = 1) out vec4 skin_relief;

const int kSheets = 3;
const float kRun = 1.6;                  // s, after which a sheet restarts
const float kHalfSpeed = 10.0;           // m/s, as in surface.glsl
const float kStill = 0.6, kRuns = 2.5;   // m/s, up to which a sheet lies still, and from which on sheets run

// One set of coordinates.
struct Sheet {
    vec2 place;     // tiles
    mat2 gradient;  // of the place, times the size of a tile
    float weight;   // those of all sheets add up to 1
};

struct Paint {
    vec3 albedo;
    vec2 rise;   // slope
    float open;  // share of the sky that small hollows leave
};

// In paint_blended.glsl. `footprint`: size of a sample, tiles.
Paint paint(Sheet sheets[kSheets], float footprint);

void main() {
    vec2 ndc = 2.0 * gl_FragCoord.xy / vec2(textureSize(scene_depth, 0)) - 1.0;
    vec3 ray = frame.ray_forward.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz;
    float forward = frame.ray_forward.w / max(scene_depth_at(ivec2(gl_FragCoord.xy)), 1e-6);
    vec2 at = frame.eye.xy + ray.xy * forward, texel = (at / frame.ground.x + 0.5) / vec2(frame.size.xy);
    vec2 slope = texture(relief, texel).yz;
    vec4 layer = texture(layers, texel);

    float speed = kHalfSpeed * layer.z / max(1.0 - layer.z, 0.02), runs = smoothstep(kStill, kRuns, speed);
    vec2 velocity = -speed * slope * inversesqrt(dot(slope, slope) + 1e-4);
    Sheet sheets[kSheets];
    for (int s = 0; s < 2; ++s) {
        float run = seconds / kRun + 0.5 * float(s), age = fract(run);
        vec2 anew = 61.8 * fract(floor(run) * vec2(0.7549, 0.5698) + 0.31 * float(s));  // m, where it began
        vec2 place = at - velocity * (kRun * (age - 0.5)) + anew;
        sheets[s] = Sheet(place * frame.flow.x, mat2(1.0), runs * (1.0 - abs(2.0 * age - 1.0)));
    }
    sheets[2] = Sheet((at.yx + vec2(37.0, 11.0)) * frame.flow.x, mat2(0.0, 1.0, 1.0, 0.0), 1.0 - runs);
    // At a low viewing angle a pixel covers a long strip: the mean of its length and width.
    float facing = dot(vec3(-slope, 1.0), ray) / sqrt((1.0 + dot(slope, slope)) * dot(ray, ray));
    float footprint = forward * frame.material.y * inversesqrt(clamp(-facing, 0.06, 1.0));
    Paint seen = paint(sheets, footprint * frame.flow.x);
    float deposit = MOST_CHANGE / 127.0 * (255.0 * layer.w - 128.0);
    skin_albedo = vec4(seen.albedo * frame.flow_tint.rgb, 1.0);
    skin_relief = vec4(seen.rise, seen.open, clamp(0.5 * deposit / frame.rolling.w, 0.0, 1.0));
}
