#include "game/app/world_image.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "game/controls/key_map.h"
#include "game/words/words.h"
#include "render/gl/context.h"

namespace game {
namespace {

constexpr double kLateRing = 1.5;  // of the frame time; a ring that takes longer is drawn on a moving image
constexpr std::int64_t kMostPhotoPixels = std::int64_t{1} << 28;  // of 3 bytes, twice while it is written
constexpr double kStillAfter = 0.4;  // s without a change, until an image is finished

// Whether a camera that stood is suddenly elsewhere. It stands there: its first image may take longer than a frame, and need not
// be coarse.
bool is_cut(const render::Camera& from, const render::Camera& to) {
    constexpr double kJump = 0.5;  // of the distance to what it looks at
    return glm::distance(render::eye(to), render::eye(from)) > kJump * from.distance_m;
}

tl::unexpected<Failure> too_large(const char* what, int width, int height) {
    return machine_fails(fmt::format("{} for {}×{} pixels; take it smaller", what, width, height));
}

}  // namespace

WorldImage::WorldImage(Screen& screen, Notices& notices, render::Renderer renderer)
    : screen_(screen),
      notices_(notices),
      renderer_(std::move(renderer)),
      waits_for_gl_(render::is_software_renderer()) {}

void WorldImage::begin_world(std::uint64_t frame_memory) {
    bounds_ = {};
    frame_memory_ = frame_memory;
    drop_photo();
}

Outcome<void> WorldImage::load(const Scenario& scenario) {
    if (auto loaded = renderer_.load(scenario.look, scenario.lower.has_value()); !loaded)
        return machine_fails(loaded.error());
    return {};
}

void WorldImage::end_trial() {
    trial_.reset();
    bounds_ = {};
    best_ = {};
}

void WorldImage::draw(const Seen& seen, const Subject& subject, const Moment& moment) {
    now_s_ = moment.now_s;
    if (photo_) return draw_part(subject);
    tier_ = seen.display.tier;
    const bool another_camera = !(seen.camera == seen_.camera), changed = !(seen == seen_);
    const bool camera_moved = another_camera && (on_its_way_ || !is_cut(seen_.camera, seen.camera));
    on_its_way_ = another_camera;
    const bool ring_alone = changed && follows_ring(seen);
    if (changed) {
        seen_ = seen;
        still_since_ = now_s_;
        tell_bounds();
    }
    // A GPU returns before it has drawn, so time is measured only where it decides something.
    const bool timed = waits_for_gl_ || trial_ || tier_ != Tier::kFull;
    const double before = screen_.seconds();
    const auto since = [&] { return 1000 * (screen_.seconds() - before); };
    const auto finish = [&] {
        renderer_.show_on(screen_.framebuffer(), seen.screen.width, seen.screen.height);
        if (timed) renderer_.wait();
    };
    if (trial_) {
        draw_image(subject, image_for(seen.screen, trial_->image().scale, trial_->image().fine, bounds_));
        finish();
        finish_trial(since());
    } else if (ring_alone) {
        draw_image(subject, drawn_);
        finish();
        ring_in_time_ = since() <= kLateRing * seen.display.frame_ms;
    } else if (changed) {
        draw_image(subject, moving_size(moment, camera_moved));
        finish();
        resolution_.drew(since(), rest_ms(moment));
    } else {
        // An image that stands still is the best one: full resolution, smooth edges, drawn once.
        if (now_s_ - still_since_ >= kStillAfter && !(best_size() == drawn_)) {
            draw_image(subject, best_size());
            resolution_.drew_another();
        } else if (screen_.device_fault() == DeviceFault::kLost) {
            fail_lost();
        }
        finish();
    }
}

// Whether a finished image stays, because only the ring has moved on it, of which little is drawn anew.
bool WorldImage::follows_ring(const Seen& seen) {
    Seen as_before = seen;
    as_before.marks.ring = seen_.marks.ring, as_before.marks.outline = seen_.marks.outline;
    if (!(as_before == seen_)) ring_in_time_ = true;  // it may be smaller in another view
    const auto shows_hand = [](const render::Marks& marks) { return marks.ring || marks.outline; };
    return as_before == seen_ && ring_in_time_ && shows_hand(seen.marks) && shows_hand(seen_.marks) &&
           best_size() == drawn_;
}

// What the frame takes beside drawing the world; of what follows that, as in the last frame.
double WorldImage::rest_ms(const Moment& moment) const {
    const auto ms = [](const FrameTime& of, Stage stage) {
        return static_cast<double>(of.stage_ms[stage_index(stage)]);
    };
    double rest = ms(moment.frame, Stage::kInput) + ms(moment.frame, Stage::kSolve);
    if (moment.before.size() == 0) return rest;
    const FrameTime& last = moment.before[moment.before.size() - 1];
    rest += ms(last, Stage::kPanels);
    // A short frame waits for the monitor there, and one on a GPU always may.
    constexpr float kNoWait = 20;
    if (waits_for_gl_ && last.frame_ms > kNoWait) rest += ms(last, Stage::kPresent);
    return rest;
}

// Of an image while something moves.
ImageSize WorldImage::moving_size(const Moment& moment, bool camera_moved) {
    const TierInfo& tier = info_of(tier_);
    const ScreenSize& size = seen_.screen;
    if (tier_ == Tier::kFull) return image_for(size, 1, tier.fine, bounds_);
    const Display& display = seen_.display;
    const double scale = resolution_.scale_for(
        {.now_s = moment.now_s,
         .camera_moved = camera_moved,
         .screen_pixels = static_cast<double>(size.width) * size.height},
        {.target_ms = display.frame_ms,
         .least = std::min(least_scale(tier_, size, true), display.most_scale),
         .most = display.most_scale,
         .least_of_world = std::min(least_scale(tier_, size, false), display.most_scale)});
    ImageSize image = image_for(size, scale, tier.fine, bounds_);
    image.moving = camera_moved;  // else little is drawn anew, and that in full
    return image;
}

// The first frames show what this machine can draw in time.
void WorldImage::finish_trial(double draw_ms) {
    trial_->drew(draw_ms);
    const auto tier = trial_->result();
    if (!tier) return;
    trial_.reset();
    tier_ = *tier;
    resolution_.drew_another();
    constexpr std::array<const char*, kTiers.size()> kMeanings{
        message("this machine draws moving images in time at a lower resolution"),
        message("this machine draws moving images in time at full resolution or a little less"),
        message("this machine draws every image in time at full resolution with smooth edges")};
    tell(said("Quality: {}, because {}. Settings in the menu change it", tr(info_of(*tier).name),
              tr(kMeanings[static_cast<std::size_t>(*tier)])));
}

// Tells once per size of the screen what does not fit.
void WorldImage::tell_bounds() {
    const ScreenSize& size = seen_.screen;
    bounds_.longest_side = screen_.longest_side();
    if (waits_for_gl_) bounds_.most_bytes = std::min(bounds_.most_bytes, frame_memory_);
    const ImageSize best = best_size(), whole{size.width, size.height, true};
    if (best == std::exchange(best_, best) || best == whole) return;
    const bool by_memory = image_for(size, 1, true, {.longest_side = bounds_.longest_side}) == whole;
    const char* help = waits_for_gl_ && by_memory ? "; raise --max-memory" : "";
    if (best.width < size.width)
        warn(
            fmt::format("A window of {}×{} pixels is too large to draw here: its image has {}×{} pixels and "
                        "is stretched{}",
                        size.width, size.height, best.width, best.height, help));
    else
        warn(
            fmt::format("A window of {}×{} pixels is too large for two by two samples per pixel here: its "
                        "image has one{}",
                        size.width, size.height, help));
}

// Draws the image, or a smaller one if the driver cannot: a failure must leave neither a black nor an old
// image on the screen.
void WorldImage::draw_image(const Subject& subject, ImageSize image) {
    constexpr int kAttempts = 8;  // each takes half of the memory of the one before
    for (int attempt = 1;; ++attempt) {
        drawn_ = image;
        draw_once(subject, image);
        const DeviceFault fault = screen_.device_fault();
        if (fault == DeviceFault::kNone) return;
        if (fault == DeviceFault::kLost) return fail_lost();
        if (attempt == kAttempts)
            return fail(fmt::format("the graphics driver {} even for an image of {}×{} pixels",
                                    fault == DeviceFault::kOutOfMemory ? "has no memory" : "has no buffers",
                                    image.width, image.height));
        lower_bounds(fault);
        image = image_for(screen_.size(), static_cast<double>(image.width) / screen_.size().width, image.fine,
                          bounds_);
    }
}

void WorldImage::lower_bounds(DeviceFault fault) {
    bounds_.most_bytes = bytes_of(drawn_) / 2;
    const auto lower = below(tier_);
    if (lower) tier_ = seen_.display.tier = *lower;  // nothing else has changed
    warn(fmt::format("The graphics driver {} an image of {}×{} pixels{}: it is drawn with less{}",
                     fault == DeviceFault::kOutOfMemory ? "has no memory for" : "refuses", drawn_.width,
                     drawn_.height, drawn_.fine ? " with two by two samples" : "",
                     lower ? fmt::format(". Quality: {}", info_of(*lower).name) : ""));
    best_ = best_size();  // told
}

void WorldImage::fail_lost() {
    fail("the graphics driver was reset, and the window can draw no more");
}

void WorldImage::draw_once(const Subject& subject, const ImageSize& image,
                           const std::optional<render::WholeImage>& whole) {
    const Session& session = subject.sandbox.session();
    const Scenario& scenario = subject.sandbox.scenario();
    const Display& display = seen_.display;
    render::Look look = scenario.look;
    look.detail = display.detail;
    look.date = display.date;
    if (trial_) renderer_.forget();  // measured are images whose every pixel is new
    renderer_.set_quality(image.fine     ? render::Quality::kFine
                          : image.moving ? render::Quality::kMoving
                                         : render::Quality::kFast);
    renderer_.draw({.world = session.view(),
                    .camera = seen_.camera,
                    .light = display.light,
                    .look = look,
                    .marks = seen_.marks,
                    .flow = session.fronts(),
                    .width = image.width,
                    .height = image.height,
                    .whole = whole,
                    .lens = seen_.lens,
                    .first_depth = scenario.depth,
                    .undisturbed = session.undisturbed(),
                    .surroundings = &subject.surroundings,
                    .land = &subject.land,
                    .powder = session.powder(),
                    .powder_strength = display.powder,
                    .carried = session.carried(),
                    .woods = display.trees ? &subject.woods : nullptr,
                    .flow_so_far = session.flow_so_far(),
                    .structures = &session.structures(),
                    .wind = scenario.wind,
                    .seconds = session.seconds(),
                    .extent = subject.extent,
                    .probability = subject.probability});
}

// What was shown is drawn again afterwards, so that the next frame can continue from it.
Outcome<render::Picture> WorldImage::picture(const Subject& subject) {
    const Seen shown = seen_;
    const ImageSize size = drawn_, best = best_size();
    const bool is_shown =
        !shown.marks.ring && !shown.marks.outline && shown.marks.extent == 0 && size == best;
    seen_.marks.ring.reset(), seen_.marks.outline.reset();
    seen_.marks.extent = 0;
    if (!is_shown) draw_image(subject, best);
    if (failure_) return tl::unexpected(*failure_);
    render::Picture picture = renderer_.read_back();
    if (!is_shown) {
        seen_ = shown;
        draw_image(subject, size);
        resolution_.drew_another();
    }
    return picture;
}

Outcome<void> WorldImage::begin_photo(int times) {
    const ScreenSize screen = screen_.size();
    const std::int64_t pixels =
        static_cast<std::int64_t>(times) * times * screen.width * static_cast<std::int64_t>(screen.height);
    const int width = times * screen.width, height = times * screen.height;
    if (pixels > kMostPhotoPixels) return too_large("there is no room", width, height);
    const ImageBounds bounds{screen_.longest_side(), bounds_.most_bytes};
    const auto plan = PhotoParts::plan(screen, times, PhotoParts::rim_of(seen_.lens, height), bounds);
    if (!plan) return too_large("the graphics driver has no buffers", width, height);
    try {
        render::Picture picture{width, height,
                                std::vector<std::uint8_t>(static_cast<std::size_t>(3 * pixels))};
        photo_.emplace(Photo{*plan, std::move(picture), 0, render::KeptImage(screen.width, screen.height)});
    } catch (const std::bad_alloc&) {
        return too_large("there is no memory", width, height);
    }
    renderer_.show_on(photo_->shown.framebuffer(), screen.width, screen.height);
    return {};
}

std::optional<double> WorldImage::photo_progress() const {
    if (!photo_) return std::nullopt;
    return static_cast<double>(photo_->part) / photo_->plan.parts();
}

// The next image is drawn whatever it shows, because the last one is gone.
void WorldImage::drop_photo() {
    if (photo_) seen_ = {};
    photo_.reset();
    photo_result_.reset();
}

void WorldImage::draw_part(const Subject& subject) {
    draw_once(subject, photo_->plan.frame(), photo_->plan.place(photo_->part));
    const DeviceFault fault = screen_.device_fault();
    if (fault == DeviceFault::kLost) return fail_lost();
    const ScreenSize size = screen_.size();
    if (fault != DeviceFault::kNone) {
        photo_result_ =
            too_large("the graphics driver has no memory", photo_->picture.width, photo_->picture.height);
    } else {
        photo_->plan.put(photo_->part++, renderer_.read_back(), photo_->picture);
        if (photo_->part < photo_->plan.parts())
            return photo_->shown.show_on(screen_.framebuffer(), size.width, size.height);
        photo_result_ = std::move(photo_->picture);
    }
    photo_.reset();
    // What was shown is drawn again, so that the next frame can continue from it.
    draw_image(subject, drawn_);
    resolution_.drew_another();
    renderer_.show_on(screen_.framebuffer(), size.width, size.height);
}

}  // namespace game
