(* Models with parameters of which a range is known, whose answers were worked out by hand: for which values each
   check holds, exactly, and with which probability. *)

open Scc_exact
open By_hand

(* {1 Meetings} *)

let offsets ~range = Printf.sprintf "param y in [-%d, %d]\nparam z in [-%d, %d]\n" range range range range

let two ~one ~other =
  Printf.sprintf
    {|%s
behaviour P on Cube = <a, {%s}>. nil
behaviour Q on Cube = <~a, {%s}>. nil
process p = Cube mass 1 velocity (1,0,0) at translate (0,y,z) [P]
process q = Cube mass 1 at translate (12,0,0) [Q]
check meet : possibly touching(p, q)
check bind : possibly bound(p, q)
check bounce : possibly vx(q) = 1
|}
    (offsets ~range:5) one other

let y_within c = within [ 1; 0 ] c
let z_within c = within [ 0; 1 ] c
let square c = y_within (int c) @ z_within (int c)
let closed_square c = within_or_at [ 1; 0 ] (int c) @ within_or_at [ 0; 1 ] (int c)

let meetings =
  [
    case "faces meet" (two ~one:"right" ~other:"left")
      [
        holds "meet" [ closed_square 2 ] (q 4 25); holds "bind" [ square 2 ] (q 4 25); nowhere "bounce";
      ];
    (* p's edge is at the height z - 1, and q's face reaches from -1 to 1, its edges included *)
    case "an edge and a face" (two ~one:"only [b,c]" ~other:"left")
      [
        holds "bind" [ at_least_0 [ 0; 1 ] Rat.zero :: square 2 ] (q 2 25);
        holds "bounce" [ positive [ 0; -1 ] Rat.zero :: square 2 ] (q 2 25);
      ];
    (* p's vertex is at (y + 1, z - 1) *)
    case "a vertex and a face with its border" (two ~one:"only c" ~other:"left")
      [ holds "bind" [ [ at_least_0 [ -1; 0 ] Rat.zero; at_least_0 [ 0; 1 ] Rat.zero ] @ square 2 ] (q 1 25) ];
    case "a vertex and the inside of a face" (two ~one:"only c" ~other:"only left")
      [ holds "bind" [ [ positive [ -1; 0 ] Rat.zero; positive [ 0; 1 ] Rat.zero ] @ square 2 ] (q 1 25) ];
    (* the edge [b,c] of p against the edge [a,d] of q: they are one line where z = 0 *)
    case "two edges" (two ~one:"only [b,c]" ~other:"only [a,d]")
      [ holds "bind" [ is_0 [ 0; 1 ] Rat.zero :: y_within (int 2) ] Rat.zero ];
    case "crossing edges" (two ~one:"only [b,c]" ~other:"only [a,e]")
      (* [b,c] goes along y at the height z - 1, [a,e] along z at y = -1 *)
      [
        holds "bind"
          [
            [
              positive [ 1; 0 ] (int 2); positive [ -1; 0 ] Rat.zero; positive [ 0; 1 ] Rat.zero;
              positive [ 0; -1 ] (int 2);
            ];
          ]
          (q 1 25);
      ];
    case "an octahedron"
      {|shape Octahedron {
  vertices e (1,0,0) w (-1,0,0) n (0,1,0) s (0,-1,0) u (0,0,1) d (0,0,-1)
  faces enu [e,n,u] nwu [n,w,u] wsu [w,s,u] seu [s,e,u] ned [n,e,d] wnd [w,n,d] swd [s,w,d] esd [e,s,d]
}
param y in [-3, 3]
param z in [-3, 3]
process p = Octahedron mass 1 velocity (1,0,0) at translate (0,y,z) [nil]
process q = Cube mass 1 at translate (6,0,0) [nil]
check meets : possibly event bounce(p, q)
check stands : possibly (vx(p) = 0 and vy(p) = 0 and vz(p) = 0)
check up : possibly vz(p) > 0
|}
      (let diamond s t = positive [ s; t ] (int 3) in
       let all = [ diamond 1 1; diamond 1 (-1); diamond (-1) 1; diamond (-1) (-1) ] in
       [
         holds "meets" [ square 2 @ all ] (q 7 18);
         holds "stands" [ closed_square 1 ] (q 1 9);
         holds "up" [ (positive [ 0; 1 ] (int (-1)) :: square 2) @ all ] (q 1 12);
       ]);
    case "moved and stretched"
      {|param x in [-8, 8]
process p = Cube mass 1 velocity (1,0,0) at translate (0, x/2 + 1, 0) [nil]
process q = Cube mass 1 at translate (6,0,0) [nil]
check meet : possibly event bounce(p, q)
|}
      [ holds "meet" [ [ positive [ 1 ] (int 6); positive [ -1 ] (int 2) ] ] (q 1 2) ];
    case "moved against each other"
      {|param x in [-2, 2]
process p = Cube mass 1 velocity (1,0,0) at translate (0, x, 0) [nil]
process q = Cube mass 1 at translate (6, -x, 0) [nil]
check meet : possibly event bounce(p, q)
|}
      [ holds "meet" [ within [ 1 ] Rat.one ] (q 1 2) ];
    case "an open range"
      {|param x in (-2, 2)
process p = Cube mass 1 velocity (1,0,0) at translate (0, x, 0) [nil]
process q = Cube mass 1 at translate (6, 0, 0) [nil]
check meet : possibly event bounce(p, q)
check never : always not event bounce(p, q)
|}
      [ everywhere "meet"; nowhere "never" ];
    case "along a diagonal"
      {|param x in [-1, 1]
param y in [-1, 1]
param z in [-1, 1]
process p = Cube mass 1 velocity (1,1,1) at translate (x,y,z) [nil]
process q = Cube mass 1 at translate (6,6,6) [nil]
check x_only : possibly (vx(q) = 1 and vy(q) = 0 and vz(q) = 0)
check edge   : possibly (vx(q) > 0 and vy(q) > 0 and vz(q) = 0)
check corner : possibly (vx(q) > 0 and vy(q) > 0 and vz(q) > 0)
|}
      [
        (* the plane that is entered last is that of the least coordinate *)
        holds "x_only" [ [ positive [ -1; 1; 0 ] Rat.zero; positive [ -1; 0; 1 ] Rat.zero ] ] (q 1 3);
        holds "edge" [ [ is_0 [ 1; -1; 0 ] Rat.zero; positive [ -1; 0; 1 ] Rat.zero ] ] Rat.zero;
        holds "corner" [ [ is_0 [ 1; -1; 0 ] Rat.zero; is_0 [ 1; 0; -1 ] Rat.zero ] ] Rat.zero;
      ];
    case "a compound"
      {|compound Plate {
  part low : Cube mass 1
  part high : Cube mass 1 at translate (0,2,0)
  glue low.back ~ high.front
}
param y in [-6, 6]
behaviour P on Cube = <a, {right}>. nil
behaviour Q on Plate = <~a, {high.left}>. nil
process p = Cube mass 1 velocity (1,0,0) at translate (0,y,0) [P]
process q = Plate at translate (8,0,0) [Q]
check meet : possibly touching(p, q)
check hits : possibly (event bounce(p, q) or bound(p, q))
check bind : possibly bound(p, q)
|}
      [
        holds "meet" [ [ at_least_0 [ 1 ] (int 2); at_least_0 [ -1 ] (int 4) ] ] (q 1 2);
        holds "hits" [ [ positive [ 1 ] (int 2); positive [ -1 ] (int 4) ] ] (q 1 2);
        (* at 0 the edges of p.right and of high.left touch, where p collides with the lower part *)
        holds "bind" [ from_to ~low:Rat.zero ~high:(int 4) ] (q 1 3);
      ];
    case "what is absorbed"
      {|param y in [-4, 4]
process p = Cube mass 1 velocity (1,0,0) at translate (0,y,0) [nil]
fixed drain = Cube absorb at translate (6,0,0)
check gone : possibly gone(p)
|}
      [ holds "gone" [ within [ 1 ] (int 2) ] (q 1 2) ];
  ]

(* {1 Time} *)

let times =
  [
    (* they meet at 4; what expires at that instant has expired *)
    case "a delay before a meeting"
      {|param d in [0, 8]
behaviour P on Cube = eps(d). <a, {right}>. nil
behaviour Q on Cube = <~a, {left}>. nil
process p = Cube mass 1 velocity (1,0,0) [P]
process q = Cube mass 1 at translate (6,0,0) [Q]
check bind : possibly bound(p, q)
check bounce : possibly event bounce(p, q)
|}
      [
        holds "bind" [ [ at_least_0 [ -1 ] (int 4) ] ] (q 1 2);
        holds "bounce" [ [ positive [ 1 ] (int (-4)) ] ] (q 1 2);
      ];
    case "two delays, one after the other"
      {|param d in [0, 4]
param e in [0, 4]
behaviour P on Cube = eps(d). eps(4 - e). <a, {right}>. nil
behaviour Q on Cube = <~a, {left}>. nil
process p = Cube mass 1 velocity (1,0,0) [P]
process q = Cube mass 1 at translate (6,0,0) [Q]
check bind : possibly bound(p, q)
|}
      [ holds "bind" [ [ at_least_0 [ -1; 1 ] Rat.zero ] ] (q 1 2) ];
    (* both ends have to be ready *)
    case "a reaction"
      {|param d in [0, 3]
param e in [0, 3]
behaviour P on Cube = eps(d). rho({<b, {right}>}). nil
behaviour Q on Cube = eps(e). rho({<b, {left}>}). nil
process pq = p : Cube mass 1 [P] <b, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Q]
check early : possibly (not bound(p, q)) within 2
check late  : possibly (bound(p, q) and time > 2) within 3
|}
      [
        holds "early" [ [ at_least_0 [ -1; 0 ] (int 2); at_least_0 [ 0; -1 ] (int 2) ] ] (q 4 9);
        holds "late" [ [ positive [ 1; 0 ] (int (-2)) ]; [ positive [ 0; 1 ] (int (-2)) ] ] (q 5 9);
      ];
    case "bounds of time"
      {|param g in [0, 6]
process p = Cube mass 1 velocity (1,0,0) [nil]
process q = Cube mass 1 at translate (2 + g,0,0) [nil]
check soon : possibly vx(q) = 1 within 4
check not_yet : always vx(q) = 0 within 4
check at4 : possibly (vx(q) = 1 and time <= 4)
|}
      [
        holds "soon" [ [ at_least_0 [ -1 ] (int 4) ] ] (q 2 3);
        holds "not_yet" [ [ positive [ 1 ] (int (-4)) ] ] (q 1 3);
        holds "at4" [ [ at_least_0 [ -1 ] (int 4) ] ] (q 2 3);
      ];
    case "between events"
      {|param x in [0, 4]
param y in [0, 4]
process p = Cube mass 1 velocity (1,0,0) at translate (x,y,0) [nil]
fixed wall = Cube at translate (8,0,0) [nil]
check passes : possibly x(p) > 6
check comes  : possibly x(p) = 6
check back   : possibly x(p) < 0
check stays  : always x(p) >= x(wall) - 8
|}
      [
        holds "passes" [ [ at_least_0 [ 0; 1 ] (int (-2)) ] ] (q 1 2);
        everywhere "comes";
        holds "back" [ [ positive [ 0; -1 ] (int 2) ] ] (q 1 2);
        holds "stays" [ [ at_least_0 [ 0; 1 ] (int (-2)) ] ] (q 1 2);
      ];
  ]

