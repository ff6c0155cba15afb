// Mountains of two materials that nothing has touched.
float lower_share(Place p, Detail d, vec2 source, float added) {
    // East and north at the source, which is mirrored.
    vec2 turned = sign(dFdx(source) * dFdx(p.at.xy) + dFdy(source) * dFdy(p.at.xy));
    vec2 there = source + turned * frayed(p, d) / frame.ground.x;
    float share = texture(first_cover, (there + 0.5) / vec2(frame.size.xy)).y;
    return patchy_share(d, clamp(share + added, 0.0, 1.0));
}
