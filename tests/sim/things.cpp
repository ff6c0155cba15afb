#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>
#include <gtest/gtest.h>
#include "tests/support/worlds.h"
namespace {
using sim::Command; using sim::CommandKind; using support::Ground; using support::Play;
double passes(double dx, double v, double wall, bool rule, double length, int seconds, double& fastest) {
    const int nx = static_cast<int>(1400/dx);
    Ground g({nx, 5, (float)dx});
    const double at = 400;
    g.set(g.rolling, [&](double x, double) { return x > at - 20 - length && x < at - 20 ? 2.0 : 0.0; });
    sim::Params p; p.model = sim::Model::kVoellmy; p.friction = 0; p.drag = 1e6f;
    p.borders = {sim::Border::kOpen, sim::Border::kOpen, sim::Border::kWall, sim::Border::kWall};
    Play play(g, p);
    sim::Things& t = sim::things_of(play.state);
    const int w = (int)std::lround(at/dx);
    for (int y=0;y<5;++y) for (int x=w; x<w+(int)(50/dx); ++x) { t.earth(x,y) = (float)wall; sim::set_bedrock(play.state,x,y);} 
    (void)rule;
    double total=0;
    for (int y=0;y<5;++y) for (int x=0;x<nx;++x) if (play.state.rolling(x,y)>0) play.state.velocity_x(x,y)=(float)v, total+=play.state.rolling(x,y);
    // force ground renewal through a step
    fastest=0; double gone=0;
    if(!rule) { play.ticks(1); t.wall_x.fill(0); t.wall_y.fill(0);} 
    for (int i=0;i<60*seconds;++i){ play.ticks(1); if (getenv("DBG") && rule && wall==8 && v==20 && i%6==0 && i<200) { std::printf("%d:", i); for(int x=w-6;x<w+5;++x) std::printf(" %.2f/%.1f", (double)play.state.rolling(x,2), (double)play.state.velocity_x(x,2)); std::printf("\n"); }
      for (int y=0;y<5;++y) for (int x=0;x<nx;++x) if(play.state.rolling(x,y)>.05) fastest=std::max(fastest,(double)std::hypot(play.state.velocity_x(x,y),play.state.velocity_y(x,y))); }
    for (int y=0;y<5;++y) for (int x=w; x<nx;++x) gone+=play.state.rolling(x,y);
    // what left to the east counts as passed
    return gone/total;
}
TEST(Walls, table) {
  for (double L : {100.0, 200.0}) for (double dx : {12.5, 5.0}) for (double v : {10.0, 20.0}) {
    std::printf("L %g dx %g v %g:", L, dx, v);
    for (double wall : {5.0, 8.0,10.0,15.0,20.0,40.0}) { double f0,f1; double a=passes(dx,v,wall,false,L,20,f0), b=passes(dx,v,wall,true,L,20,f1); std::printf("  %g: %.2f %.2f (%.0f %.0f)", wall,a,b,f0,f1);} 
    std::printf("\n");
  }
}
}