(* {1 Ties} *)

let ties =
  [
    (* one arrives at 2 + s, the other at (2 + t) / 2 *)
    case "a pocket and two ligands"
      {|param s in [0, 6]
param t in [0, 6]
behaviour Pocket on Cube = <a, {left, right}>. nil
behaviour L on Cube = <~a, {left, right}>. nil
fixed p = Cube [Pocket]
process one = Cube mass 1 velocity (1,0,0) at translate (-4 - s,0,0) [L]
process two = Cube mass 1 velocity (-2,0,0) at translate (4 + t,0,0) [L]
check first : possibly bound(p, one)
check surely : always not bound(p, two)
check either : (possibly bound(p, one)) and (possibly bound(p, two))
|}
      [
        holds "first" [ [ at_least_0 [ -2; 1 ] (int (-2)) ] ] (q 1 9);
        holds "surely" [ [ positive [ -2; 1 ] (int (-2)) ] ] (q 1 9);
        holds "either" [ [ is_0 [ -2; 1 ] (int (-2)) ] ] Rat.zero;
      ];
    (* who comes first drives the middle away, who comes second drives it back; at once they undo each other *)
    case "three on a line"
      {|param s in [1, 3]
param t in [1, 3]
process m = Cube mass 1 [nil]
process l = Cube mass 1 velocity (1,0,0) at translate (-2 - s,0,0) [nil]
process r = Cube mass 1 velocity (-1,0,0) at translate (2 + t,0,0) [nil]
check leftwards  : possibly x(m) < 0
check rightwards : possibly x(m) > 0
check still      : always x(m) = 0
|}
      [
        holds "leftwards" [ [ positive [ 1; -1 ] Rat.zero ] ] (q 1 2);
        holds "rightwards" [ [ positive [ -1; 1 ] Rat.zero ] ] (q 1 2);
        holds "still" [ [ is_0 [ 1; -1 ] Rat.zero ] ] Rat.zero;
      ];
    case "delays that end together"
      {|param d in [0, 2]
param e in [0, 2]
behaviour P on Cube = eps(d). rho({<b, {right}>}). nil + eps(e). nil
behaviour Q on Cube = rho({<b, {left}>}). nil
process pq = p : Cube mass 1 [P] <b, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Q]
check apart : possibly not bound(p, q)
|}
      [ everywhere "apart" ];
  ]

