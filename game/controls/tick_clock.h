#pragma once

namespace game {

// Converts real time to ticks due. Speed changes the number of ticks per frame, never their length.
class TickClock {
  public:
    static constexpr double kSlowest = 1.0 / 8, kFastest = 16;

    bool paused() const { return paused_; }
    void pause(bool on) { paused_ = on; }
    bool runs_back() const { return back_; }  // the ticks due are to be rewound
    void run_back(bool on) { back_ = on; }
    void step_once() { ++steps_; }  // one tick in the next frame, instead of those due by time

    double speed() const { return speed_; }
    void set_speed(double speed);  // to the nearest power of two within kSlowest … kFastest
    // A factor of the speed, above 0, that the world asks for: 1 is usual.
    double pace() const { return pace_; }
    void set_pace(double pace) { pace_ = pace; }

    // Ticks due after `elapsed_s` seconds. At most 0.25 s count, so that no backlog builds up after a
    // suspend. While `tool_works`, they are due in a pause too.
    int ticks_due(double elapsed_s, double tick_s, bool tool_works = false);

    // Reports that `count` of the ticks due were not run. They are dropped, so that the simulation slows down
    // instead of stalling.
    void ticks_undone(int count);

    // Speed reached over about the last half second; below speed() × pace() if the computer cannot
    // keep up.
    double reached_speed() const;
    bool behind() const;  // reaches less than 90 % of that

  private:
    bool paused_ = false;
    bool back_ = false;
    int steps_ = 0;  // requested single steps
    bool due_are_steps_ = false;
    double speed_ = 1, pace_ = 1;
    double owed_ = 0;               // fraction of a tick
    double wanted_ = 0, lost_ = 0;  // ticks of the last half second, fading
};

}  // namespace game
