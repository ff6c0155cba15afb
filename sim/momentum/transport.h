#pragma once

#include "sim/momentum/fields.h"
#include "sim/momentum/ground.h"
#include "sim/momentum/walls.h"

// Transport of the layer and its momentum through a face, second order if both are smooth (van Leer 1979,
// Hancock):
//
//     beyond   left | right   beyond      q = R, u, v;  σ = minmod slope of a vertex
//      x−2     x−1  |   x      x+1        q* = q − ½ Δt (v·∇q), for R also − ½ Δt R ∇·v: at half of the sub-step
//                                         q_l = q*_left + ½ σ_left,  q_r = q*_right − ½ σ_right
//
//     w = (R_l u_l + R_r u_r)/(R_l + R_r)      the joint velocity across the face
//     w > 0:  F = R_l w Δt/Δx                  carries (u_l, v_l)
//     w < 0:  the mirror image
//
// Levelling. Forces see the surface z = b + d + R over two cells; where it jumps between neighbours, as in a checkerboard, they
// see nothing. The share `levelling` of what an acoustic Riemann solver adds there is taken from the joint velocity:
//
//     w ← w − ½ √(g/h) cos θ J     J = z_r − z_l − ½ (σ_left + σ_right): at most z_r − z_l, and R of the higher side
//
// σ: slopes of z by monotonised central differences, so that J vanishes where z is smooth. Sub-steps longer than Δx/4√(g h) level
// as one of that length. What moves is levelled; what friction holds beside it only if z rises through the face by over ½ μ Δx.
// (If what is held always gave way, a layer at the foot of a steep wall would flow for ever toward a neighbour that hands all
// back. If it gave way from μ Δx on, a deposit would keep half as much again of its checkerboard.)
//
// Prediction makes it second order in time with one flux per face. It also takes the part of σ that would leave
// less momentum behind than a vertex keeps: what leaves is the part nearest to the face.
//
// The velocity turns with the ground. What crosses a face has velocity (u, v, B·v) in space, on the plane of the
// vertex where it comes from. It is projected onto the tangent plane of the vertex where it arrives, and rescaled
// to its speed along the slope. So no bend of the ground takes or gives energy.
//
// If the wanted fluxes out of a vertex exceed its layer, all are reduced by the same share. A vertex keeps four
// quanta, because rounding takes less than one at each face.

namespace sim::momentum {

// The gentler of both differences, halved.
template <class Number>
[[gnu::always_inline]] inline Number half_slope(const Number& back, const Number& ahead) {
    return Scalar<Number>(0.5) * minmod(back, ahead);
}

// Rows y = 0 … ny-1. Reads fed, driven_u, driven_v; writes half slopes and the values at half of the sub-step.
template <class Number, class S = Scalar<Number>>
auto reconstruct(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    struct Of {
        const S *south, *here, *north;
        S *mid, *to_x, *to_y;
        Number value(int i) const { return at<Number>(here, i); }
        Number x(int i) const {
            return half_slope<Number>(value(i) - at<Number>(here, i - 1), at<Number>(here, i + 1) - value(i));
        }
        Number y(int i) const {
            return half_slope<Number>(value(i) - at<Number>(south, i), at<Number>(north, i) - value(i));
        }
    };
    const auto of = [y](const Rows<S>& rows, Rows<S>& mid, Rows<S>& to_x, Rows<S>& to_y) {
        return Of{rows[y - 1], rows[y], rows[y + 1], mid[y], to_x[y], to_y[y]};
    };
    return
        [c = w.c, rolling = of(w.fed, to.mid_rolling, to.rolling_x, to.rolling_y),
         u = of(w.driven_u, to.mid_u, to.u_x, to.u_y), v = of(w.driven_v, to.mid_v, to.v_x, to.v_y)](int i) {
            const Number r = rolling.value(i);
            if (!any(r > S{0})) {
                for (const Of& each : {rolling, u, v})
                    store(Number(0), each.mid + i), store(Number(0), each.to_x + i),
                        store(Number(0), each.to_y + i);
                return;
            }
            const Number cross_x = c.courant * u.value(i), cross_y = c.courant * v.value(i);
            const auto predict = [&](const Of& each, const Number& half_x, const Number& half_y) {
                store(half_x, each.to_x + i), store(half_y, each.to_y + i);
                return each.value(i) - (cross_x * half_x + cross_y * half_y);
            };
            const Number u_x = u.x(i), v_y = v.y(i);
            store<Number>(predict(rolling, rolling.x(i), rolling.y(i)) - r * (c.courant * (u_x + v_y)),
                          rolling.mid + i);
            store<Number>(predict(u, u_x, u.y(i)), u.mid + i);
            store<Number>(predict(v, v.x(i), v_y), v.mid + i);
        };
}
// Beyond the border nothing rolls. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_reconstruct(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    for (S* row : {to.mid_rolling[y], to.mid_u[y], to.mid_v[y], to.rolling_x[y], to.u_x[y], to.v_x[y],
                   to.rolling_y[y], to.u_y[y], to.v_y[y]}) {
        if (w.is_ground(y))
            row[-1] = row[w.nx] = 0;
        else
            std::fill(row + x.first, row + x.last, S{0});
    }
}

