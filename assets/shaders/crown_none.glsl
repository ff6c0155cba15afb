// Where no slab broke off.
Crown crown_at(inout Smooth layer, Place p, Detail d) { return Crown(0.0, vec2(0.0), 0.0, 0.0, 0.0); }
Skin wall(Skin skin, Crown crown, vec3 lies, Detail d, inout Place p) { return skin; }
