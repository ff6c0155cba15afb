#pragma once

namespace game {

// Turns real seconds into ticks due. Speed changes how many ticks a frame runs, never the tick.
class TickClock {
  public:
    static constexpr double kSlowest = 1.0 / 8, kFastest = 16;

    bool paused() const { return paused_; }
    void pause(bool on) { paused_ = on; }
    bool runs_back() const { return back_; }  // the ticks due are to be taken back
    void run_back(bool on) { back_ = on; }
    void step_once() { ++steps_; }  // a tick at the next frame, instead of those that time owes

    double speed() const { return speed_; }
    void set_speed(double speed);  // to the nearest power of two within kSlowest … kFastest

    // Ticks that `elapsed_s` seconds owe. A frame that took longer than a quarter second, as when the machine
    // slept, owes no more than that.
    int ticks_due(double elapsed_s, double tick_s);

    // So many of the ticks due were more than the machine could do. They are forgotten, so that the world
    // slows instead of stalling.
    void ticks_undone(int count);

    // Speed as it was reached over the last half second or so; below speed() where the machine cannot keep
    // up.
    double reached_speed() const;
    bool behind() const;  // reaches less than nine tenths of its speed

  private:
    bool paused_ = false;
    bool back_ = false;
    int steps_ = 0;  // asked for one by one
    bool due_are_steps_ = false;
    double speed_ = 1;
    double owed_ = 0;               // ticks, less than one
    double wanted_ = 0, lost_ = 0;  // ticks of the last half second, fading
};

}  // namespace game
