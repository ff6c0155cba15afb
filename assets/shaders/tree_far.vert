// A tree that is some pixels high: one triangle around its axis, turned to the eye, lit as if it were a cone.
noperspective out vec2 place;       // −1 to 1 across, 0 at the foot to 1 at the top
noperspective out vec3 light;
flat out vec3 air;
flat out vec4 green;  // needles; branches from foot to top
flat out vec4 white;  // snow; share of the branches that it covers
flat out float jagged; // how much of its outline shows, 0 to 1

void main() {
    place = gl_VertexID == 2 ? vec2(0.0, 1.0) : vec2(gl_VertexID == 0 ? -1.0 : 1.0, 0.0);
    vec3 to_eye = frame.eye.xyz - foot.xyz;
    vec3 across = cross(axis.xyz, to_eye);
    across *= inversesqrt(max(dot(across, across), 1e-6));
    vec3 front = cross(across, axis.xyz);
    vec3 at = foot.xyz + foot.w * place.y * axis.xyz + look.w * place.x * across;
    vec3 normal = normalize((0.75 * place.x) * across + 0.45 * front + 0.35 * axis.xyz + vec3(0.0, 0.0, 0.2));
    light_branches(normal, at, place.y, light, air);
    float branches = 6.0 + floor(4.0 * fract(7.3 * axis.w));
    float pixels = foot.w / (length(to_eye) * frame.material.y * frame.material.z);
    jagged = smoothstep(1.5, 4.0, pixels / branches);
    green = vec4(needles(), branches);
    white = snow();
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