template <class Number>
struct Velocity {
    Number u, v;  // m/s
};
template <class Number>
struct Plane {
    Number x, y, cosine;  // slope B, and cos θ
};

// Turns a velocity on the ground `from` onto the ground `to`. It keeps its speed along the slope.
template <class Number>
[[gnu::always_inline]] inline Velocity<Number> turned(const Velocity<Number>& velocity,
                                                      const Plane<Number>& from, const Plane<Number>& to) {
    using S = Scalar<Number>;
    const Number u = velocity.u, v = velocity.v;
    const Number rises = from.x * u + from.y * v;
    const Number off = (rises - (to.x * u + to.y * v)) * (to.cosine * to.cosine);
    const Number along_u = u + off * to.x, along_v = v + off * to.y;
    const Number risen = to.x * along_u + to.y * along_v;
    const Number had = (u * u + v * v) + rises * rises;
    const Number has = (along_u * along_u + along_v * along_v) + risen * risen;
    const Number scale = sqrt(had / max(has, Number(S(1e-30))));
    return {along_u * scale, along_v * scale};
}

// The values of a vertex pair at the face between them.
template <class Number>
struct Sides {
    Number left, right;
};
template <class Number>
[[gnu::always_inline]] inline Number of_side(const auto& is_left, const Sides<Number>& sides) {
    return select(is_left, sides.left, sides.right);
}

// A value on both sides of faces along x or y: of the vertices, or carried to the face.
template <class Number, class S = Scalar<Number>>
struct FaceRow {
    const S *left, *right;  // the same row, one vertex apart, or two rows
    Sides<Number> at_vertices(int i) const { return {at<Number>(left, i), at<Number>(right, i)}; }
    Sides<Number> at_face(const FaceRow& half, int i) const {
        return {at<Number>(left, i) + at<Number>(half.left, i),
                at<Number>(right, i) - at<Number>(half.right, i)};
    }
};

// What is read on both sides of a face in either direction.
template <class Number>
struct FaceLayers {
    FaceRow<Number> begun, rolling;        // R before transport, and at half of the sub-step
    FaceRow<Number> bedrock, lies, rolls;  // b, d and R before the sub-step
    FaceRow<Number> cosine;
};
template <class Number, class S = Scalar<Number>>
FaceLayers<Number> layers_at_faces(const StageRows<S>& w, const auto& row) {
    return {row(w.fed),      row(w.mid_rolling), row(w.bedrock),
            row(w.u0.depth), row(w.u0.rolling),  row(w.cosine)};
}

// Faces of one direction. `across` is the component of velocity through the face, `along` the other; slopes
// likewise.
template <class Number, bool has_things = false, class S = Scalar<Number>>
struct Faces {
    Constants<S> c;
    FaceLayers<Number> layers;
    FaceRow<Number> across, along;  // at half of the sub-step
    FaceRow<Number> rolling_half, across_half, along_half;
    FaceRow<Number> slope_across, slope_along, surface_half, driven_across, driven_along;
    S *flux, *leaving_across, *leaving_along, *turned_across, *turned_along;
    const S* wall;  // of a world with things: rise of bedrock at walls

