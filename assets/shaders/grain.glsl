// Samples a flow texture at a sheet's position.
layout(binding = SLOT_GRAIN) uniform sampler2D grain;
layout(binding = SLOT_PAINT) uniform sampler2D paint_colours;

struct Grain {
    vec2 rise;     // slope, as the sheet lies
    float height;  // 0 to 1
};

float grain_level(float footprint) { return log2(footprint * float(textureSize(grain, 0).x)) - 0.4; }

Grain grain_at(Sheet sheet, float level) {
    vec3 t = textureLod(grain, sheet.place, level).xyz;
    // Slopes are covectors: they are rotated and stretched with the coordinates.
    return Grain(transpose(sheet.gradient) * ((t.xy * 255.0 - 128.0) * (STEEPEST_GRAIN / 127.0)), t.z);
}
