// Two cubes swing between a wall and each other for ever, and are back every 8.
// `time` never comes back; it counts up to the greatest constant that a check
// compares it with, and for the checks that speak of it only, so that every
// verdict is a proof (rule AbsoluteTime). With `--no-reduce time` the
// exploration goes on until a bound stops it.
model metronome

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed west = Cube at translate (-6,0,0)
fixed east = Cube at translate (6,0,0)

process p = Cube mass 1 velocity (-1,0,0) at translate (-2,0,0) [nil]
process q = Cube mass 1 velocity (1,0,0)  at translate (2,0,0)  [nil]

check never : eventually x(p) = 0                                        // expect: violated
check beat  : AG AF touching(p, q)                                       // expect: holds
check first : always (time < 5 => not touching(p, q))                    // expect: holds
check late  : AG (time > 20 => AF touching(p, q))                        // expect: holds
check twice : AG (time >= 8 and time <= 9 => not event bounce(p, q))     // expect: holds
check pace  : possibly x(p) + time = 8                                   // expect: holds