(* {1 Splits} *)

let dimer split ~arrival =
  Printf.sprintf
    {|split_step %s
param x in %s
behaviour P on Cube = omega(b, {right}). eps(1). <c, {front}>. nil
behaviour Q on Cube = omega(b, {left}). eps(2). <a, {back}>. nil
behaviour S on Cube = <~c, {back}>. nil
behaviour R on Cube = <~a, {front}>. nil
process pq = p : Cube mass 1 [P] <b, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Q]
process s = Cube mass 1 velocity (0,1,0) at translate (0,-17/4,0) [S]
process r = Cube mass 1 velocity (0,-1,0) at translate (2,2 + x,0) [R]
check both   : possibly (bound(p, s) and bound(q, r))
check p_only : possibly (bound(p, s) and not bound(q, r) and time > 5) within 6
check q_only : possibly (bound(q, r) and not bound(p, s) and time > 5) within 6
|}
    split arrival

(* s is there at 9/4, r at x. A split at tau opens p at tau + 1 and q at tau + 2. Later than 6, what
   bounced comes back. *)
let splits =
  [
    case "at any time" (dimer "any" ~arrival:"[2, 5]")
      [
        everywhere "both";
        holds "p_only" [ [ positive [ -1 ] (q 13 4) ] ] (q 5 12);
        holds "q_only" [ [ positive [ 1 ] (q (-13) 4) ] ] (q 7 12);
      ];
    (* tau is 0, 1, 2, ...: p is open in time for 0 and 1, q for all up to x - 2 *)
    case "on a grid" (dimer "1" ~arrival:"[2, 5]")
      [
        everywhere "both";
        holds "p_only" [ [ positive [ -1 ] (int 3) ] ] (q 1 3);
        holds "q_only" [ [ at_least_0 [ 1 ] (int (-4)) ] ] (q 1 3);
      ];
    (* p is struck between its release and its opening, which comes half a unit later *)
    case "struck in time"
      {|split_step 1
param g in [0, 4]
behaviour P on Cube = omega(b, {right}). eps(1/2). <c, {front}>. nil
behaviour Q on Cube = omega(b, {left}). nil
behaviour S on Cube = <~c, {back}>. nil
process pq = p : Cube mass 1 [P] <b, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Q]
process s = Cube mass 1 velocity (0,1,0) at translate (0,-2 - g,0) [S]
check alone : possibly (event bounce(p, s) and not bound(p, q)) within 4
|}
      [
        holds "alone"
          (List.init 5 (fun k -> from_to ~low:(int k) ~high:(Rat.add (int k) (q 1 2))))
          (q 1 2);
      ];
    case "struck in time, at any time"
      {|split_step any
param g in [0, 4]
behaviour P on Cube = omega(b, {right}). eps(1/2). <c, {front}>. nil
behaviour Q on Cube = omega(b, {left}). nil
behaviour S on Cube = <~c, {back}>. nil
process pq = p : Cube mass 1 [P] <b, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Q]
process s = Cube mass 1 velocity (0,1,0) at translate (0,-2 - g,0) [S]
check alone : possibly (event bounce(p, s) and not bound(p, q))
check binds : possibly bound(p, s)
|}
      [ everywhere "alone"; holds "binds" [ [ at_least_0 [ 1 ] (q (-1) 2) ] ] (q 7 8) ];
    (* when a second bond can be released, at d, the clock begins anew: instants are 0, d, d + 1 *)
    case "a clock that begins anew"
      {|split_step 1
param d in [0, 1]
behaviour P on Cube = omega(b, {right}). nil
behaviour Q on Cube = omega(b, {left}). nil + eps(d). omega(c, {right}). nil
behaviour R on Cube = omega(c, {left}). nil
process pqr = p : Cube mass 1 [P] <b, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Q]
  <c, {q.right, r.left}> r : Cube mass 1 at translate (4,0,0) [R]
