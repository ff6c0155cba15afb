// A piece of rope: a ribbon that is turned to the eye. Where it is thinner than a pixel, it is drawn as wide as that
// and lets what is behind it through.
layout(location = 0) in vec4 place;  // m; side, −1 or 1
layout(location = 1) in vec4 along;  // unit vector; half its width, m

const float kLeast = 0.6;  // pixels, half the width

out vec3 air;
flat out float opaque;

void main() {
    vec3 to_eye = frame.eye.xyz - place.xyz;
    vec3 across = cross(along.xyz, to_eye);
    across *= inversesqrt(max(dot(across, across), 1e-6));
    float pixel = length(to_eye) * frame.material.y * frame.material.z;
    float half_width = max(along.w, kLeast * pixel);
    opaque = pow(along.w / half_width, 0.7);  // the eye finds a line that is thinner than it can see
    vec3 at = place.xyz + place.w * half_width * across;
    air = through_air(vec3(0.012), at);
    gl_Position = frame.clip_from_world * vec4(at, 1.0);
}