    [[gnu::always_inline]] void operator()(int i) const {
        const Number none(0);
        const Sides<Number> had = layers.begun.at_vertices(i);
        if (!any(max(had.left, had.right) > S{0})) {  // true nearly everywhere
            store(none, flux + i);
            return;
        }
        const Sides<Number> r = layers.rolling.at_face(rolling_half, i), u = across.at_face(across_half, i),
                            v = along.at_face(along_half, i);
        // Prediction may leave R at a nearly empty face below 0; then w would no longer be a mean.
        const Number r_l = max(r.left, none), r_r = max(r.right, none);
        Number w = (r_l * u.left + r_r * u.right) / max(r_l + r_r, Number(S(1e-30)));
        if (c.levelling > S{0}) w -= levelling(i, r_l, r_r);
        const auto forth = w > S{0};
        const auto may = of_side<Number>(forth, had) > kThin<Number>;
        store(select(may, c.courant * select(forth, r_l, r_r) * w, none), flux + i);

        const Velocity<Number> leaves{of_side(forth, u), of_side(forth, v)};
        const Sides<Number> bx = slope_across.at_vertices(i), by = slope_along.at_vertices(i),
                            cos = layers.cosine.at_vertices(i);
        const Plane<Number> left{bx.left, by.left, cos.left}, right{bx.right, by.right, cos.right};
        const auto pick = [&](const Plane<Number>& a, const Plane<Number>& b) {
            return Plane<Number>{select(forth, a.x, b.x), select(forth, a.y, b.y),
                                 select(forth, a.cosine, b.cosine)};
        };
        const Velocity<Number> arrives = turned(leaves, pick(left, right), pick(right, left));
        store(leaves.u, leaving_across + i), store(leaves.v, leaving_along + i);
        if constexpr (has_things) {
            const Number rise = at<Number>(wall, i);
            if (any(abs(rise) > S{0})) return climb(i, rise, forth, leaves, arrives);
        }
        store(arrives.u, turned_across + i), store(arrives.v, turned_along + i);
    }

    // What is taken from w, m/s, between layers of these thicknesses at the face.
    [[gnu::always_inline]] Number levelling(int i, const Number& r_l, const Number& r_r) const {
        const Sides<Number> b = layers.bedrock.at_vertices(i), d = layers.lies.at_vertices(i),
                            r = layers.rolls.at_vertices(i);
        const Sides<Number> half = surface_half.at_vertices(i), cos = layers.cosine.at_vertices(i);
        const Number rises = ((b.right - b.left) + (d.right - d.left)) + (r.right - r.left);
        const Number none(0), least = max(min(rises, none), -r_l), most = min(max(rises, none), r_r);
        const Number jump = min(max(rises - (half.left + half.right), least), most);

        const Sides<Number> u = driven_across.at_vertices(i), v = driven_along.at_vertices(i);
        const Number left = max(abs(u.left), abs(v.left)), right = max(abs(u.right), abs(v.right));
        const Number gives = select(jump > S{0}, right, left);
        const auto acts = select(S(2) * abs(rises) > c.held_rise, max(left, right), gives) > S{0};
        const Number thick = max(S(0.5) * (r_l + r_r), Number(kThin<Number>));
        const Number per_wave = sqrt(S(kGravity) * (cos.left * cos.right) / thick);
        const Number per_step = S(0.25) / (c.courant * thick);
        return select(acts, c.levelling * min(per_wave, per_step) * jump, none);
    }

    // What is toward a wall passes by its head alone.
    [[gnu::always_inline]] void climb(int i, const Number& rise, const auto& forth,
                                      const Velocity<Number>& leaves, const Velocity<Number>& arrives) const {
        const Number none(0);
        const auto up_right = rise > S{0};
        const Sides<Number> d = layers.lies.at_vertices(i), r = layers.rolls.at_vertices(i);
        const Number stands_out =
            (abs(rise) + select(up_right, d.right - d.left, d.left - d.right)) - of_side<Number>(up_right, r);
        const Sides<Number> v = driven_across.at_vertices(i);
        const Number toward = select(up_right, v.left, -v.right);
        const auto climbs = abs(rise) > S{0} && stands_out > S{0} && select(forth, rise, -rise) > S{0};
        const Number share = share_over<Number>(max(stands_out, none), toward);
        store(select(climbs, at<Number>(flux, i) * share, at<Number>(flux, i)), flux + i);
        store(select(climbs, leaves.u * share, arrives.u), turned_across + i);
        store(select(climbs, leaves.v, arrives.v), turned_along + i);
    }
};

