// Flow: draws the advected textures, once per visible sample. Colour and small relief only; terrain.frag
// lights them.
in vec2 at;
in vec4 offset[3];
in vec4 mixture;
in float stretch;
in float lies;
layout(location = 0) out vec4 skin_albedo;  // alpha: 1, less half of the share of turf
layout(location = 1) out vec4 skin_relief;

const int kAdvected = 6;  // two phases for each of three latencies
const int kSheets = kAdvected + 1;

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

// Defined in paint_blended.glsl, paint_chosen.glsl, paint_stretch.glsl. `footprint`: size of a sample, tiles.
Paint paint(Sheet sheets[kSheets], float footprint);

// Sorts blocks from fines, and returns the share of turf, 0 to 1, that was torn off and rides on the flow, in turf.glsl;
// turf_none.glsl is for looks without a date.
float sorted(inout Paint seen, Sheet sheets[kSheets], float footprint);

void main() {
    mat2 pixel = mat2(dFdx(at), dFdy(at));
    float area = determinant(pixel);
    // A triangle seen edge-on has no area. Its few visible samples are drawn without relief.
    mat2 to_pixel = abs(area) > 1e-12 ? inverse(pixel) : mat2(0.0);
    Sheet sheets[kSheets];
    // Where the advected sheets are stretched, a sheet that lies still replaces them: fresh debris. The stretch is
    // interpolated between vertices, so no triangle is seen.
    bool everywhere = int(frame.flow.y) == FLOW_EVERYWHERE;
    float keep = everywhere ? 1.0 : 1.0 - smoothstep(STRETCH_KEPT, STRETCH_GONE, stretch), kept = 0.0;
    for (int s = 0; s < kAdvected; ++s) {
        int k = s / 2;
        vec2 place = at + (s % 2 == 0 ? offset[k].xy : offset[k].zw);
        float layer = max(0.0, 1.0 - abs(mixture.w - float(k)));
        float share = s % 2 == 0 ? 1.0 - mixture[k] : mixture[k];
        mat2 gradient = mat2(dFdx(place), dFdy(place)) * to_pixel;
        // A triangle at the border may have a sheet that is pressed together in it alone, to a pattern of dots.
        float pressed = max(dot(gradient[0], gradient[0]), dot(gradient[1], gradient[1]));
        float weight = keep * layer * share * (everywhere ? 1.0 : 1.0 - smoothstep(4.0, 9.0, pressed));
        sheets[s] = Sheet(place * frame.flow.x, gradient, weight);
        kept += weight;
    }
    // Rotated and moved, so that it does not resemble sheets that have hardly moved.
    sheets[kAdvected] = Sheet((at.yx + vec2(37.0, 11.0)) * frame.flow.x, mat2(0.0, 1.0, 1.0, 0.0), everywhere ? 0.0 : 1.0 - kept);
    float footprint = sqrt(length(pixel[0]) * length(pixel[1])) * frame.flow.x;
    Paint seen = paint(sheets, footprint);
    float turf = everywhere ? 0.0 : sorted(seen, sheets, footprint);
    skin_albedo = vec4(seen.albedo * frame.flow_tint.rgb, 1.0 - 0.5 * turf);
    skin_relief = vec4(seen.rise, seen.open, lies);
}
