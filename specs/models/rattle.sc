// A plate in a slot that it exactly fills. At first it slides; from x = 0 on the law of motion presses it
// down, and it rattles between floor and ceiling while no time passes any more (Zeno): a run that goes round within
// one instant. It is a run (rule Run), and what would have to happen later does not happen on it.
model rattle

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

fixed   floor   = Cube scaled (10,10,1) at translate (0,0,-2)
fixed   ceiling = Cube scaled (10,10,1) at translate (0,0,2)
process plate   = Cube mass 1 velocity (1,0,0) at translate (-2,0,0) [nil]

motion plate = (1, 0, if x < 0 then 0 else -1)

check slides    : AF[2, 2] event bounce(plate, floor)                                 // expect: holds
check bounces   : AG (event bounce(plate, floor) => EX event bounce(plate, ceiling))  // expect: holds
check until_then : A[ vz(plate) = 0 U x(plate) >= 0 ]                                 // expect: holds
check goes_on   : EF x(plate) > 0                                                     // expect: violated
check always_on : AG EF event bounce(plate, floor)                                    // expect: holds
check later     : AG AF x(plate) > 0                                                  // expect: violated
check leaves    : event bounce(plate, floor) leads_to x(plate) > 11                   // expect: violated
