// Two walls close on a ball, each driven by a law that gives it the same velocity
// again after every impact. The ball flies to and fro between them, always faster,
// and the impacts come ever closer to the time at which the walls would meet it
// from both sides: no run passes that time, and no bound ever reaches it. Such a
// run is one like any other (rule Run); `scc check` tells what it saw of it.
model closing

timestep 10

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}

process west = Cube mass 1000 velocity (1,0,0)  at translate (-6,0,0) [nil]
process east = Cube mass 1000 velocity (-1,0,0) at translate (6,0,0)  [nil]
process ball = Cube mass 1    velocity (3,0,0)  [nil]

motion west = (1, 0, 0)
motion east = (-1, 0, 0)

check between : always x(west) < x(ball) and x(ball) < x(east) within 3   // expect: holds
check closes  : eventually x(east) - x(west) = 6 within 3                 // expect: holds
check beyond  : possibly x(west) >= -2 within 3                           // expect: violated
