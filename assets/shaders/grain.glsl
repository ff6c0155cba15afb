// Samples a flow texture at a sheet's position.
layout(binding = SLOT_GRAIN) uniform sampler2D grain;
layout(binding = SLOT_PAINT) uniform sampler2D paint_colours;

struct Grain {
    vec2 rise;     // slope, as the sheet lies
    float height;  // 0 to 1
};

float grain_level(float footprint) { return log2(footprint * float(textureSize(grain, 0).x)) - 0.4; }

// How much a sheet's broad lumps stick out, −0.5 to 0.5: rafts of turf ride on these.
float raft_at(Sheet sheet, float level) {
    const mat2 kBroader = mat2(0.19, 0.07, -0.07, 0.19);  // lumps some five times as wide
    return textureLod(grain, kBroader * sheet.place, max(level - 2.3, 0.0)).z - 0.5;
}

Grain grain_at(Sheet sheet, float level) {
    vec3 t = textureLod(grain, sheet.place, level).xyz;
    // Slopes are covectors: they are rotated and stretched with the coordinates.
    return Grain(transpose(sheet.gradient) * ((t.xy * 255.0 - 128.0) * (STEEPEST_GRAIN / 127.0)), t.z);
}
