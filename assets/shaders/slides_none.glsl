// Where nothing rolls and nothing has changed since tick 0: what slides.glsl draws there, at half of its cost.
Skin left_by_slides(Skin skin, Skin grown, float turf, Slide slide, Detail d, float covered) {
    return blend(skin, grown, turf * covered);
}

Skin under_flow(Skin skin, Slide slide, Place p, Detail d, float covered, out float rolls) {
    rolls = 0.0;
    return skin;
}
