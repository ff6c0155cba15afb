// A tree, or a group of some: its picture, lit.
layout(binding = SLOT_TREE_PICTURES) uniform sampler2D pictures;  // render/textures/conifer_pictures.h

in vec4 place;
flat in vec4 dark;
flat in vec4 white;
flat in vec4 air;
out vec4 colour;

void main() {
    vec3 tree = texelFetch(pictures, ivec2(place.zw), int(air.w)).rgb;
    if (tree.b == 0.0 || abs(place.x) > 1.0 || place.y > 1.0) discard;  // the triangle is larger than the picture
    float foot = 1.0 - place.y;
    float left = tree.b * (1.0 - white.w * foot * foot) * (1.0 + dark.w * (2.0 * tree.r - 1.0));
    colour = vec4((dark.rgb + white.rgb * tree.g) * left + air.rgb, 0.0);  // alpha 0: edges_mark.frag leaves it out
}
