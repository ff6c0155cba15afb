// Bindings and constants shared by GLSL and C++: every shader begins with this file, and C++ includes it.

// Uniform blocks
#define SLOT_FRAME 0
#define SLOT_POWDER 1

// Texture units
#define SLOT_BEDROCK 0    // R32F: b, m above datum; one texel per vertex, as all fields
#define SLOT_DEPTH 1      // R32F: d, m
#define SLOT_ROLLING 2    // R32F: R, m
#define SLOT_VELOCITY_X 3 // R32F, m/s
#define SLOT_VELOCITY_Y 4 // R32F, m/s
#define SLOT_SITE 5       // R8UI: sim::Site
#define SLOT_RELIEF 6     // RGBA32F: height m above datum, slope along x, slope along y, openness
#define SLOT_LAYERS 7     // RGBA8: share of cover, share of rolling layer (half at the visible depth), speed, change of d since tick 0 (128: none, 127 steps to MOST_CHANGE); 0 to 1
#define SLOT_OPENNESS 8   // R16F: share of the sky that a vertex sees
#define SLOT_SUN_CEILING 9 // R32F: height below which the sun is hidden, in the sheared grid of render/mountain/sun_sweep.h
#define SLOT_DETAIL 10    // RGBA8 array: small-scale relief, one layer per kind
#define SLOT_SCENE_DEPTH 11 // D32F: reversed depth of the surface
#define SLOT_COLOUR 12    // RGBA16F: the frame in linear light
#define SLOT_MEASURE 13   // RG32F: overlay value times its weight, weight 0 to 1
#define SLOT_MIXTURE 14   // RG8: share of the lower material at the surface of the standing layer, in the rolling layer; for two materials
#define SLOT_GRAIN 15     // RGBA8: a flow's texture: slopes, height
#define SLOT_PAINT 16     // SRGB8: its colours; for a stochastic one a row, one per height
#define SLOT_SKIN_ALBEDO 17 // RGBA16F: colour of the flow, per sample; alpha 0: none
#define SLOT_SKIN_RELIEF 18 // RGBA16F: slopes that it adds, sky share of its hollows, amount of deposit (half at the visible depth)
#define SLOT_UNDISTURBED 19 // R32F: d where nothing slid, m
#define SLOT_SKY 20 // RGBA16F: the sky at a quarter of the resolution; a: what thin cloud leaves of lights behind it
#define SLOT_SURROUNDINGS 21 // R32F: rough heights around the block, m above datum
#define SLOT_PICTURE 22   // RGBA8: the frame as the screen shows it, not linear
#define SLOT_FIRST_COVER 23 // RG16F: the standing layer at tick 0, holes filled: depth, m; share of the lower material at its surface
#define SLOT_POWDER_REACH 24    // R32F: distance along the view to the farthest of what a coarse pixel shows, m
#define SLOT_POWDER_THICK 25    // RGBA16F: light from sun and from sky, distance, each times the opacity; opacity
#define SLOT_POWDER_SHADE 26    // RG32F: render::ShadeMap across the sun
#define SLOT_POWDER_LIT 27      // RGBA16F: colour times opacity, opacity
#define SLOT_POWDER_HIDDEN 28   // RGBA32F: how the depth of the scene hides the cloud; its shadow on the ground
#define SLOT_POWDER_LOWER 29    // R16F: share of the lower material times opacity
#define SLOT_EXTENT SLOT_PICTURE // R8, while the ground is shaded: FrameInput::extent
#define SLOT_PROBABILITY SLOT_PICTURE // R32F, while surfaces are computed: FrameInput::probability, %
#define SLOT_WATER SLOT_PICTURE // R32F, in its place: sim::Things::water, 0 to 1
#define SLOT_LAND SLOT_POWDER_LOWER // RGBA8, while ground is shaded: render/mountain/land.h
#define SLOT_TREE_PICTURES SLOT_PICTURE // RGB8, while trees are drawn: conifers.png and trees-in-leaf.png of assets/textures
#define SLOT_LENS_REACH SLOT_SKY // R16F, while a photo is taken: radii of blocks of pixels
#define SLOT_COARSE_DEPTH SLOT_SKY // D32F, while the ground of a moving frame is spread: depth of every second sample
#define SLOT_EARTH 30     // R32F: m that bedrock was raised by; below 0: lowered
#define SLOT_UNITS 31     // number of texture units

// Storage buffers; cut_vertex.glsl reads the first four
#define SLOT_MESH_POSITIONS 0    // vec2 of each vertex, m
#define SLOT_MESH_TRIANGLES 1    // of each triangle: its corners, and its edges from each corner to the next
#define SLOT_MESH_EDGES 2        // ivec2 of each edge: its vertices a and b
#define SLOT_CROSSINGS 3         // float of each edge: where a front crosses it, 0.01 to 0.99 from a to b; below 0: nowhere
#define SLOT_CHANGED_EDGES 4     // edges that are or were cut, with their crossings
#define SLOT_CHANGED_TRIANGLES 5 // triangles beside those
#define SLOT_CUT_INDICES 6       // three for each piece
#define SLOT_CUT_COUNT 7         // number of indices
// Reused while a flow is drawn, because an OpenGL may have only eight
#define SLOT_FLOW_OFFSETS 4      // six vec2 of each vertex: sim::front::TextureLayers::Offsets, m
#define SLOT_FLOW_MIX 5          // vec4 of each vertex: shares of the second phases, latency
#define SLOT_FLOW_VERTICES 6     // of each vertex: its index beside a front, -1: none; deposit, m; vertex whose texture is drawn; stretch
#define SLOT_FLOW_GRADIENTS 7    // six mat2 of each vertex beside a front
// Reused while surfaces are computed
#define SLOT_SURFACE_GROUPS 4    // groups of vertices, x + 65536 y
// Reused while trees are drawn
#define SLOT_TREES 4             // render::DrawnTree