// Along x, faces y = 0 … ny. Reads b, d, R, and what find_ground(), drive() and reconstruct() wrote, of a world with things
// also walls; writes the wanted flux, and its velocity where it leaves and where it arrives.
template <class Number, bool has_things = false, class S = Scalar<Number>>
auto find_fluxes_x(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    const auto row = [y](const Rows<S>& rows) { return FaceRow<Number>{rows[y] - 1, rows[y]}; };
    return Faces<Number, has_things>{w.c,
                                     layers_at_faces<Number>(w, row),
                                     row(w.mid_u),
                                     row(w.mid_v),
                                     row(w.rolling_x),
                                     row(w.u_x),
                                     row(w.v_x),
                                     row(w.slope_x),
                                     row(w.slope_y),
                                     row(w.surface_x),
                                     row(w.driven_u),
                                     row(w.driven_v),
                                     to.flux_x[y],
                                     to.leaving_xu[y],
                                     to.leaving_xv[y],
                                     to.turned_xu[y],
                                     to.turned_xv[y],
                                     thing_row<has_things>(w.things.wall_x, y)};
}
// Along y.
template <class Number, bool has_things = false, class S = Scalar<Number>>
auto find_fluxes_y(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    const auto row = [y](const Rows<S>& rows) { return FaceRow<Number>{rows[y - 1], rows[y]}; };
    return Faces<Number, has_things>{w.c,
                                     layers_at_faces<Number>(w, row),
                                     row(w.mid_v),
                                     row(w.mid_u),
                                     row(w.rolling_y),
                                     row(w.v_y),
                                     row(w.u_y),
                                     row(w.slope_y),
                                     row(w.slope_x),
                                     row(w.surface_y),
                                     row(w.driven_v),
                                     row(w.driven_u),
                                     to.flux_y[y],
                                     to.leaving_yv[y],
                                     to.leaving_yu[y],
                                     to.turned_yv[y],
                                     to.turned_yu[y],
                                     thing_row<has_things>(w.things.wall_y, y)};
}
// Nothing passes a wall. Faces y = 0 … ny.
template <class Number, class S = Scalar<Number>>
void end_fluxes(const StageRows<S>& w, Fields<Rows<S>>& to, int y, Span x) {
    S* flux = to.flux_x[y];
    if (w.is_wall(kWest)) flux[0] = 0;
    if (w.is_wall(kEast)) flux[w.nx] = 0;
    if ((y == 0 && w.is_wall(kSouth)) || (y == w.ny && w.is_wall(kNorth)))
        std::fill(to.flux_y[y] + x.first, to.flux_y[y] + x.last, S{0});
}

// Rows y = 0 … ny-1. Reads fed, wanted fluxes; writes share. Sets `less` if a vertex must reduce its outflow.
template <class Number, class S = Scalar<Number>>
auto find_share(const StageRows<S>& w, Rows<S>& to, int y, bool* less = nullptr) {
    return [rolling = w.fed[y], flux_x = w.flux_x[y], south = w.flux_y[y], north = w.flux_y[y + 1],
            share = to[y], less](int i) {
        constexpr S kInHand = 4 * kGrain<Number>;
        constexpr S kLess = kHasQuanta<Number> ? S(1 - 1e-6) : S(1);  // for the rounding of the products
        const Number none(0);
        const Drops<Number> out = outward<Number>(flux_x, south, north, i);
        const Number wanted =
            (max(out.east, none) + max(out.west, none)) + (max(out.north, none) + max(out.south, none));
        const Number has = max(at<Number>(rolling, i) - kInHand, none);
        const auto too_much = wanted > has;
        if (!any(too_much)) {
            store(Number(1), share + i);
            return;
        }
        store<Number>(select(too_much, has * kLess / select(too_much, wanted, Number(1)), Number(1)),
                      share + i);
        if (less) *less = true;
    };
}
// Nothing leaves the halo. Rows y = -1 … ny.
template <class Number, class S = Scalar<Number>>
void end_share(const StageRows<S>& w, Rows<S>& to, int y, Span x) {
    if (w.is_ground(y))
        to[y][-1] = to[y][w.nx] = 0;
    else
        std::fill(to[y] + x.first, to[y] + x.last, S{0});
}
// Faces y = 0 … ny. Reads share; limits flux_x, flux_y to the layers of the vertices.
template <class Number, class S = Scalar<Number>>
auto share_fluxes(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [share = w.share[y], share_south = w.share[y - 1], flux_x = to.flux_x[y],
            flux_y = to.flux_y[y]](int i) {
        const Number here = at<Number>(share, i), in_x = at<Number>(flux_x, i), in_y = at<Number>(flux_y, i);
        store<Number>(in_x * select(in_x > S{0}, at<Number>(share, i - 1), here), flux_x + i);
        store<Number>(in_y * select(in_y > S{0}, at<Number>(share_south, i), here), flux_y + i);
    };
}
// Rounds the fluxes to whole quanta, so that both sides of a face transfer the same amount. Faces y = 0 … ny.
template <class Number, class S = Scalar<Number>>
auto quantise_fluxes(const StageRows<S>& w, Fields<Rows<S>>& to, int y) {
    return [c = w.c, flux_x = to.flux_x[y], flux_y = to.flux_y[y]](int i) {
        const auto book = [&](S* flux) {
            store(with_its_sign(at<Number>(flux, i),
                                [&](const Number& size) { return in_quanta(size, c.dither); }),
                  flux + i);
        };
        book(flux_x), book(flux_y);
    };
}

}  // namespace sim::momentum
