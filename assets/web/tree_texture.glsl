// The trees that are drawn, as tree_buffer.glsl has them, in a texture: five texels each, so many in a row.
#define TREES_IN_A_ROW 256
#define TREE_FINEST TREE_FINEST_IN_PAGES
layout(binding = SLOT_UNITS) uniform sampler2D trees;

Tree tree_at(int number) {
    ivec2 at = ivec2(number % TREES_IN_A_ROW * 5, number / TREES_IN_A_ROW);
    return Tree(texelFetch(trees, at, 0), texelFetch(trees, at + ivec2(1, 0), 0), texelFetch(trees, at + ivec2(2, 0), 0),
                texelFetch(trees, at + ivec2(3, 0), 0), texelFetch(trees, at + ivec2(4, 0), 0));
}