// Image units
#define IMAGE_RELIEF 0
#define IMAGE_LAYERS 1
#define IMAGE_OPENNESS 2
#define IMAGE_MEASURE 3

// Values of sim::Site
#define SITE_DRAIN 1

// Values of render::Overlay
#define OVERLAY_SLOPE 1
#define OVERLAY_STANDING 2
#define OVERLAY_ROLLING 3
#define OVERLAY_SPEED 4
#define OVERLAY_STRETCH 5
#define OVERLAY_PRESSURE 6
#define OVERLAY_PROBABILITY 7
#define OVERLAY_WATER 8

// Where a flow's texture is drawn
#define FLOW_NOWHERE 0
#define FLOW_ROLLING 1     // where the rolling layer is visible
#define FLOW_EVERYWHERE 2

#define STEEPEST_GRAIN 2.0 // steepest slope that a flow texture can store
#define MOST_CHANGE 0.5    // m, change of the standing layer that can still be told from a greater one
#define STRETCH_KEPT 0.35  // stretch of a flow texture up to which it is drawn whole
#define STRETCH_GONE 0.7   // and from which it is not drawn

#define LENS_BLOCK 16 // pixels along the edge of a block

#define MOST_STOPS 8 // of a legend

// Pictures of trees, as render/textures/tree_pictures.h draws them: tiles in columns by tree and in rows by the height of
// the eye, of which here are the sines, and those at which the next row begins
#define TREE_TILE_WIDTH 128
#define TREE_TILE_HEIGHT 256
#define TREE_LEVELS 6
#define TREE_FINEST_IN_PAGES 1 // of these; a page does not carry the largest
#define TREE_ROWS 4
#define TREE_ROW_SINES 0.070, 0.407, 0.719, 0.940
#define TREE_ROW_LIMITS 0.242, 0.574, 0.848
#define TREE_COLUMNS 8 // of a file: conifers.png has the first ones, trees-in-leaf.png the others
#define TREE_SPRUCES 4 // the first columns, with ever more snow
#define TREE_COLUMN_BROKEN 4
#define TREE_COLUMN_LARCH 5
#define TREE_COLUMN_PINE 6
#define TREE_COLUMN_GROUP 7
#define TREE_COLUMN_GREEN_LARCH 8
#define TREE_COLUMN_BEECH 9 // two of them
#define TREE_COLUMN_BIRCH 11
#define TREE_COLUMN_BUSH 12
#define TREE_COLUMN_LEAVES 13 // a group of broad-leaved trees
#define TREE_COLUMN_BARE 14 // a broad-leaved tree without leaves
#define TREE_COLUMN_BARE_GROUP 15
#define TREE_SPARE 1.3  // half the width of a tile, in radii of the crown
#define TREE_ABOVE 1.02 // what is in a tile, in heights of the tree
#define TREE_SHADOW_WIDTH 1.2 // half the width of a shadow at the foot, in radii of the crown
#define TREE_BROKEN 0.03 // share of spruces whose top is broken off

// Values of render::TreeKind
#define TREE_SPRUCE 0
#define TREE_LARCH 1
#define TREE_PINE 2
#define TREE_BEECH 3
#define TREE_BIRCH 4
#define TREE_BUSH 5

// What structures are made of
#define BUILT_WOOD 0
#define BUILT_STONE 1
#define BUILT_ROOF 2
#define BUILT_SNOW 3
#define BUILT_WINDOW 4
#define BUILT_STEEL 5
#define BUILT_ROAD 6
#define BUILT_BANK 7 // snow beside a road
#define BUILT_DARK 8 // doors, and the inside of what is broken
#define BUILT_PLASTER 9
#define BUILT_TILE 10
#define BUILT_CONCRETE 11
#define BUILT_GLASS 12 // of walls, in a frame
#define BUILT_BRICK 13
#define ROAD_WIDEST 20.0 // m, of a road whose number of a structure is 1

#define POWDER_SHADOW 3.0 // mean radii of the puffs, from a cloud to the end of its shadow

// Distances from a brook's water that the land can tell, m: inside, outside
#define LAND_NEAR 4.0
#define LAND_FAR 28.0

// How people use ground, 0 to 255 in a texel of the land: not, as a field, or as follows. A field has a crop of LAND_CROPS and a
// direction of LAND_DIRECTIONS of half a turn, counterclockwise from east: LAND_FIELD + LAND_DIRECTIONS * crop + direction.
#define LAND_FIELD 1
#define LAND_DIRECTIONS 16
#define LAND_CROPS 15
#define LAND_GARDEN 252
#define LAND_VERGE 253
#define LAND_PATH 254

// Layers of the detail texture
#define DETAIL_SOFT 0
#define DETAIL_ROCK 1
#define DETAIL_CLUMPS 2
#define DETAIL_LAYERS 3

// Bits of a vertex index: x, y, and a flag for the base of the block
#define INDEX_X_MASK 0x7fff
#define INDEX_Y_SHIFT 15
#define INDEX_BASE 0x40000000

// Edge of a compute work group: square for one thread per vertex, a row for one thread per edge or triangle
#define GROUP_SQUARE 8
#define GROUP_ROW 32