check at_1 : possibly (event weak(b) and time = 1) within 1
|}
      [ holds "at_1" [ [ is_0 [ 1 ] Rat.zero ]; [ is_0 [ 1 ] (int (-1)) ] ] Rat.zero ];
  ]

(* p hits its wall after 2 + g, and r its own after 4: which comes first, or either at g = 2. *)
let next =
  [
    case "what is next"
      {|param g in [0, 4]
fixed east = Cube at translate (4 + g,0,0)
fixed north = Cube at translate (0,26,0)
process p = Cube mass 1 velocity (1,0,0) at translate (0,0,0) [nil]
process r = Cube mass 1 velocity (0,1,0) at translate (0,20,0) [nil]
check some   : EX event bounce(p, east)
check all    : AX event bounce(p, east)
check second : EX EX event bounce(p, east)
check third  : EX EX EX true
check later  : E[x(p) < 1 U x(p) >= 1 and EX event bounce(p, east)]
check inside : AG (x(p) > 1 and x(p) < 2 and vx(p) > 0 => AX event bounce(p, east))
|}
      [
        holds "some" [ [ at_least_0 [ -1 ] (int 2) ] ] (q 1 2);
        holds "all" [ [ positive [ -1 ] (int 2) ] ] (q 1 2);
        holds "second" [ [ at_least_0 [ 1 ] (int (-2)) ] ] (q 1 2);
        nowhere "third";
        holds "later" [ [ at_least_0 [ -1 ] (int 2) ] ] (q 1 2);
        holds "inside" [ [ positive [ -1 ] (int 2) ] ] (q 1 2);
      ];
  ]

let suite =
  ("sets of parameters by hand",
   [
     ("meetings", meetings); ("times", times); ("ties", ties); ("splits", splits); ("next", next);
     ("runs", Runs_by_hand.cases);
   ])
